// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_time_contact_port_h
#define thermocontact_time_contact_port_h

#include <thermocontact/contact/interface_law.h>
#include <thermocontact/contact/interface_problem.h>
#include <thermocontact/space/body.h>
#include <thermocontact/space/linear_system.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace ThermoContact
{
  /**
   * The contact nodes of a body as a linear system for its displacement shows
   * them: $Ky+sNp=r$, with pressures that their laws give at $x=x_0+cy$. A
   * system with factors shows its response to pressures, (C2.4); one without
   * takes the tangents of the laws as springs of its rows, (C2.10). Collective.
   *
   * Pressures that are found by the response are given to the system once more:
   * y is no difference of responses, which would cost digits. MonolithicSolver,
   * which does this several times a step, takes that difference and refines it
   * where digits are lost.
   */
  template <int dim>
  class ContactPort : private InterfaceOperator
  {
  public:
    /** Both are borrowed; $s=1$. */
    ContactPort(const Body<dim> &body, LinearSystem<dim> &system);

    /**
     * @param forces $r$, zero in rows that are not solved for
     * @param laws,position of the contact nodes, $x_0$
     * @param factor $c$
     * @param y in: where iterations find first tangents; out; zero where it is
     *   not solved for
     * @param pressure in: a guess; out: the solution
     * @return number of linear systems for tangents; 0 with factors
     * @throw ComputationError if the pressures are not found
     */
    unsigned int
    solve_contact(const Vector               &forces,
                  const std::vector<NodeLaw> &laws,
                  const std::vector<double>  &position,
                  const double                factor,
                  Vector                     &y,
                  std::vector<double>        &pressure);

    /**
     * The last problem differentiated at its solution, its branches held,
     * (C4.3), for $c=s=1$.
     *
     * @param forces,rate of the forces and of the positions
     * @param laws of the nodes, for their local obstacles
     * @param closing nodes that touch their local obstacle at this instant and
     *   may have no pressure yet
     * @param y out: its rate
     */
    void
    solve_rates(const Vector                    &forces,
                const std::vector<double>       &rate,
                const std::vector<NodeLaw>      &laws,
                const std::vector<unsigned int> &closing,
                Vector                          &y);

    /** Makes the response if there is one. @return number of solves for it */
    unsigned int
    provide_response()
    {
      return system->has_factors() ? response().m() : 0;
    }

    /** Loss of y of the nodes per unit pressure; of systems with factors. */
    const FullMatrix<double> &
    response();

    /** x of the solution without factors that was found last. */
    const std::vector<double> &
    positions() const
    {
      return positions_;
    }

  protected:
    /** Of a derived class, whose functions below know the system. */
    explicit ContactPort(const Body<dim> &body);

    /** Solves with springs in place, loosely until @p is_last. */
    virtual void
    solve_system(const bool is_last);

    /** The forces less the product with y, without springs. */
    virtual const Vector &
    left();

    /** Diagonal of the rows without springs. */
    virtual const Vector &
    diagonal() const;

    virtual void
    set_springs(const std::vector<double> &springs,
                const std::vector<double> &relaxed);

    /** Of $z$ in solve_by_tangents(). */
    virtual double
    rounding() const;

    /** Puts springs and held nodes in place. */
    void
    set_tangents(const std::vector<AffineLaw> &laws,
                 const std::vector<double>    &position,
                 const double                  factor);

    void
    solve(const std::vector<AffineLaw> &laws,
          const bool                    is_last,
          std::vector<double>          &new_position,
          std::vector<double>          &pressure) override;

    double scale = 1.; ///< $s$

  private:
    const Body<dim>         &body;
    LinearSystem<dim> *const system; ///< null: of a derived class
    InterfaceProblem         problem;
    FullMatrix<double>       response_;
    std::vector<AffineLaw>   tangents; ///< of the last problem
    std::vector<double>      springs, touching;
    std::vector<double>      positions_;

    // of the problem that is solved
    const Vector              *forces   = nullptr;
    const std::vector<double> *position = nullptr;
    double                     factor   = 1.;
    Vector                    *y        = nullptr;
    Vector                     rest; ///< of the forces

    void
    start(const Vector              &new_forces,
          const std::vector<double> &new_position,
          const double               new_factor,
          Vector                    &new_y);

    /** y by forces and these pressures. */
    void
    solve_with(const std::vector<double> &pressure);

    /** Receptances of the nodes alone, by the diagonal. */
    std::vector<double>
    receptances() const;
  };
} // namespace ThermoContact

#endif
