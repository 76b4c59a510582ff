// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/space/direct_solver.h>
#include <thermocontact/space/matrix_free_operator.h>
#include <thermocontact/space/steady_profile.h>

#include <deal.II/base/function.h>

#include <deal.II/lac/diagonal_matrix.h>

#include <deal.II/numerics/vector_tools_interpolate.h>

#include <memory>

namespace ThermoContact
{
  namespace
  {
    /** $\theta_s$ of (M2.1) in the first component. */
    template <int dim>
    class LinearProfile : public Function<dim>
    {
    public:
      LinearProfile(const unsigned int n_components, const SceneHeat &heat)
        : Function<dim>(n_components)
        , heat(heat)
      {}

      double
      value(const Point<dim> &point, const unsigned int c) const override
      {
        return c == 0 ? heat.steady_temperature(point[0]) : 0.;
      }

    private:
      const SceneHeat &heat;
    };



    /** The equation (M5.7), solved from a profile with the right fixed end. */
    template <int dim>
    class RestEquation
    {
    public:
      RestEquation(const Scene                           &scene,
                   const Discretization<dim>             &discretization,
                   const ThermoviscoelasticOperator<dim> &stage_operator,
                   const Loads<dim>                      &loads)
        : heat(scene.heat)
        , end(discretization.contact_end())
        , owned(discretization.owned_by_block()[Field::temperature])
        , stage_operator(stage_operator)
        , loads(loads)
      {
        if (scene.linear_solver.has_matrices())
          factors = std::make_unique<DirectSolver>(matrix());
        else if constexpr (dim > 1)
          {
            inverse_diagonal =
              stage_operator.matrix_free()->heat_diagonal({0., 1.});
            Vector ones(inverse_diagonal);
            ones = 1.;
            add_exchange(ones, inverse_diagonal);
            for (double &entry : inverse_diagonal)
              entry = 1. / entry;
          }
      }

      /** Adds the correction that the residual of @p profile asks for. */
      void
      correct(Vector &profile)
      {
        Vector residual(profile), correction(profile);
        stage_operator.conduction().vmult(residual, profile);
        residual.sadd(-1., loads.outer_heat());
        if (!heat.exchange->is_constant())
          subtract_exchange(profile, residual);
        stage_operator.zero_constrained(Field::temperature, residual);
        if (factors)
          factors->solve(correction, residual);
        else
          {
            correction = 0.;
            if (residual.linfty_norm() > 0.)
              conjugate_gradients("the steady profile",
                                  *this,
                                  correction,
                                  residual,
                                  DiagonalMatrix<Vector>(inverse_diagonal),
                                  Tolerances::rounding_of_solution,
                                  100000);
          }
        stage_operator.zero_constrained(Field::temperature, correction);
        profile += correction;
      }

      /** The product of the conjugate gradients. */
      void
      vmult(Vector &y, const Vector &x) const
      {
        stage_operator.conduction().vmult(y, x);
        add_exchange(x, y);
        stage_operator.zero_constrained(Field::temperature, y);
      }

    private:
      const SceneHeat                       &heat;
      const ContactEnd<dim>                 &end;
      const IndexSet                        &owned;
      const ThermoviscoelasticOperator<dim> &stage_operator;
      const Loads<dim>                      &loads;
      std::unique_ptr<DirectSolver>          factors;
      Vector                                 inverse_diagonal; ///< or that

      /** Adds the $k_s$ of the nodes where the matrices have no exchange. */
      void
      add_exchange(const Vector &x, Vector &y) const
      {
        if (heat.exchange->is_constant())
          return;
        for (const auto &[node, entry] : end.entries(Field::temperature))
          y.local_element(entry) += heat.reference_coefficient *
                                    end.nodes()[node].weight *
                                    x.local_element(entry);
      }

      /** With that exchange. */
      SparseMatrix
      matrix() const
      {
        SparseMatrix result = stage_operator.conduction_matrix();
        if (!heat.exchange->is_constant())
          {
            for (const auto &[node, entry] : end.entries(Field::temperature))
              {
                const auto dof = owned.nth_index_in_set(entry);
                result.add(dof,
                           dof,
                           heat.reference_coefficient *
                             end.nodes()[node].weight);
              }
            result.compress(VectorOperation::add);
          }
        return result;
      }

      /** Takes the fluxes into the obstacle from a residual. */
      void
      subtract_exchange(const Vector &profile, Vector &residual) const
      {
        std::vector<double> fluxes;
        end.get_values(Field::temperature, profile, fluxes);
        for (double &value : fluxes)
          value = heat.flux(heat.reference_coefficient, value);
        end.subtract_load(Field::temperature, fluxes, 1., residual);
      }
    };
  } // namespace



  template <int dim>
  void
  set_steady_profile(const Scene                           &scene,
                     const Discretization<dim>             &discretization,
                     const ThermoviscoelasticOperator<dim> &stage_operator,
                     const Loads<dim>                      &loads,
                     Vector                                &profile)
  {
    SystemVector system = discretization.make_system_vector();
    Vector       other  = discretization.make_vector(Field::displacement);
    VectorTools::interpolate(discretization.mapping(),
                             discretization.dof_handler(),
                             LinearProfile<dim>(discretization.n_components(),
                                                scene.heat),
                             system);
    discretization.split(system, profile, other);
    if (!scene.heat.has_lateral_exchange())
      return;
    RestEquation<dim> equation(scene, discretization, stage_operator, loads);
    equation.correct(profile);
    equation.correct(profile); // of the rounding of the first solution
  }



#define INSTANTIATE(dim)                     \
  template void set_steady_profile<dim>(     \
    const Scene &,                           \
    const Discretization<dim> &,             \
    const ThermoviscoelasticOperator<dim> &, \
    const Loads<dim> &,                      \
    Vector &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
