// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/contact/interface_problem.h>
#include <thermocontact/space/linear_system.h>
#include <thermocontact/time/equilibrium.h>
#include <thermocontact/time/iterative_solver.h>

#include <algorithm>

namespace ThermoContact
{
  namespace
  {
    template <class Matrix>
    const SystemCoefficients &
    coefficients(const Matrix matrix)
    {
      return matrix == Matrix::inertia ? motion_by_inertia :
                                         motion_by_stiffness;
    }



    /** By a system and its responses to unit pressures. */
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
        if (system)
          return;
        auto made = std::make_unique<LinearSystem<dim>>(body.equations,
                                                        coefficients(kind));
        counters.factorizations += made->n_factorizations();
        if (body.law().is_active())
          make_responses(*made);
        system = std::move(made);
      }

      bool
      is_provided() const override
      {
        return system != nullptr;
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
          system->solve(y, *forces);
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
      const Body<dim>                   &body;
      const Matrix                       kind;
      SolverCounters                    &counters;
      std::unique_ptr<LinearSystem<dim>> system;
      std::vector<Vector>                unit_responses; ///< to pressures
      FullMatrix<double>                 receptance; ///< of the contact nodes

      void
      make_responses(LinearSystem<dim> &made)
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



    /** $bM_u$ of a body without matrices, whose laws hold the nodes. */
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
        if (!system)
          system = std::make_unique<LinearSystem<dim>>(
            body.equations,
            motion_by_inertia,
            nullptr,
            LinearSystem<dim>::Rows::off_contact);
      }

      bool
      is_provided() const override
      {
        return system != nullptr;
      }

      void
      solve(const Vector               *forces,
            const std::vector<NodeLaw> &laws,
            const std::vector<double>  &position,
            const double                factor,
            Vector                     &y,
            std::vector<double>        &pressure) override
      {
        Assert(std::all_of(laws.begin(),
                           laws.end(),
                           [](const NodeLaw &law) { return law.is_held; }),
               dealii::ExcInternalError());
        (void)laws;
        provide();
        const ContactEnd<dim> &end = body.contact_end();
        Vector held(body.discretization.make_vector(Field::displacement));
        Vector rest(held), product(held);
        for (const auto &[node, entry] : end.entries(Field::displacement))
          held.local_element(entry) = -position[node] / factor;
        const auto subtract_product = [&](const Vector &x) {
          body.equations.product(motion_by_inertia,
                                 Field::displacement,
                                 x,
                                 product);
          rest -= product;
        };
        if (forces != nullptr)
          rest = *forces;
        subtract_product(held);
        Vector rhs(rest);
        for (const auto &[node, entry] : end.entries(Field::displacement))
          rhs.local_element(entry) = 0.;
        system->solve(y, rhs);
        subtract_product(y);
        y += held;
        end.get_values(Field::displacement, rest, pressure);
        for (unsigned int i = 0; i < pressure.size(); ++i)
          pressure[i] /= end.nodes()[i].weight;
      }

    private:
      const Body<dim>                   &body;
      std::unique_ptr<LinearSystem<dim>> system;
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
