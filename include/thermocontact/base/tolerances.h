// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_base_tolerances_h
#define thermocontact_base_tolerances_h

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  /**
   * Every number that says when two numbers are one, when a part is negligible
   * or when an iteration has arrived, with where it comes from; $u=1.1\cdot
   * 10^{-16}$ is the unit of rounding. Relative, if not said otherwise.
   */
  namespace Tolerances
  {
    // ---- rounding

    /** Of a few operations: 10 u. */
    inline constexpr double rounding = 1e-15;

    /** Of sums of some hundred terms: 100 u. */
    inline constexpr double rounding_of_sum = 1e-14;

    /**
     * Of steps in parts of the time: so short a step changes velocities by
     * accelerations as much as an interpolant has lost of them, u over it.
     */
    inline constexpr double short_step = 1e-8;

    /** Of solutions of linear systems with a condition of some thousand. */
    inline constexpr double rounding_of_solution = 1e-13;

    /**
     * Of errors of solutions, which change from node to node, over the errors:
     * with a hundred nodes along the body.
     */
    inline constexpr double strains_of_errors = 100.;

    /**
     * Of a front in the scheme without dispersion, in parts of its jump: the
     * rounding that some thousand steps have added up.
     */
    inline constexpr double rounding_of_fronts = 1e-9;

    /** Steps in the time that the force of a contact takes, at least: then
     * peaks are right to a few percent. */
    inline constexpr double steps_of_contact = 10.;

    /** Of products that a user writes, of projections, of coordinates. */
    inline constexpr double rounding_of_data = 1e-12;

    /**
     * Of contact, over the scale of a stage: beyond it a node is held, and
     * single precision ends at 3e38.
     */
    inline constexpr double stiffest_spring = 1e30;

    /**
     * A field whose energy is larger, over that scale, is not zero at a held
     * node: its value there is above 1e-6.
     */
    inline constexpr double energy_of_held = 1e18;

    /** Smallest pivot over the diagonal that is more than rounding to 6e-8. */
    inline constexpr double smallest_single_pivot = 1e-5;

    /** Of squares of residuals in single precision, whose unit is 6e-8. */
    inline constexpr double rounding_of_single_squares = 1e-10;

    /**
     * Of a penetration, over the displacement and the gap whose difference it
     * is: a hard obstacle leaves six digits.
     */
    inline constexpr double rounding_of_penetration = 1e-10;

    /** Of displacement and time at an event: 40 u, a few operations more. */
    inline constexpr double rounding_of_event = 4e-15;

    /** Of a ratio of times that is to be whole: 4 u. */
    inline constexpr double rounding_of_ratio = 4e-16;

    /** Growth of terms in a sum: four of its sixteen digits may go. */
    inline constexpr double tolerated_cancellation = 1e4;

    // ---- times

    /** Times this close are one: sums of a thousand steps. */
    inline constexpr double same_time = 1e-12;

    /**
     * Times this close to a multiple of an interval, in parts of the interval,
     * are on it: step sizes, output and forecasts agree on this.
     */
    inline constexpr double multiple_slack = 1e-6;

    // ---- places

    /** Points this close to a cell, in parts of its size, are in it. */
    inline constexpr double in_cell = 1e-10;

    /**
     * Coordinates of nodes that are closer are one: between their rounding,
     * which depends on the ranks, and the distance of nodes.
     */
    inline constexpr double same_coordinate = 1e-11;

    /** A jump of a material that is nearer to a face of the body, in parts of
     * its extent, is on the face: its place is rounded. */
    inline constexpr double thinnest_layer = 1e-9;

    /** Length of a closed gap in the mesh of a row, in parts of its bodies. */
    inline constexpr double closed_gap = 1e-9;

    // ---- contact

    /** Of an event, where steps are fixed and no tolerance is given. */
    inline constexpr double fixed_step_event = 1e-13;

    /** Of the root of a cubic that has one at the start of the step. */
    inline constexpr double zero_at_start = 1e-9;

    /** Parts of the velocity of an obstacle by which it does not jump. */
    inline constexpr double continuous_velocity = 1e-6;

    /** Steps of damped Newton methods that are shorter have stalled: 2^-10. */
    inline constexpr double shortest_newton_step = 1e-3;

    /** Difference quotients: the root of u, times ten for noisy functions. */
    inline constexpr double difference_step = 1e-7;

    /** Nodes whose changes are this close along a segment change together. */
    inline constexpr double simultaneous_changes = 1e-10;

    // ---- iterations

    /** Linear systems whose solutions a search compares, over its tolerance:
     * their errors are no part of what it looks at. */
    inline constexpr double within_search = 0.1;

    /** Krylov: while the tangents of contact still change, and the most that
     * rounding may leave. */
    inline constexpr double loose_residual = 1e-5;

    /** Krylov: of the correction of an estimate of errors. */
    inline constexpr double estimate_residual = 1e-3;

    /** Krylov: if the user names none; results then have 1e-8. */
    inline constexpr double default_residual = 1e-9;

    /** Krylov: from which on a user may not ask for less. */
    inline constexpr double loosest_residual = 1e-2;

    /** Projections of initial values: the digits that later steps keep. */
    inline constexpr double projection_residual = 1e-11;

    /** Conjugate gradients for nodes that move at once: its heat is large. */
    inline constexpr double adiabatic_residual = 1e-11;

    /** The spectral radius of a fixed point: for a refusal, not a result. */
    inline constexpr double eigenvalue_change = 1e-6;

    /** Refinement of a solution ends: velocities have gained eight digits. */
    inline constexpr double refined_change = 1e-8;

    /** Parts of the largest displacement that a node need not be moved. */
    inline constexpr double negligible_displacement = 1e-6;

    // ---- loads

    /**
     * Parts of the initial heat, as it differs from its mean, that the nodes of
     * a mesh may miss: below what cells of degree 1 leave out of a smooth
     * temperature.
     */
    inline constexpr double lost_heat = 1e-2;

    /** A part of a load that is integrated over a cell, of its largest value
     * times the cell: what doubles tell from it with some digits. */
    inline constexpr double least_load = 1e-12;

    /**
     * Parts of the variation of a load that do not matter: its slopes are known
     * to the root of u, times ten.
     */
    inline constexpr double negligible_load = 1e-7;

    // ---- values that a user gives twice

    /** Areas this close are meant to be one: three digits. */
    inline constexpr double same_area = 1e-3;

    // ---- results

    /** A steady state is reached after seven of the times of the approach:
     * exp(-7). */
    inline constexpr double reached_state = 1e-3;

    // ---- effects that are worth a warning, or a step

    /** Estimated errors below that say nothing on the next step size. */
    inline constexpr double smallest_error = 1e-10;

    /** Error of the mesh, in parts of the solution. */
    inline constexpr double tolerated_mesh_error = 1.5e-3;

    /** Energy that fixed steps of a scheme without a bound may create. */
    inline constexpr double energy_of_fixed_steps = 1e-3;

    /** Energy that all others may create: rounding of some thousand steps. */
    inline constexpr double energy_of_rounding = 1e-9;

    /** Step sizes this close to the passage of a cell are meant to be it. */
    inline constexpr double same_step_size = 1e-9;

    /** The shortest waves of a row may stay behind by this part of a cell. */
    inline constexpr double drift_of_waves = 1e-2;

    /** Steps of the scheme without dispersion in which a front passes, and a
     * part of the one in which it begins: measured 2.1 at most. */
    inline constexpr double steps_of_front = 2.5;

    /**
     * A front overshoots by this part of its jump for each cell by which the
     * shortest waves stay behind it, measured up to a quarter of a cell, and at
     * most by the other one, the largest value of the integral of Airy's
     * function less 1.
     */
    inline constexpr double overshoot_of_drift  = 0.14;
    inline constexpr double overshoot_of_fronts = 0.2743;

    /**
     * Nodes of a mesh in the length of a front from which on the peak force is
     * right to about 1e-3, measured.
     */
    inline constexpr double nodes_of_front = 8.;

    /** Cells times steps of a run that nobody has asked for: some seconds. */
    inline constexpr double most_cell_steps = 1e8;

    // ---- forecasts

    /** Part of the end time that a step of masses takes without contact. */
    inline constexpr double step_of_masses = 1e-3;

    /** The last cell over the first, at least: shorter contacts are short. */
    inline constexpr double steepest_grading = 1e-4;

    /** Tolerance of the run on a few cells that finds the first impact. */
    inline constexpr double forecast_run = 1e-3;

    // ---- doubts

    /** Changes of a load or a coefficient, in parts of all of them, that are
     * not warned of however fast they are. */
    inline constexpr double harmless_change = 0.01;

    /** Pressure over modulus at which most metals yield. */
    inline constexpr double yield_strain = 1e-3;
  } // namespace Tolerances



  /** True if two times cannot be told apart. */
  inline bool
  are_same_time(const double a, const double b)
  {
    return std::abs(a - b) <=
           Tolerances::same_time * std::max(std::abs(a), std::abs(b));
  }
} // namespace ThermoContact

#endif
