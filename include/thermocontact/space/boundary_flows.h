// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_boundary_flows_h
#define thermocontact_space_boundary_flows_h

#include <thermocontact/space/loads.h>
#include <thermocontact/space/surroundings.h>
#include <thermocontact/space/thermoviscoelastic_operator.h>

#include <vector>

namespace ThermoContact
{
  /**
   * Heat into the body, axial force on it (positive along x) and power of that
   * force, by parts of its boundary, or their integrals over time; per unit
   * cross-section, nondimensional, (D4.9). The pressure of an obstacle is not
   * in them.
   */
  struct BoundarySums
  {
    using S = BoundarySums;

    double heat_left     = 0.; ///< through the end $x=0$
    double heat_right    = 0.; ///< through the contact end
    double heat_sides    = 0.; ///< through the lateral faces
    double impulse_left  = 0.;
    double impulse_right = 0.;
    double work_left     = 0.;
    double work_right    = 0.;

    /** The names and members in the order of the columns of boundaries.csv. */
    template <class Column>
    static void
    for_each_column(const Column &column)
    {
      column("heat_left", &S::heat_left);
      column("heat_right", &S::heat_right);
      column("heat_sides", &S::heat_sides);
      column("impulse_left", &S::impulse_left);
      column("impulse_right", &S::impulse_right);
      column("work_left", &S::work_left);
      column("work_right", &S::work_right);
    }

    void
    add(const double weight, const BoundarySums &rates)
    {
      for_each_column([&](const char *, double S::*const member) {
        this->*member += weight * rates.*member;
      });
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      for_each_column([&](const char *, double S::*const member) {
        archive &(this->*member);
      });
    }
  };



  /**
   * Heat, momentum and work through the parts of the boundary of a body, by the
   * equations of a stage: where a temperature or a displacement is given they
   * are the residual of its row. Integrated with the weights of the stages they
   * close the balances of heat and momentum to rounding, (D4.9); with
   * coefficients of the temperature to the order of the scheme.
   */
  template <int dim>
  class BoundaryFlows
  {
  public:
    /** All arguments are borrowed. */
    BoundaryFlows(const Scene                           &scene,
                  const Discretization<dim>             &discretization,
                  const ThermoviscoelasticOperator<dim> &equations,
                  const Surroundings<dim>               &surroundings,
                  Loads<dim>                            &loads);

    /** Output/Boundaries. */
    bool
    is_active() const
    {
      return scene.parameters.output.boundaries;
    }

    /** Heat to the surroundings through the lateral faces, (D1.5), per unit
     * cross-section; 0 without such an exchange. Collective. */
    double
    lateral_heat_flux(const State &state) const;

    /**
     * The rates at the end of a stage; collective.
     *
     * @param state with the time of its loads
     * @param temperature_rate,acceleration $\theta'$ and $v'$
     * @param heat_load,momentum_load loads of the equations
     * @param load_times of which they are the mean; null: of the state
     */
    BoundarySums
    rates(const State             &state,
          const Vector            &temperature_rate,
          const Vector            &acceleration,
          const Vector            &heat_load,
          const Vector            &momentum_load,
          const MeanOfTimes *const load_times = nullptr);

    /**
     * What a jump at one time does: the heat that comes with the temperature of
     * a fixed end, and the work of tractions, springs and the motion of a body
     * without inertia. Collective.
     *
     * @param old_temperature,old_displacement before it
     * @param state after it
     */
    BoundarySums
    jump(const Vector &old_temperature,
         const Vector &old_displacement,
         const State  &state);

    /**
     * Impulse and work of the supports when velocities change at once, as at an
     * impact: rows of held nodes take what inertia asks for. Collective.
     *
     * @param change of the velocity
     * @param velocity of the ends that are held
     */
    BoundarySums
    impact(const Vector &change, const Vector &velocity);

  private:
    /** An end of the body. */
    struct End
    {
      types::boundary_id part;

      /** $\int\varphi_i$ over the end, of each field. */
      std::vector<Vector> weights;

      /** Entries of each field whose values are given there: temperatures and
       * axial displacements. */
      std::vector<std::vector<unsigned int>> given;

      double exchange; ///< $k$ of the matrices
      double outside;  ///< the temperature that it goes with
      double spring, dashpot;

      double BoundarySums::*heat;
      double BoundarySums::*impulse;
      double BoundarySums::*work;
    };

    const Scene                           &scene;
    const Discretization<dim>             &discretization;
    const ThermoviscoelasticOperator<dim> &equations;
    const Surroundings<dim>               &surroundings;
    Loads<dim>                            &loads;
    std::vector<End>                       ends;
    Vector heat_of_end, momentum_of_end; ///< loads of one end
    Vector heat_residual, heat_product;  ///< of all rows
    Vector momentum_residual;
    Vector sides; ///< weights of the temperature in the lateral exchange
    double sum_of_sides = 0.;

    End
    make_end(const types::boundary_id part);

    /** Heat through an exchange that matrices do not contain, per unit
     * cross-section. */
    double
    heat_by_law(const State &state) const;

    /** Of all processes, per unit cross-section. */
    BoundarySums
    sum_of_all(const BoundarySums &own) const;
  };
} // namespace ThermoContact

#endif
