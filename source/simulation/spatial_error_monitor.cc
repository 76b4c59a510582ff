// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/quantity_units.h>
#include <thermocontact/method/impact_layer.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/simulation/spatial_error_monitor.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace ThermoContact
{
  namespace
  {
    /** Degrees whose own coefficients say nothing of those that follow. */
    constexpr unsigned int highest_low_degree = 2;

    /** Steps that are all sampled, and the stride of those that follow. */
    constexpr unsigned int n_first_samples = 64, stride = 8;

    /** Higher ones are slow; more cells do as well. */
    constexpr double largest_degree = 16.;

    /**
     * Nodes across a contact below which its force is that of the mesh: at a
     * cylinder, measured, it is 13 % off with one, 4 % with three, 1 % with
     * five.
     */
    constexpr double fewest_nodes = 5.;



    /** Weights of the nodes of a cell, along it, in coefficient @p n. */
    std::vector<double>
    legendre_weights(const std::vector<Polynomials::Polynomial<double>> &nodal,
                     const unsigned int                                  n)
    {
      const QGauss<1>     quadrature(nodal.size());
      std::vector<double> weights(nodal.size());
      for (unsigned int i = 0; i < nodal.size(); ++i)
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          weights[i] += (2. * n + 1.) * quadrature.weight(q) *
                        nodal[i].value(quadrature.point(q)[0]) *
                        std::legendre(n, 2. * quadrature.point(q)[0] - 1.);
      return weights;
    }
  } // namespace



  double
  MeshTail::rate() const
  {
    return upper < lower ? std::sqrt(upper / lower) : 1.;
  }



  double
  MeshTail::error(const double scale, const double duration) const
  {
    return upper > 0. && scale > 0. && duration > 0. ?
             std::sqrt(upper * rate() / (scale * duration)) :
             0.;
  }



  void
  MeshTail::add(const double weight, const MeshTail &tail)
  {
    upper += weight * tail.upper;
    lower += weight * tail.lower;
  }



  template <int dim>
  SpatialErrorMonitor::SpatialErrorMonitor(
    const Scene               &scene,
    const Discretization<dim> &discretization)
    : scene(scene)
    , layout{discretization.n_active_cells(), discretization.degree()}
    , has_half(discretization.geometry().has_axis_at_side() ||
               scene.has_symmetry)
  {
    if (dim > 1)
      for (const ContactNode<dim> &node : discretization.contact_end().nodes())
        places_across.push_back({{dim > 1 ? node.position[dim > 1] : 0.,
                                  dim > 2 ? node.position[dim - 1] : 0.}});
    // the steps of the midpoint rule on such a mesh have no error inside cells,
    // and the cells of a row are not all of one body
    if (dim > 1 || scene.has_midpoint_mass || scene.row.is_given())
      return;
    cell_sizes.reserve(layout.n_cells);
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      cell_sizes.push_back(cell->extent_in_direction(0));
    const unsigned int p     = layout.degree;
    const auto         nodal = Polynomials::generate_complete_Lagrange_basis(
      QGaussLobatto<1>(p + 1).get_points());
    upper_weights = legendre_weights(nodal, p);
    lower_weights = legendre_weights(nodal, p - 1);
    if (p <= highest_low_degree)
      {
        make_factors(Field::temperature, 0);
        make_factors(Field::displacement, 1);
      }
  }



  double
  SpatialErrorMonitor::product(const std::vector<double> &weights,
                               const unsigned int         cell,
                               const Vector              &vector) const
  {
    // the right vertex comes before the inner nodes
    const double      *values = vector.begin();
    const unsigned int right  = layout.first_node(cell);
    double             sum = weights.front() * values[layout.left_vertex(cell)];
    for (unsigned int i = 1; i < layout.degree; ++i)
      sum += weights[i] * values[right + i];
    return sum + weights.back() * values[right];
  }



  void
  SpatialErrorMonitor::make_factors(const Field::Block field,
                                    const unsigned int n_derivatives)
  {
    // The coefficient n of what is approximated, a multiple of the n-th
    // derivative and h^n, changes from cell to cell by 2 (2n + 1) times the
    // next one. Without derivative it is c_p, of the strain (2p - 1) 2/h c_p.
    const double p      = layout.degree;
    const double n      = p - n_derivatives;
    const double next   = 1. / (2. * (2. * n + 1.));
    double       before = 0.;
    factors[field].reserve(layout.n_cells);
    for (const double h : cell_sizes)
      {
        factors[field].push_back(
          {n_derivatives == 0 ? 1. : 2. * (2. * p - 1.) / h,
           before > 0. ? std::pow(h / before, n) : 0.,
           h / (2. * n + 3.) * next * next});
        before = h;
      }
  }



  void
  SpatialErrorMonitor::note_contact(const State &state, const double force)
  {
    if (!(force > largest_force))
      return;
    const std::vector<double> &p = state.contact.pressure;
    largest_force                = force;
    touching.clear();
    for (unsigned int i = 0; i < p.size(); ++i)
      if (p[i] != 0.)
        touching.push_back(i);
    if (touching.size() == p.size())
      touching.clear();
  }



  std::string
  SpatialErrorMonitor::doubt_of_contact() const
  {
    if (touching.empty())
      return "";
    std::array<std::set<double>, 2> places; // y and z
    for (const unsigned int node : touching)
      for (unsigned int d = 0; d < places.size(); ++d)
        places[d].insert(places_across[node][d]);
    double across = places[0].size();
    if (scene.parameters.dimension == 3)
      across = std::min<double>(across, places[1].size());
    if (has_half)
      across = 2. * across - 1.;
    if (across >= fewest_nodes)
      return "";
    return text("where its force is largest the contact is at ",
                touching.size(),
                touching.size() == 1 ? " node" : " nodes",
                " alone: force, area and pressures are those of the mesh; "
                "remedy: Mesh/Cells across = ",
                std::ceil(scene.parameters.mesh.n_cells_across() *
                          fewest_nodes / across),
                " or more");
  }



  void
  SpatialErrorMonitor::add(const State &state, const StepRecord &record)
  {
    if (scene.parameters.dimension > 1)
      note_contact(state, std::abs(record.contact_force));
    if (cell_sizes.empty())
      return;
    const EnergyTerms &energy = record.energy_terms;
    // a part below the rounding of the values themselves is none
    const auto rounding = [](const double value) {
      const double size = Tolerances::rounding_of_solution * value;
      return size * size;
    };
    max_thermal = std::max(
      {max_thermal, 2. * energy.thermal, rounding(record.temperature_mean)});
    max_mechanical = std::max({max_mechanical,
                               2. * energy.elastic,
                               2. * energy.kinetic,
                               rounding(record.displacement_end)});
    time_skipped += record.step_size;
    if (++n_steps > n_first_samples && n_steps % stride != 0)
      return;
    if (scene.fields.has_temperature)
      heat.add(time_skipped, tail(Field::temperature, state.temperature, 0));
    if (scene.fields.has_displacement)
      strain.add(time_skipped,
                 tail(Field::displacement, state.displacement, 1));
    duration += std::exchange(time_skipped, 0.);
  }



  MeshTail
  SpatialErrorMonitor::tail(const Field::Block field,
                            const Vector      &vector,
                            const unsigned int n_derivatives) const
  {
    // Squares of norms over a cell of size h, whose coordinate is (x - m) 2/h:
    // h/(2n + 1) c^2 of c P_n; the first term of the derivative of c P_n is
    // (2n - 1) 2/h c P_{n-1}.
    const double p = layout.degree;
    MeshTail     now;
    if (layout.degree <= highest_low_degree)
      add_differences(field, vector, now);
    else if (n_derivatives == 0)
      add_last_coefficients(
        vector, 1. / (2. * p + 1.), 1. / (2. * p - 1.), 1, now);
    else
      add_last_coefficients(
        vector, 4. * (2. * p - 1.), 4. * (2. * p - 3.), -1, now);
    return now;
  }



  void
  SpatialErrorMonitor::add_last_coefficients(const Vector &vector,
                                             const double  upper_factor,
                                             const double  lower_factor,
                                             const int     power,
                                             MeshTail     &tail) const
  {
    for (unsigned int cell = 0; cell < layout.n_cells; ++cell)
      {
        const double upper  = product(upper_weights, cell, vector);
        const double lower  = product(lower_weights, cell, vector);
        const double h      = cell_sizes[cell];
        const double weight = power > 0 ? h : 1. / h;
        tail.upper += upper_factor * weight * upper * upper;
        tail.lower += lower_factor * weight * lower * lower;
      }
  }



  void
  SpatialErrorMonitor::add_differences(const Field::Block field,
                                       const Vector      &vector,
                                       MeshTail          &tail) const
  {
    double before = 0., last_difference = 0.;
    for (unsigned int cell = 0; cell < layout.n_cells; ++cell)
      {
        const CellFactors &factor = factors[field][cell];
        const double       now =
          factor.coefficient * product(upper_weights, cell, vector);
        if (cell > 0)
          {
            const double difference = now - factor.before * before;
            tail.lower += factor.square * difference * difference;
            if (cell > 1)
              {
                const double change = difference - last_difference;
                tail.upper += factor.square * change * change;
              }
            last_difference = difference;
          }
        before = now;
      }
  }



  double
  SpatialErrorMonitor::error(const Field::Block field) const
  {
    return field == Field::temperature ? heat.error(max_thermal, duration) :
                                         strain.error(max_mechanical, duration);
  }



  std::string
  SpatialErrorMonitor::remedy(const double error, const double rate) const
  {
    const MeshParameters &mesh   = scene.parameters.mesh;
    const double          excess = error / Tolerances::tolerated_mesh_error;
    // Smooth: the error falls by the rate with each degree, and with a power of
    // the cells; else with one over the number of nodes.
    const bool   is_low    = mesh.degree <= highest_low_degree;
    const bool   is_smooth = rate < 0.3 && mesh.degree != 3;
    const double degree =
      is_low ?
        (is_smooth ? 4. : 2. * largest_degree) :
        std::ceil(is_smooth ? mesh.degree + std::log(excess) / -std::log(rate) :
                              mesh.degree * excess);
    const double cells = std::ceil(
      mesh.cells * std::pow(excess, is_smooth ? 1. / mesh.degree : 1.));
    const std::string more_cells =
      "Mesh/Cells = " + significant(cells, 12) + " or more";
    const bool is_degree_one =
      mesh.degree == 1 && (scene.has_lumped_mass || scene.has_midpoint_mass);
    return degree > largest_degree || is_degree_one ?
             more_cells :
             "Mesh/Degree = " + significant(degree, 12) + ", or " + more_cells;
  }



  std::string
  SpatialErrorMonitor::take_warning()
  {
    const double of_heat   = error(Field::temperature);
    const double of_strain = error(Field::displacement);
    const double largest   = std::max(of_heat, of_strain);
    if (has_warned)
      return "";
    if (scene.parameters.dimension > 1)
      {
        const std::string doubt = doubt_of_contact();
        has_warned              = !doubt.empty();
        return doubt;
      }
    if (!(largest > Tolerances::tolerated_mesh_error))
      return "";
    has_warned = true;
    return text("the mesh leaves out about ",
                significant(100. * largest, 2),
                " % of the ",
                of_strain < of_heat ? "temperature" : "strain",
                ", in the mean over the run; peaks may be wrong by several "
                "times as much; remedy: ",
                remedy(largest, (of_strain < of_heat ? heat : strain).rate()));
  }



  double
  spacing_of_largest_force(const Scene &scene)
  {
    const Material   &material = scene.material;
    const ContactLaw &law      = *scene.contact.law;
    if (!law.is_active() || !material.has_inertia() ||
        !material.has_viscosity())
      return infinity;
    const double b = material.inertia, zeta = material.viscosity;
    const double dashpot = scene.contact.dashpot();
    // at the first touch, where the viscous stress stops the end
    if (scene.scheme.has_no_dispersion && dashpot > 0.)
      return zeta / dashpot;
    const bool has_rigid = scene.contact.has_rigid();
    if (!has_rigid && !scene.contact.compliance())
      return infinity;
    const double compliance = has_rigid ? 0. : *scene.contact.compliance();
    return time_of_impact(b, zeta, compliance) < zeta ?
             layer_of_impact(b, zeta, compliance) :
             infinity;
  }



  namespace
  {
    bool
    has_impact(const std::vector<ContactEvent> &events)
    {
      return std::any_of(events.begin(),
                         events.end(),
                         [](const ContactEvent &event) {
                           return event.kind == ContactEvent::begin &&
                                  event.velocity != 0.;
                         });
    }
  } // namespace



  bool
  is_largest_force_of_mesh(const Scene                     &scene,
                           const std::vector<ContactEvent> &events)
  {
    return (scene.scheme_choice.has_unresolved_fronts ||
            2. * scene.parameters.mesh.contact_node_length() >
              spacing_of_largest_force(scene)) &&
           has_impact(events);
  }



  namespace
  {
    /**
     * Part of its jump by which a front overshoots at the largest force if the
     * shortest waves stay behind by this part of a cell in a step, since the
     * first contact or since the start if data make fronts: from above.
     */
    double
    overshoot_by(const double      delay,
                 const Scene      &scene,
                 const RunHistory &history)
    {
      if (!(delay > 0.) || history.events.empty())
        return 0.;
      const double begin =
        has_fronts_of_data(scene.parameters) ? 0. : history.events.front().time;
      const double n_steps =
        std::max(0., history.largest_force().time_of_largest() - begin) /
        *scene.parameters.time.step_size;
      return std::min(Tolerances::overshoot_of_fronts,
                      Tolerances::overshoot_of_drift * delay * n_steps);
    }



    /**
     * The shortest waves have the heat of both neighbours of a cell; those that
     * exchange none travel faster by $\sqrt{1+a^2}$. A front that overshoots
     * rings, and the force behind its peak with it.
     */
    double
    overshoot_by_heat(const Scene &scene, const RunHistory &history)
    {
      if (!(history.max_contact_force > 0.))
        return 0.;
      const double delay = std::sqrt(1. + stiffness_by_heat(scene)) - 1.;
      return std::min(overshoot_by(delay, scene, history),
                      history.largest_force().ringing() /
                        history.max_contact_force);
    }
  } // namespace



  double
  overshoot_of_fronts(const Scene &scene, const RunHistory &history)
  {
    return !scene.scheme.has_no_dispersion ?
             0. :
             overshoot_by(delay_by_passages(scene), scene, history) +
               overshoot_by_heat(scene, history);
  }



  std::string
  warning_of_largest_force(const Scene &scene, const RunHistory &history)
  {
    if (!is_largest_force_of_mesh(scene, history.events))
      {
        const double overshoot = scene.scheme.has_no_dispersion ?
                                   overshoot_by_heat(scene, history) :
                                   0.;
        return overshoot > Tolerances::harmless_change ?
                 text(
                   "waves that heat the body travel faster than the mesh "
                   "lets its shortest ones: fronts, and with them the "
                   "largest force, overshoot by up to ",
                   significant(100. * overshoot, 2),
                   " %; remedy: Model/Fields = displacement, with a modulus ",
                   significant(1. + stiffness_by_heat(scene), 8),
                   " times as large, that of waves without exchange of heat") :
                 "";
      }
    const double spacing = 0.5 * (scene.parameters.mesh.degree + 1.) *
                           spacing_of_largest_force(scene);
    const std::string start = "the largest force is that of the mesh: ";
    if (spacing == 0.)
      return start +
             "behind an impact on a rigid obstacle the force of a viscous body "
             "grows without limit as cells get smaller; remedy: the impulse, "
             "which has a limit, or Contact/Condition = normal compliance";
    if (scene.scheme_choice.has_unresolved_fronts &&
        scene.material.has_viscosity())
      return start +
             "it does not resolve the fronts of waves, which viscosity smooths; "
             "remedy: more Mesh/Cells, or a higher Mesh/Degree" +
             (scene.parameters.dimension > 1 ? "" : ", or both automatic");
    if (scene.scheme_choice.has_unresolved_fronts)
      return start +
             "fronts of waves ring on any, since nothing smooths them; remedy: " +
             (scene.parameters.dimension > 1 ?
                "the impulse, which is right, or Dimension = 1 for a rod" :
              scene.parameters.boundary.left.mass > 0. ||
                  scene.parameters.boundary.right.is_any() ?
                "the impulse, which is right, or a softer obstacle: the scheme "
                "without dispersion has no masses, and springs and dashpots on "
                "the left alone" :
                "Time/Scheme = box, with automatic Mesh/Cells, Mesh/Degree and "
                "Time/Step size");
    return text(start,
                "it needs nodes at most ",
                QuantityUnits(scene.parameters).text("position", spacing),
                " apart at the obstacle; remedy: ",
                scene.scheme.has_no_dispersion ? "" :
                                                 "a larger Mesh/Grading, or ",
                "more Mesh/Cells");
  }



  template SpatialErrorMonitor::SpatialErrorMonitor(const Scene &,
                                                    const Discretization<1> &);
  template SpatialErrorMonitor::SpatialErrorMonitor(const Scene &,
                                                    const Discretization<2> &);
  template SpatialErrorMonitor::SpatialErrorMonitor(const Scene &,
                                                    const Discretization<3> &);
} // namespace ThermoContact
