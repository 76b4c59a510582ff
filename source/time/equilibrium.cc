// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/interface_problem.h>
#include <thermocontact/space/conjugate_gradients.h>
#include <thermocontact/space/direct_solver.h>
#include <thermocontact/time/equilibrium.h>
#include <thermocontact/time/iterative_solver.h>

#include <deal.II/lac/diagonal_matrix.h>

namespace ThermoContact
{
  namespace
  {
    /** By factors and responses to unit pressures. */
    template <int dim>
    class DirectEquilibrium : public Equilibrium<dim>
    {
    public:
      using Matrix = typename Equilibrium<dim>::Matrix;

      DirectEquilibrium(const Body<dim> &body,
                        const Matrix     matrix,
                        SolverCounters  &counters)
        : body(body)
        , kind(matrix)
        , counters(counters)
      {}

      void
      provide() override
      {
        if (factors)
          return;
        // a stage without length has bM_u, one of length 1 without inertia the
        // sum of elastic and viscous stiffness
        auto made =
          std::make_unique<DirectSolver>(body.equations.momentum_stage_matrix(
            kind == Matrix::inertia ? 0. : 1.));
        ++counters.factorizations;
        if (body.law().is_active())
          make_responses(*made);
        factors = std::move(made);
      }

      bool
      is_provided() const override
      {
        return factors != nullptr;
      }

      void
      solve(const Vector               *forces,
            const std::vector<NodeLaw> &laws,
            const std::vector<double>  &position,
            const double                factor,
            Vector                     &y,
            std::vector<double>        &pressure) override
      {
        provide();
        if (forces != nullptr)
          factors->solve(y, *forces);
        else
          y = 0.;
        if (laws.empty() || !body.law().is_active())
          return;
        std::vector<double> free;
        body.contact_end().get_values(Field::displacement, y, free);
        for (unsigned int i = 0; i < free.size(); ++i)
          free[i] = position[i] + factor * free[i];
        FullMatrix<double> response(receptance);
        response *= factor;
        InterfaceProblem().solve(response, laws, free, pressure);
        for (unsigned int i = 0; i < pressure.size(); ++i)
          y.add(-pressure[i], unit_responses[i]);
      }

    private:
      const Body<dim>              &body;
      const Matrix                  kind;
      SolverCounters               &counters;
      std::unique_ptr<DirectSolver> factors;
      std::vector<Vector>           unit_responses; ///< to pressures
      FullMatrix<double>            receptance;     ///< of the contact nodes

      void
      make_responses(DirectSolver &made)
      {
        const ContactEnd<dim> &end = body.contact_end();
        Vector unit_load = body.discretization.make_vector(Field::displacement);
        unit_responses.clear();
        receptance =
          end.response_matrix([&](const unsigned int node) -> const Vector & {
            end.set_load_of_node(Field::displacement, node, 1., unit_load);
            Vector &response = unit_responses.emplace_back(unit_load);
            made.solve(response, unit_load);
            ++counters.responses;
            return response;
          });
      }
    };



    /**
     * Without matrices. Only the levels are kept, and preconditioners made anew
     * each time, so that a run that is resumed makes the same.
     */
    template <int dim>
    class IterativeEquilibrium : public Equilibrium<dim>
    {
    public:
      IterativeEquilibrium(const Body<dim> &body, SolverCounters &counters)
        : body(body)
        , counters(counters)
      {}

      void
      provide() override
      {
        if (!solver)
          solver = std::make_unique<IterativeSolver<dim>>(body);
      }

      bool
      is_provided() const override
      {
        return solver != nullptr;
      }

      void
      solve(const Vector               *forces,
            const std::vector<NodeLaw> &laws,
            const std::vector<double>  &position,
            const double                factor,
            Vector                     &y,
            std::vector<double>        &pressure) override
      {
        Assert(forces != nullptr, dealii::ExcInternalError());
        provide();
        solver->restore({});
        solver->solve_forces(*forces, laws, position, factor, y, pressure);
        SolverCounters made = solver->counters();
        made.solves         = 0; // those of stages count
        counters += made;
      }

      std::vector<std::string>
      take_warnings() override
      {
        // in words without numbers, which the run tells once
        if (!solver || solver->take_warnings().empty())
          return {};
        return {text("Solver/Linear tolerance = ",
                     body.scene.linear_solver.tolerance,
                     ": rounding leaves more of the forces that are in "
                     "equilibrium at the start, at an event or at a jump of "
                     "a load")};
      }

    private:
      const Body<dim>                      &body;
      SolverCounters                       &counters;
      std::unique_ptr<IterativeSolver<dim>> solver;
    };



    /** $bM_u$ without matrices, by conjugate gradients. */
    template <int dim>
    class IterativeInertia : public Equilibrium<dim>
    {
    public:
      explicit IterativeInertia(const Body<dim> &body)
        : body(body)
      {}

      void
      provide() override
      {
        if (is_provided())
          return;
        inverse_diagonal =
          body.equations.cell_products()->diagonal(Field::displacement,
                                                   body.scene.material.inertia,
                                                   0.);
        for (double &entry : inverse_diagonal)
          entry = 1. / entry;
      }

      bool
      is_provided() const override
      {
        return inverse_diagonal.size() > 0;
      }

      void
      solve(const Vector *forces,
            const std::vector<NodeLaw> & /*laws*/,
            const std::vector<double> &position,
            const double               factor,
            Vector                    &y,
            std::vector<double>       &pressure) override
      {
        provide();
        Vector held(inverse_diagonal), rest(inverse_diagonal), free(rest);
        held = 0.;
        for (const auto &[node, entry] :
             body.contact_end().entries(Field::displacement))
          held.local_element(entry) = -position[node] / factor;
        multiply(rest, held);
        rest *= -1.;
        if (forces != nullptr)
          rest += *forces;
        y = held;
        Vector rhs(rest);
        zero_given(rhs);
        conjugate_gradients("velocities or accelerations of the body",
                            *this,
                            free,
                            rhs,
                            inverse_diagonal,
                            Tolerances::rounding_of_solution);
        y += free;
        multiply(rhs, free);
        rest -= rhs;
        body.contact_end().get_values(Field::displacement, rest, pressure);
        for (unsigned int i = 0; i < pressure.size(); ++i)
          pressure[i] /= body.contact_end().nodes()[i].weight;
      }

      /** The product of the conjugate gradients. */
      void
      vmult(Vector &result, const Vector &x) const
      {
        multiply(result, x);
        zero_given(result);
      }

    private:
      const Body<dim> &body;
      Vector           inverse_diagonal;

      void
      multiply(Vector &result, const Vector &x) const
      {
        body.equations.cell_products()->vmult(
          Field::displacement, body.scene.material.inertia, 0., result, x);
        body.equations.zero_constrained(Field::displacement, result);
      }

      void
      zero_given(Vector &vector) const
      {
        for (const auto &[node, entry] :
             body.contact_end().entries(Field::displacement))
          vector.local_element(entry) = 0.;
      }
    };
  } // namespace



  template <int dim>
  std::unique_ptr<Equilibrium<dim>>
  make_equilibrium(const Body<dim>                        &body,
                   const typename Equilibrium<dim>::Matrix matrix,
                   SolverCounters                         &counters)
  {
    if constexpr (dim > 1)
      if (!body.scene.linear_solver.has_matrices())
        {
          if (matrix == Equilibrium<dim>::Matrix::inertia)
            return std::make_unique<IterativeInertia<dim>>(body);
          return std::make_unique<IterativeEquilibrium<dim>>(body, counters);
        }
    return std::make_unique<DirectEquilibrium<dim>>(body, matrix, counters);
  }



#define INSTANTIATE(dim)                                       \
  template std::unique_ptr<Equilibrium<dim>> make_equilibrium( \
    const Body<dim> &, const Equilibrium<dim>::Matrix, SolverCounters &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
