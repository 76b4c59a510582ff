// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_discretization_h
#define thermocontact_space_discretization_h

#include <thermocontact/base/types.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/space/state.h>

#include <deal.II/base/index_set.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values_extractors.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /** A node of the contact end, which can meet the obstacle. */
  template <int dim>
  struct ContactNode
  {
    Point<dim> position;

    /**
     * Temperature and normal displacement there, each within its block;
     * invalid for a field that the scene does not have.
     */
    std::array<types::global_dof_index, 2> dofs;

    /** $w_i=\int_{\Gamma_C}\varphi_i$, the lumped boundary mass. */
    double weight;
  };



  /**
   * Mesh, finite element space and constraints of the body
   * $(0,1)\times(0,\text{width})^{dim-1}$.
   *
   * One DoFHandler for the FESystem of temperature and displacement, numbered
   * by field: block 0 is the temperature, block 1 the displacement. A field
   * that the scene does not have is absent from the FESystem, and its block is
   * empty. The constraints are those of rates: homogeneous, temperature and
   * displacement at the fixed end, normal displacement at rollers.
   */
  template <int dim>
  class Discretization
  {
  public:
    Discretization(const Parameters &parameters, const MPI_Comm communicator);

    MPI_Comm
    communicator() const
    {
      return communicator_;
    }

    const DoFHandler<dim> &
    dof_handler() const
    {
      return dof_handler_;
    }

    const FiniteElement<dim> &
    finite_element() const
    {
      return finite_element_;
    }

    const Mapping<dim> &
    mapping() const
    {
      return mapping_;
    }

    /** False if block 0 (temperature) or 1 (displacement) is empty. */
    bool
    has_field(const unsigned int block) const
    {
      return owned_by_block_[block].size() > 0;
    }

    /** Number of components of the FESystem. */
    unsigned int
    n_components() const
    {
      return finite_element_.n_components();
    }

    /** First component of a field that the scene has. */
    unsigned int
    first_component(const unsigned int block) const
    {
      return block == 1 && has_field(0) ? 1 : 0;
    }

    FEValuesExtractors::Scalar
    temperature_extractor() const
    {
      return FEValuesExtractors::Scalar(first_component(0));
    }

    FEValuesExtractors::Vector
    displacement_extractor() const
    {
      return FEValuesExtractors::Vector(first_component(1));
    }

    unsigned int
    degree() const
    {
      return finite_element_.degree;
    }

    /** Constraints of rates in the numbering of the whole system. */
    const AffineConstraints<double> &
    constraints() const
    {
      return constraints_;
    }

    /** Locally owned indices of the whole system. */
    const IndexSet &
    owned() const
    {
      return owned_;
    }

    /** Locally relevant indices of the whole system. */
    const IndexSet &
    relevant() const
    {
      return relevant_;
    }

    /** Locally owned and locally relevant indices within each block. */
    const std::vector<IndexSet> &
    owned_by_block() const
    {
      return owned_by_block_;
    }

    const std::vector<IndexSet> &
    relevant_by_block() const
    {
      return relevant_by_block_;
    }

    types::global_dof_index
    n_temperature_dofs() const
    {
      return owned_by_block_[0].size();
    }

    types::global_dof_index
    n_displacement_dofs() const
    {
      return owned_by_block_[1].size();
    }

    unsigned int
    n_active_cells() const
    {
      return triangulation->n_global_active_cells();
    }

    /** Nodes of the contact end in order of their position; on all ranks. */
    const std::vector<ContactNode<dim>> &
    contact_nodes() const
    {
      return contact_nodes_;
    }

    /**
     * Locally owned contact nodes of a block: index of the node, position in
     * the local part of the block's vectors.
     */
    const std::vector<std::pair<unsigned int, unsigned int>> &
    contact_entries(const unsigned int block) const
    {
      return contact_entries_[block];
    }

    /**
     * Values of a field at the contact nodes, gathered on all ranks.
     *
     * @param block 0: @p field is a temperature; 1: the normal component of a
     *   displacement or velocity is taken
     * @param values out: one per contact node; zeros if the field is absent
     */
    void
    contact_values(const unsigned int   block,
                   const Vector        &field,
                   std::vector<double> &values) const;

    /** Mean over the contact end of a field with these nodal values. */
    double
    contact_mean(const std::vector<double> &values) const;

    /** Area of the contact end (1 in 1-D), by which results are scaled. */
    double
    cross_section() const
    {
      return cross_section_;
    }

    /**
     * Locally owned degrees of freedom of a block whose rate vanishes.
     */
    const IndexSet &
    constrained(const unsigned int block) const
    {
      return constrained_[block];
    }

    /** Their positions within the locally owned part of the block. */
    const std::vector<unsigned int> &
    constrained_entries(const unsigned int block) const
    {
      return constrained_entries_[block];
    }

    /**
     * A vector of zeros for one field (block 0: temperature, 1: displacement)
     * or for the whole system. All of them share one map, which makes their
     * assignment a copy instead of an import.
     */
    Vector
    make_vector(const unsigned int block) const
    {
      return prototypes[block];
    }

    Vector
    make_system_vector() const
    {
      return system_prototype;
    }

    /** A state of zeros. */
    State
    make_state() const;

    /**
     * Concatenates both blocks into one vector of the whole system; local copy
     * without communication.
     */
    void
    join(const Vector &temperature,
         const Vector &displacement,
         Vector       &system) const;

    /** The reverse of join(). */
    void
    split(const Vector &system,
          Vector       &temperature,
          Vector       &displacement) const;

  private:
    const MPI_Comm communicator_;
    const std::unique_ptr<typename DimensionTraits<dim>::Triangulation>
                                  triangulation;
    const FESystem<dim>           finite_element_;
    const MappingQ<dim>           mapping_;
    DoFHandler<dim>               dof_handler_;
    AffineConstraints<double>     constraints_;
    IndexSet                      owned_;
    IndexSet                      relevant_;
    std::vector<IndexSet>         owned_by_block_;
    std::vector<IndexSet>         relevant_by_block_;
    std::vector<Vector>           prototypes;
    Vector                        system_prototype;
    std::vector<ContactNode<dim>> contact_nodes_;

    /** Contact node and position in the local part, per block. */
    std::array<std::vector<std::pair<unsigned int, unsigned int>>, 2>
           contact_entries_;
    double cross_section_;

    std::vector<IndexSet>                  constrained_;
    std::vector<std::vector<unsigned int>> constrained_entries_;

    void
    make_grid(const MeshParameters &mesh);

    void
    distribute_dofs(const ModelParameters &model);

    void
    make_constraints(const bool has_rollers);

    void
    find_contact_nodes();
  };
} // namespace ThermoContact

#endif
