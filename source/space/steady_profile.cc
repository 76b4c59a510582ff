// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/direct_solver.h>
#include <thermocontact/space/steady_profile.h>

#include <deal.II/base/function.h>

#include <deal.II/numerics/vector_tools_interpolate.h>

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
        , solver(matrix())
      {}

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
        solver.solve(correction, residual);
        stage_operator.zero_constrained(Field::temperature, correction);
        profile += correction;
      }

    private:
      const SceneHeat                       &heat;
      const ContactEnd<dim>                 &end;
      const IndexSet                        &owned;
      const ThermoviscoelasticOperator<dim> &stage_operator;
      const Loads<dim>                      &loads;
      DirectSolver                           solver;

      /** With the $k_s$ of the nodes where the matrices have no exchange. */
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
