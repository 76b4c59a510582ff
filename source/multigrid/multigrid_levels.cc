// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/multigrid/multigrid_levels.h>

#include <optional>

namespace ThermoContact
{
  namespace
  {
    /** The next coarser mesh of the scene, if there is one. */
    std::optional<Parameters>
    coarsened(const Parameters &fine)
    {
      Parameters      coarse = fine;
      MeshParameters &mesh   = coarse.mesh;
      if (mesh.degree > 1)
        mesh.degree /= 2;
      else if (mesh.refinements > 0)
        --mesh.refinements;
      else if (mesh.n_halvings() > 0)
        {
          mesh.cells /= 2;
          mesh.cells_across /= 2;
        }
      else
        return {};
      return coarse;
    }



    /** The scenes of all levels but the finest, the coarsest first. */
    std::vector<Parameters>
    coarse_scenes(const Scene &scene)
    {
      Parameters finest           = scene.parameters;
      finest.solver.linear_solver = "iterative";

      std::vector<Parameters> result;
      for (std::optional<Parameters> next = coarsened(finest); next;
           next                           = coarsened(*next))
        {
                                    // A coarse node stands for nodes with mass, too: without, residuals
          // of those would move it without resistance in a short stage
          next->contact.massless_nodes = "off";
          result.insert(result.begin(), *next);
        }
      if (result.empty())
        {
          result.push_back(finest);
          result.back().contact.massless_nodes =
            scene.contact.has_massless_nodes ? "on" : "off";
        }
      result.front().solver.linear_solver = "direct";
      return result;
    }
  } // namespace



  template <int dim>
  MultigridLevels<dim>::MultigridLevels(const Body<dim> &body)
    : body(body)
  {
    const std::vector<Parameters> scenes = coarse_scenes(body.scene);
    levels = std::vector<Level>(scenes.size() + 1);
    for (unsigned int l = 0; l < scenes.size(); ++l)
      make_level(scenes[l], levels[l]);
    levels.back().discretization = &body.discretization;
    levels.back().spaces         = &body.discretization.matrix_free();
    levels.back().products       = body.equations.matrix_free();
    coarse_operator_ = std::make_unique<const ThermoviscoelasticOperator<dim>>(
      *levels[0].own_scene, *levels[0].discretization);
    make_vectors(levels[0]);
    for (unsigned int l = 1; l < levels.size(); ++l)
      {
        make_vectors(levels[l]);
        compute_diagonals(levels[l]);
        connect(levels[l - 1], levels[l]);
      }
  }



  template <int dim>
  void
  MultigridLevels<dim>::make_level(const Parameters &parameters,
                                   Level            &level) const
  {
    level.own_scene          = std::make_unique<const Scene>(parameters);
    level.own_discretization = std::make_unique<const Discretization<dim>>(
      *level.own_scene, body.discretization.communicator());
    level.discretization = level.own_discretization.get();
    if (level.own_scene->linear_solver.has_matrices())
      {
        level.own_spaces =
          std::make_unique<const MatrixFreeSpaces<dim>>(*level.discretization);
        level.spaces = level.own_spaces.get();
        return;
      }
    level.spaces = &level.discretization->matrix_free();
    level.own_products =
      std::make_unique<const MatrixFreeOperator<dim>>(*level.own_scene,
                                                      *level.discretization);
    level.products = level.own_products.get();
  }



  template <int dim>
  void
  MultigridLevels<dim>::make_vectors(Level &level) const
  {
    for (const Field::Block field : all_fields)
      if (level.discretization->has_field(field))
        {
          LevelField<dim> &of_field = level.fields[field];
          of_field.right            = level.spaces->make_vector(field);
          of_field.solution         = of_field.right;
          of_field.residual         = of_field.right;
        }
  }



  template <int dim>
  void
  MultigridLevels<dim>::compute_diagonals(Level &level) const
  {
    const MatrixFreeOperator<dim> &products = *level.products;
    if (body.scene.fields.has_temperature)
      {
        LevelField<dim> &heat = level.fields[Field::temperature];
        heat.mass             = products.heat_diagonal({1., 0.});
        heat.stiffness        = products.heat_diagonal({0., 1.});
      }
    if (body.scene.fields.has_displacement)
      {
        LevelField<dim> &momentum = level.fields[Field::displacement];
        momentum.mass             = products.momentum_diagonal({1., 0.});
        momentum.stiffness        = products.momentum_diagonal({0., 1.});
      }
  }



  template <int dim>
  void
  MultigridLevels<dim>::connect(const Level &coarse, Level &fine) const
  {
    for (const Field::Block field : all_fields)
      if (fine.discretization->has_field(field))
        fine.fields[field].transfer.reinit(fine.spaces->dof_handler(field),
                                           coarse.spaces->dof_handler(field),
                                           fine.spaces->constraints(field),
                                           coarse.spaces->constraints(field));
  }



  template class MultigridLevels<2>;
  template class MultigridLevels<3>;
} // namespace ThermoContact
