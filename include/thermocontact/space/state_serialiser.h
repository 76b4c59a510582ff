// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_state_serialiser_h
#define thermocontact_space_state_serialiser_h

#include <thermocontact/space/discretization.h>
#include <thermocontact/space/state.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ThermoContact
{
  /**
   * The vectors of states node by node, under numbers that do not depend on
   * the ranks that share the body: a state saved by some ranks can be restored
   * by others.
   *
   * A node is a support point of the finite element space, with all its degrees
   * of freedom. Its number is that of the first cell around it, of the
   * uniformly refined coarsest mesh, and its place in that cell.
   */
  template <int dim>
  class StateSerialiser
  {
  public:
    /** @param discretization borrowed */
    explicit StateSerialiser(const Discretization<dim> &discretization);

    /** The nodes that this rank owns: their numbers, then their values. */
    std::string
    save(const State &state) const;

    /**
     * Sets the values that are in @p saved, of any rank, of nodes that this
     * rank owns.
     *
     * @return number of nodes that were set
     * @throw std::length_error if @p saved is of another discretisation
     */
    std::size_t
    restore(const std::string &saved, State &state) const;

    /** Number of nodes in what save() gave on some rank. */
    std::size_t
    n_nodes_of(const std::string &saved) const
    {
      return saved.size() / size_of_node();
    }

    /** Number of nodes that this rank owns. */
    std::size_t
    n_nodes() const
    {
      return nodes.size();
    }

  private:
    /** Its number; positions in the local part of the vectors. */
    struct Node
    {
      std::uint64_t                 number;
      unsigned int                  temperature;
      std::array<unsigned int, dim> displacement;
    };

    const bool         has_temperature;
    const bool         has_displacement;
    const unsigned int n_values; ///< of one node
    std::vector<Node>  nodes;    ///< in the order of their numbers

    /** Bytes of its number and its values. */
    std::size_t
    size_of_node() const
    {
      return sizeof(std::uint64_t) + n_values * sizeof(double);
    }

    /** Calls visit(value) for each value of a node, in order. */
    template <typename SomeState, typename Visit>
    void
    for_each_value(const Node  &node,
                   SomeState   &state,
                   const Visit &visit) const;
  };
} // namespace ThermoContact

#endif
