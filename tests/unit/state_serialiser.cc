// SPDX-License-Identifier: LGPL-2.1-or-later
//
// States saved by some ranks and restored by others, on two ranks. The state
// that is saved has the values of three functions of the place, different for
// each component: theta = 1 + x + 10 y + 100 z, u_d = (d + 2) theta, v = -u.
// What is restored must have them at each support point, exactly, since both
// are computed at the same points to the same bits but for the order of sums:
// to 1e-13.
//
// Saved by both ranks together and by one alone, restored by each of them alone
// and by both. Meshes: cells of different sizes along the body and across,
// refined once; a rod; a scene of one field. Nodes are counted once: (n p + 1)
// along each direction with n cells. A part of another mesh is refused, or too
// few of its nodes are found.

#include <thermocontact/base/dealii_versions.h>
#include <thermocontact/space/state_serialiser.h>

#include <deal.II/base/mpi.h>

#include <cmath>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  double
  theta(const Point<3> &p)
  {
    return 1. + p[0] + 10. * p[1] + 100. * p[2];
  }



  /** Calls visit(vector, entry, value) for each entry that this rank owns. */
  template <int dim, typename Visit>
  void
  for_each_entry(const Discretization<dim> &space,
                 State                     &state,
                 const Visit               &visit)
  {
    const auto points = support_points(space.mapping(), space.dof_handler());
    const FiniteElement<dim>            &fe = space.finite_element();
    std::vector<types::global_dof_index> dofs(fe.dofs_per_cell);
    for (const auto &cell : space.dof_handler().active_cell_iterators())
      {
        if (!cell->is_locally_owned())
          continue;
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const unsigned int c = fe.system_to_component_index(i).first;
            const bool is_heat = space.has_field(Field::temperature) && c == 0;
            const Field::Block field =
              is_heat ? Field::temperature : Field::displacement;
            const auto      dof   = dofs[i] - space.first_dof(field);
            const IndexSet &owned = space.owned_by_block()[field];
            if (!owned.is_element(dof))
              continue;
            Point<3> point;
            for (unsigned int d = 0; d < dim; ++d)
              point[d] = points.at(dofs[i])[d];
            const auto   entry = owned.index_within_set(dof);
            const double u =
              (c - space.first_component(Field::displacement) + 2.) *
              theta(point);
            if (is_heat)
              visit(state.temperature, entry, theta(point));
            else
              {
                visit(state.displacement, entry, u);
                visit(state.velocity, entry, -u);
              }
          }
      }
  }



  /** What all ranks of @p space save, part after part. */
  template <int dim>
  std::vector<std::string>
  save(const Discretization<dim> &space)
  {
    State state = space.make_state();
    for_each_entry(space,
                   state,
                   [](ThermoContact::Vector &vector, auto i, double value) {
                     vector.begin()[i] = value;
                   });
    return Utilities::MPI::all_gather(space.communicator(),
                                      StateSerialiser<dim>(space).save(state));
  }



  /** The largest error after restoring; infinite if nodes are missing. */
  template <int dim>
  double
  error_of_restored(const Discretization<dim>      &space,
                    const std::vector<std::string> &parts)
  {
    const StateSerialiser<dim> values(space);
    State                      state = space.make_state();
    std::size_t                n_set = 0;
    for (const std::string &part : parts)
      n_set += values.restore(part, state);
    double error = n_set == values.n_nodes() ? 0. : INFINITY;
    for_each_entry(
      space, state, [&](ThermoContact::Vector &vector, auto i, double value) {
        raise(error, std::abs(vector.begin()[i] - value) / std::abs(value));
      });
    return Utilities::MPI::max(error, MPI_COMM_WORLD);
  }



  template <int dim>
  void
  test(const std::string &name, std::vector<std::string> overrides)
  {
    overrides.push_back("Dimension=" + std::to_string(dim));
    const Scene               scene(read_parameters("", overrides));
    const Discretization<dim> alone(scene, MPI_COMM_SELF);
    const Discretization<dim> together(scene, MPI_COMM_WORLD);
    const auto                by_one  = save(alone);
    const auto                by_both = save(together);
    std::size_t               n_saved = 0;
    for (const std::string &part : by_both)
      n_saved += StateSerialiser<dim>(together).n_nodes_of(part);
    deallog << name << ": nodes "
            << (dim == 1 ? StateSerialiser<dim>(alone).n_nodes() : n_saved)
            << ", errors below 1e-13";
    for (const Discretization<dim> *space : {&alone, &together})
      for (const auto *parts : {&by_one, &by_both})
        deallog << ' ' << within(error_of_restored(*space, *parts), 1e-13);
    deallog << std::endl;
  }



  void
  test_refusals()
  {
    const auto space = [](const std::string &cells, const std::string &fields) {
      static std::vector<std::unique_ptr<Scene>> scenes;
      scenes.push_back(
        std::make_unique<Scene>(read_parameters("",
                                                {"Dimension=2",
                                                 "Mesh/Degree=2",
                                                 "Mesh/Cells=" + cells,
                                                 "Model/Fields=" + fields})));
      return std::make_unique<Discretization<2>>(*scenes.back(), MPI_COMM_SELF);
    };
    const std::string both = "temperature and displacement";
    const auto        four = space("4", both), five = space("5", both);
    deallog << "of a shorter mesh: all found "
            << std::isfinite(error_of_restored(*five, save(*four)))
            << ", of a longer one: as many "
            << (StateSerialiser<2>(*four).n_nodes_of(save(*five)[0]) ==
                StateSerialiser<2>(*four).n_nodes())
            << std::endl;
    try
      {
        error_of_restored(*four, {save(*four)[0] + "x"});
      }
    catch (const std::length_error &error)
      {
        deallog << "a byte more: " << error.what() << std::endl;
      }
  }
} // namespace



void
main_state_serialiser()
{
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    initlog();
  const std::vector<std::string> graded = {"Mesh/Cells=3",
                                           "Mesh/Cells across=2",
                                           "Mesh/Width=0.4",
                                           "Mesh/Degree=3",
                                           "Mesh/Grading=3",
                                           "Mesh/Grading across=2",
                                           "Mesh/Refinements=1"};
  test<1>("rod", {"Mesh/Cells=3", "Mesh/Degree=3", "Mesh/Refinements=1"});
  test<2>("strip", graded);
  test<3>("block", graded);
  std::vector<std::string> displacement(graded);
  displacement.push_back("Model/Fields=displacement");
  test<2>("strip without heat", displacement);
  std::vector<std::string> heat(graded);
  heat.push_back("Model/Fields=temperature");
  test<2>("strip of heat alone", heat);
  test_refusals();
}
