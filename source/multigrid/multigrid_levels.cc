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
          mesh.cells_across = mesh.n_cells_across() / 2;
          mesh.cells /= 2;
        }
      else
        return {};
      return coarse;
    }



    /** Matrices up to this size are factorised; factors of blocks fill. */
    template <int dim>
    constexpr types::global_dof_index max_factorized = dim == 2 ? 6000 : 2000;



    /**
     * The scenes of all levels but the finest, the coarsest first.
     *
     * @param is_body the body itself, once more
     */
    std::vector<Parameters>
    coarse_scenes(const Scene &scene, const bool is_body)
    {
      Parameters finest           = scene.parameters;
      finest.solver.linear_solver = "iterative";

      std::vector<Parameters> result;
      for (std::optional<Parameters> next = is_body ? std::nullopt :
                                                      coarsened(finest);
           next;
           next = coarsened(*next))
        {
          // A coarse node stands for nodes with mass, too: without, residuals
          // of those would move it without resistance in a short stage
          next->contact.massless_nodes = "off";
          result.insert(result.begin(), *next);
        }
      if (result.empty())
        {
          result.push_back(finest);
          // refined from the same cells as the body, which a transfer needs
          MeshParameters    &mesh = result.back().mesh;
          const unsigned int n    = mesh.n_halvings();
          mesh.cells_across       = mesh.n_cells_across() >> n;
          mesh.cells >>= n;
          mesh.refinements += n;
          result.back().contact.massless_nodes =
            scene.contact.has_massless_nodes ? "on" : "off";
        }
      result.front().solver.linear_solver = "direct";
      return result;
    }
  } // namespace



  template <int dim, typename Number>
  MultigridLevels<dim, Number>::MultigridLevels(const Body<dim> &body,
                                                const bool has_factors_of_body)
    : body(body)
    , has_factors_of_body_(has_factors_of_body)
  {
    const std::vector<Parameters> scenes =
      coarse_scenes(body.scene, has_factors_of_body);
    levels = std::vector<Level>(scenes.size() + 1);
    make_level(scenes[0], levels[0]);
    coarse_operator_ = std::make_unique<const ThermoviscoelasticOperator<dim>>(
      *levels[0].own_scene, *levels[0].discretization);
    make_coarse_vectors(levels[0]);
    for (unsigned int l = 1; l < levels.size(); ++l)
      {
        Level &level = levels[l];
        if (l < scenes.size())
          make_level(scenes[l], level);
        else
          {
            level.discretization = &body.discretization;
            level.spaces         = &body.discretization.matrix_free();
            compute_diagonals(level, body.scene, *body.equations.matrix_free());
          }
        make_vectors(level);
        connect(levels[l - 1], level);
      }
  }



  template <int dim, typename Number>
  bool
  MultigridLevels<dim, Number>::is_factorised(
    const types::global_dof_index n_rows) const
  {
    return has_factors_of_body_ || n_rows <= max_factorized<dim>;
  }



  template <int dim, typename Number>
  void
  MultigridLevels<dim, Number>::make_level(const Parameters &parameters,
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
    compute_diagonals(level,
                      *level.own_scene,
                      MatrixFreeOperator<dim>(*level.own_scene,
                                              *level.discretization));
  }



  template <int dim, typename Number>
  void
  MultigridLevels<dim, Number>::make_coarse_vectors(Level &level) const
  {
    for (const Field::Block field : all_fields)
      if (level.discretization->has_field(field))
        {
          LevelField<dim, Number> &of_field = level.fields[field];
          of_field.coarse_right             = level.spaces->make_vector(field);
          of_field.coarse_solution          = of_field.coarse_right;
          of_field.right.reinit(of_field.coarse_right.get_partitioner());
          of_field.solution = of_field.right;
        }
  }



  template <int dim, typename Number>
  void
  MultigridLevels<dim, Number>::make_vectors(Level &level) const
  {
    for (const Field::Block field : all_fields)
      if (level.discretization->has_field(field))
        {
          LevelField<dim, Number> &of_field = level.fields[field];
          of_field.right    = level.products->make_vector(field);
          of_field.solution = of_field.right;
          of_field.residual = of_field.right;
          of_field.update   = of_field.right;
        }
  }



  template <int dim, typename Number>
  void
  MultigridLevels<dim, Number>::compute_diagonals(
    Level                         &level,
    const Scene                   &scene,
    const MatrixFreeOperator<dim> &products) const
  {
    level.products =
      std::make_unique<const LevelProducts<dim, Number>>(scene,
                                                         *level.discretization,
                                                         products);
    if (body.scene.fields.has_temperature)
      {
        LevelField<dim, Number> &heat = level.fields[Field::temperature];
        heat.mass                     = heat.stiffness =
          level.products->make_vector(Field::temperature);
        copy_values(heat.mass, products.heat_diagonal({1., 0.}));
        copy_values(heat.stiffness, products.heat_diagonal({0., 1.}));
      }
    if (body.scene.fields.has_displacement)
      {
        LevelField<dim, Number> &momentum = level.fields[Field::displacement];
        momentum.mass                     = momentum.stiffness =
          level.products->make_vector(Field::displacement);
        copy_values(momentum.mass, products.momentum_diagonal({1., 0.}));
        copy_values(momentum.stiffness, products.momentum_diagonal({0., 1.}));
      }
  }



  template <int dim, typename Number>
  void
  MultigridLevels<dim, Number>::connect(const Level &coarse, Level &fine) const
  {
    const auto constraints = [](const Level &level, const Field::Block field) {
      AffineConstraints<Number> result;
      result.copy_from(level.spaces->constraints(field));
      return result;
    };
    for (const Field::Block field : all_fields)
      if (fine.discretization->has_field(field))
        fine.fields[field].transfer.reinit(fine.spaces->dof_handler(field),
                                           coarse.spaces->dof_handler(field),
                                           constraints(fine, field),
                                           constraints(coarse, field));
  }



  template class MultigridLevels<2, float>;
  template class MultigridLevels<2, double>;
  template class MultigridLevels<3, float>;
  template class MultigridLevels<3, double>;
} // namespace ThermoContact
