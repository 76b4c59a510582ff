// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/input/load_enclosure.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/method/impact_layer.h>
#include <thermocontact/scene/body_profile.h>
#include <thermocontact/scene/box_limits.h>
#include <thermocontact/scene/row.h>
#include <thermocontact/scene/scheme_choice.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    /** Cells of a rod without dispersion are a multiple, for coarser runs. */
    constexpr unsigned int multiple_of_cells = 8;

    /** A rod without dispersion has at least that many cells. */
    constexpr unsigned int fewest_cells = 40;

    /**
     * A step of a rod without dispersion costs as much as so many stages with
     * as many unknowns, measured.
     */
    constexpr unsigned int stages_of_box = 2;

    /** Degree of a mesh whose cells are as long as the fronts. */
    constexpr unsigned int degree_of_fronts = 8;

    /**
     * Lengths that the contact node stands for in the layer of an impact with
     * which the mesh is as right about the peak force as steps of the default
     * tolerance, to some 1e-6, measured.
     */
    constexpr double nodes_of_layer = 10.5;

    /**
     * Nodes in the compliance of an obstacle with which that is so where its
     * node has no mass and little viscosity, measured.
     */
    constexpr double nodes_of_compliance = 16.;

    /**
     * Length over which viscosity spreads a front while it passes the body, by
     * diffusion with the coefficient $\zeta/b$ in the time $\sqrt b$.
     */
    double
    length_of_diffusion(const ModelParameters &model)
    {
      return std::sqrt(model.viscosity / std::sqrt(model.inertia));
    }



    Expression
    read(const Parameters  &parameters,
         const std::string &path,
         const std::string &text)
    {
      ExpressionNames                 names = parameters.names(path);
      const BoundaryParameters::Left &left  = parameters.boundary.left;
      names.constants.emplace("theta_A",
                              left.has_temperature() ? left.temperature :
                                                       left.surroundings);
      return Expression(path, text, names);
    }



    /** Value and slope in x of an entry at the start. */
    NumberJet
    jet_in_x(const Expression &expression, const double x)
    {
      const NumberJet variables[] = {NumberJet(x, 1., 0.),
                                     NumberJet(0.),
                                     NumberJet(0.),
                                     NumberJet(0.)};
      return expression.evaluate(variables);
    }



    /** Jumps, or also kinks, of a function in the run. */
    bool
    has_breaks(const TimeFunction &function,
               const double        end_time,
               const bool          are_kinks_breaks)
    {
      if (!(end_time > 0.) || !function.expression.depends_on("t"))
        return false;
      const EnclosedLoad load = enclose_load(function, end_time);
      return std::any_of(load.history.breaks.begin(),
                         load.history.breaks.end(),
                         [=](const LoadBreak &at) {
                           return at.is_jump || are_kinks_breaks;
                         });
    }



    /**
     * Whether a function jumps in $0\lt x\lt1$: between some of many points,
     * which are brought together, most of a difference stays.
     */
    template <typename Function>
    bool
    has_jump_in_x(const Function &value)
    {
      constexpr unsigned int n_spans = 64, n_halvings = 40;
      for (unsigned int i = 0; i < n_spans; ++i)
        {
          double       low        = static_cast<double>(i) / n_spans;
          double       high       = (i + 1.) / n_spans;
          const double difference = std::abs(value(high) - value(low));
          for (unsigned int n = 0; n < n_halvings; ++n)
            {
              const double middle = 0.5 * (low + high);
              const double at     = value(middle);
              const bool   is_low =
                std::abs(at - value(low)) > std::abs(value(high) - at);
              (is_low ? high : low) = middle;
            }
          if (std::abs(value(high) - value(low)) > 0.1 * difference &&
              difference > 0.)
            return true;
        }
      return false;
    }



    /** Whether the initial velocity or strain jumps along the rod. */
    bool
    has_jump_of_initial_values(const Parameters &parameters)
    {
      const InitialValuesParameters &initial = parameters.initial_values;
      const Expression               velocity =
        read(parameters, "Initial values/Velocity", initial.velocity);
      const Expression displacement =
        read(parameters, "Initial values/Displacement", initial.displacement);
      return has_jump_in_x(
               [&](const double x) { return jet_in_x(velocity, x).value; }) ||
             has_jump_in_x(
               [&](const double x) { return jet_in_x(displacement, x).first; });
    }



    /**
     * Whether the traction on an end jumps, also at the start of a run. A mass
     * there makes it a force that accelerates.
     *
     * @param side 1: the end x = 1, -1: x = 0
     */
    bool
    has_jump_of_traction(const Parameters                   &parameters,
                         const int                           side,
                         const std::string                  &path,
                         const std::string                  &text,
                         const BoundaryParameters::Attached &attached)
    {
      if (attached.mass > 0.)
        return false;
      const double       end = side > 0 ? 1. : 0.;
      const TimeFunction traction(read(parameters, path, text),
                                  dealii::Point<1>(end));
      if (has_breaks(traction, parameters.time.end_time, false))
        return true;
      const InitialValuesParameters &initial = parameters.initial_values;
      const Expression               displacement =
        read(parameters, "Initial values/Displacement", initial.displacement);
      const Expression velocity =
        read(parameters, "Initial values/Velocity", initial.velocity);
      const double expected =
        traction.value(0.) -
        side * (attached.spring * jet_in_x(displacement, end).value +
                attached.dashpot * jet_in_x(velocity, end).value);
      const double     coupling = parameters.model.fields == "displacement" ?
                                    0. :
                                    parameters.model.coupling;
      const Expression temperature =
        read(parameters,
             "Initial values/Temperature",
             coupling == 0. ? "0" : initial.temperature);
      double                 stress = 0., largest = std::abs(expected);
      constexpr unsigned int n_places = 4;
      for (unsigned int i = 0; i <= n_places; ++i)
        {
          const double x       = i / static_cast<double>(n_places);
          const double strain  = jet_in_x(displacement, x).first;
          const double thermal = coupling * jet_in_x(temperature, x).value;
          if (x == end)
            stress = strain - thermal;
          largest = std::max({largest, std::abs(strain), std::abs(thermal)});
        }
      return std::abs(stress - expected) >
             Tolerances::rounding_of_data * largest;
    }



    /** Whether the velocity of the fixed end jumps, also at the start. */
    bool
    has_jump_of_velocity(const Parameters &parameters)
    {
      const std::string &motion = parameters.boundary.left.displacement;
      if (equal_values(motion, "0"))
        return false;
      const TimeFunction end(
        read(parameters, "Boundary/left/Displacement", motion));
      const double given = end.derivatives(0.).first;
      const double there = jet_in_x(read(parameters,
                                         "Initial values/Velocity",
                                         parameters.initial_values.velocity),
                                    0.)
                             .value;
      return std::abs(given - there) >
               Tolerances::continuous_velocity *
                 std::max(std::abs(given), std::abs(there)) ||
             has_breaks(end, parameters.time.end_time, true);
    }
  } // namespace



  bool
  has_fronts_of_data(const Parameters &parameters)
  {
    const BoundaryParameters &boundary = parameters.boundary;
    return parameters.dimension == 1 &&
           (has_jump_of_initial_values(parameters) ||
            has_jump_of_traction(parameters,
                                 1,
                                 "Boundary/right/Traction",
                                 boundary.right.traction,
                                 boundary.right) ||
            (boundary.left.is_free() &&
             has_jump_of_traction(parameters,
                                  -1,
                                  "Boundary/left/Traction",
                                  boundary.left.traction,
                                  boundary.left)) ||
            has_jump_of_velocity(parameters));
  }



  namespace
  {
    /**
     * Length over which an obstacle spreads the fronts that it makes: that of a
     * compliance, or of the wave of a mass on the end that swings on it. Zero
     * where the law says none, infinite where there is no obstacle.
     */
    double
    length_of_contact(const Parameters &parameters)
    {
      double shortest = infinity;
      for (const auto &law : parameters.make_contact_laws())
        {
          if (!law->is_active())
            continue;
          const double mass       = parameters.boundary.right.mass;
          const double compliance = law->tangent(0.);
          if (!(law->is_linear() || mass > 0.) || !std::isfinite(compliance))
            return 0.;
          shortest = std::min(shortest,
                              std::max(law->is_linear() ? compliance : 0.,
                                       2. * dealii::numbers::PI *
                                         std::sqrt(compliance * mass /
                                                   parameters.model.inertia)));
        }
      return shortest;
    }



    /** Length of the sharpest fronts; infinite: there are none. */
    double
    length_of_fronts(const Parameters &parameters)
    {
      return std::max(length_of_diffusion(parameters.model),
                      has_fronts_of_data(parameters) ?
                        0. :
                        length_of_contact(parameters));
    }



    /**
     * True if fronts pass through the body that are sharper than a mesh with
     * nodes @p spacing apart resolves.
     */
    bool
    has_sharp_fronts(const Parameters &parameters, const double spacing)
    {
      const double resolved = Tolerances::nodes_of_front * spacing;
      return length_of_diffusion(parameters.model) < resolved &&
             length_of_fronts(parameters) < resolved;
    }



    /**
     * Length of the layer in which viscosity spreads the pressure of the
     * hardest linear obstacle, (D7.3); infinite: there is none.
     */
    double
    length_of_layer(const Parameters &parameters)
    {
      double shortest = infinity;
      for (const auto &law : parameters.make_contact_laws())
        if (law->is_active() && law->is_linear() && law->tangent(0.) > 0.)
          shortest = std::min(shortest,
                              layer_of_impact(parameters.model.inertia,
                                              parameters.model.viscosity,
                                              law->tangent(0.)));
      return shortest;
    }



    /**
     * Whether waves that viscosity smooths leave a layer at their impact in
     * which the default mesh, where cells and degree are automatic, has too few
     * nodes.
     */
    bool
    has_thin_layer(const Parameters &parameters)
    {
      MeshParameters mesh = parameters.mesh;
      if (mesh.cells > 0 || mesh.degree > 0 ||
          !(parameters.model.inertia > 0.) ||
          parameters.model.fields == "temperature" ||
          parameters.boundary.right.mass > 0. ||
          !parameters.boundary.right.meets_obstacle())
        return false;
      mesh.cells  = MeshParameters::cells_by_default;
      mesh.degree = MeshParameters::degree_by_default;
      return length_of_diffusion(parameters.model) >=
               Tolerances::nodes_of_front * mesh.spacing() &&
             nodes_of_layer * mesh.contact_node_length() >
               length_of_layer(parameters);
    }



    unsigned int
    degree_for_fronts(const MeshParameters &mesh)
    {
      return mesh.degree > 0 ? mesh.degree : degree_of_fronts;
    }



    /**
     * Cells of the default scheme that resolve the layer of an impact and
     * fronts: with Tolerances::nodes_of_front nodes in the length over which
     * viscosity spreads these, and a contact node that it keeps from bouncing;
     * or else in the compliance that makes them. 0: a stage with them costs
     * more than a step of the scheme without dispersion.
     */
    unsigned int
    cells_of_fronts(const Parameters &written)
    {
      if (written.dimension > 1 || written.mesh.degree == 1)
        return 0;
      const ModelParameters &model    = written.model;
      const auto             laws     = written.make_contact_laws();
      const auto             softness = [](const auto &one) {
        return one->is_linear() ? one->tangent(0.) : 0.;
      };
      const auto     &law        = *std::min_element(laws.begin(),
                                          laws.end(),
                                          [&](const auto &a, const auto &b) {
                                            return softness(a) < softness(b);
                                          });
      Parameters      parameters = written;
      MeshParameters &mesh       = parameters.mesh;
      mesh.cells                 = 1;
      mesh.refinements           = 0; // of them, not instead of them
      mesh.degree                = degree_for_fronts(written.mesh);
      const double most          = stages_of_box *
                          cells_of_tolerance(written.time.tolerance) /
                          mesh.degree;
      // errors of the mesh fall like h^p
      const double tighter =
        std::pow(TimeParameters().tolerance / written.time.tolerance,
                 1. / mesh.degree);
      const auto cells_for = [&](const double n_nodes, const double length) {
        return std::max(1., tighter) * n_nodes / (mesh.degree * length);
      };
      const bool is_elastic =
        law->is_active() && law->is_linear() && law->tangent(0.) > 0.;
      const double of_layer = tighter * nodes_of_layer *
                              mesh.contact_node_length() /
                              length_of_layer(written);
      double of_compliance = infinity;
      if (is_elastic && written.contact.massless_nodes != "off" &&
          !has_fronts_of_data(written))
        of_compliance = cells_for(nodes_of_compliance, law->tangent(0.));
      double     of_viscosity = std::max(of_layer,
                                     cells_for(Tolerances::nodes_of_front,
                                               length_of_diffusion(model)));
      const auto whole        = [](const double cells) {
        return std::ceil(cells * (1. - Tolerances::rounding_of_data));
      };
      for (; law->is_active() && of_viscosity <= most; of_viscosity += 1.)
        {
          mesh.cells = of_viscosity = whole(of_viscosity);
          if (!contact_nodes_oscillate(parameters, *law))
            break;
        }
      const double cells =
        std::min(of_viscosity, std::max(of_layer, of_compliance));
      return cells <= most ? whole(cells) : 0;
    }



    /**
     * Why a scene has the default scheme on the default mesh; empty: there are
     * sharp fronts.
     */
    std::string
    reason_for_default(const Parameters &parameters)
    {
      const ModelParameters &model = parameters.model;
      if (model.fields == "temperature")
        return "there is no displacement";
      if (!(model.inertia > 0.))
        return "without inertia there are no waves";
      const MeshParameters &mesh = parameters.mesh;
      if (!has_sharp_fronts(
            parameters, (mesh.degree > 1 ? mesh : MeshParameters()).spacing()))
        return "all waves are smooth";
      return "";
    }



    /** The time in which a wave passes a cell, $h\sqrt b$. */
    double
    passage_of_cell(const Parameters &parameters)
    {
      return std::sqrt(parameters.model.inertia) /
             parameters.mesh.n_cells_along();
    }



    /**
     * The entries with this scheme, and all that follows from it.
     *
     * @param cells that resolve fronts, or that a run without dispersion can
     *   have, where they are automatic; 0: none, or those of the tolerance
     */
    SchemeChoice
    with_scheme(const Parameters  &written,
                const Scheme      &scheme,
                const std::string &reason,
                const unsigned int cells = 0)
    {
      SchemeChoice choice{written, {}, reason, false};
      Parameters  &parameters = choice.parameters;
      if (written.time.scheme == automatic_scheme)
        {
          parameters.time.scheme = scheme.name;
          choice.entries.push_back({"Time/Scheme", scheme.name});
        }
      const auto choose = [&](const std::string &path,
                              unsigned int      &count,
                              const unsigned int value) {
        if (count > 0)
          return;
        count = value;
        choice.entries.push_back({path, text(value)});
      };
      const bool is_box = scheme.has_no_dispersion;
      choose("Mesh/Cells",
             parameters.mesh.cells,
             cells > 0 ? cells :
             is_box    ? cells_of_tolerance(written.time.tolerance) :
                         MeshParameters::cells_by_default);
      choose("Mesh/Degree",
             parameters.mesh.degree,
             is_box    ? 1 :
             cells > 0 ? degree_of_fronts :
                         MeshParameters::degree_by_default);
      if (const double passage = passage_of_cell(parameters);
          is_box && !parameters.time.step_size && passage > 0.)
        parameters.time.step_size = passage;
      choice.has_unresolved_fronts =
        !is_box && parameters.model.fields != "temperature" &&
        parameters.model.inertia > 0. &&
        has_sharp_fronts(parameters, parameters.mesh.spacing());
      return choice;
    }
  } // namespace



  const std::string *
  SchemeChoice::find(const std::string &path) const
  {
    for (const ChosenEntry &entry : entries)
      if (entry.path == path)
        return &entry.value;
    return nullptr;
  }



  unsigned int
  cells_of_tolerance(const double tolerance)
  {
    const double cells = 2. / std::sqrt(tolerance);
    return std::max(fewest_cells,
                    multiple_of_cells * static_cast<unsigned int>(std::ceil(
                                          cells / multiple_of_cells)));
  }



  bool
  contact_nodes_oscillate(const Parameters &parameters, const ContactLaw &law)
  {
    const MeshParameters &mesh       = parameters.mesh;
    const double          b          = parameters.model.inertia;
    const double          w          = mesh.contact_node_length();
    const auto            compliance = law.compliance();
    if (parameters.boundary.right.mass > 0.)
      return false; // it is resolved as what it is
    return parameters.model.viscosity <
           (compliance ? 2. * w * std::sqrt(b * (1. + w / *compliance)) :
                         mesh.contact_spacing() * std::sqrt(b));
  }



  bool
  has_smooth_waves(const Parameters &parameters)
  {
    return parameters.model.fields == "temperature" ||
           !(parameters.model.inertia > 0.) ||
           length_of_diffusion(parameters.model) >=
             Tolerances::nodes_of_front * parameters.mesh.spacing();
  }



  namespace
  {
    /** Largest distance of nodes in the rods of a row. */
    double
    largest_spacing(const RowParameters &row, const unsigned int degree)
    {
      double largest = 0.;
      for (const BodyParameters &body : row.bodies)
        if (!body.is_mass())
          largest = std::max(largest, body.length / (body.cells * degree));
      return largest;
    }



    /** The scheme and the cells of a row of bodies. */
    SchemeChoice
    choose_scheme_of_row(const Parameters &written)
    {
      const bool is_automatic = written.time.scheme == automatic_scheme;
      const bool has_rods     = written.row.has_rods();
      const bool has_motion =
        written.model.inertia > 0. && written.model.fields != "temperature";
      const bool has_jumps = has_waves_or_impacts(written);
      const auto limits =
        is_automatic ? limits_of_box(written) : std::vector<BoxLimit>();
      const bool   is_box = is_automatic ?
                              has_jumps && limits.empty() :
                              scheme(written.time.scheme).has_no_dispersion;
      SchemeChoice choice{
        written,
        {},
        !is_automatic ?
          "" :
        is_box ?
          "bodies of a row have waves or impacts" :
        !has_motion ?
          "without inertia there are no waves" :
        !has_jumps ?
          "masses that are apart, with contacts that give way, have neither "
          "waves nor impacts" :
          "box cannot have " + limits.front().entry,
        false};
      Parameters &parameters = choice.parameters;
      if (is_automatic)
        {
          parameters.time.scheme = is_box ? find_scheme([](const Scheme &s) {
                                              return s.has_no_dispersion;
                                            })->name :
                                            default_scheme().name;
          choice.entries.push_back({"Time/Scheme", parameters.time.scheme});
        }
      MeshParameters &mesh = parameters.mesh;
      if (mesh.degree == 0)
        {
          mesh.degree =
            is_box || !has_rods ? 1 : MeshParameters::degree_by_default;
          choice.entries.push_back({"Mesh/Degree", text(mesh.degree)});
        }
      choose_row_cells(std::ldexp(mesh.cells > 0 ? mesh.cells :
                                  is_box         ? cells_of_tolerance(
                                             written.time.tolerance) :
                                           MeshParameters::cells_by_default,
                                  mesh.refinements),
                       is_box,
                       parameters);
      for (unsigned int i = 0; i < parameters.row.bodies.size(); ++i)
        if (const BodyParameters &body = parameters.row.bodies[i];
            body.cells != written.row.bodies[i].cells)
          {
            choice.entries.push_back(
              {"Bodies/" + body.name + "/Cells", text(body.cells)});
            choice.shares_cells = true;
          }
      if (choice.shares_cells) // beside these numbers it has no effect
        {
          choice.entries.push_back({"Mesh/Cells", "automatic"});
          choice.entries.push_back({"Mesh/Refinements", "0"});
        }
      mesh.cells       = resolve_row(parameters).cells.size();
      mesh.refinements = 0;
      choice.has_unresolved_fronts =
        !is_box && has_motion && has_rods &&
        length_of_diffusion(written.model) <
          Tolerances::nodes_of_front *
            largest_spacing(parameters.row, mesh.degree);
      if (is_box && !parameters.time.step_size && has_motion)
        if (const double passage = passage_of_row_cell(parameters);
            passage > 0.)
          parameters.time.step_size = passage;
      return choice;
    }



    /** The scheme and the cells of one body without parts. */
    SchemeChoice
    choose_scheme_of_body(const Parameters &written)
    {
      if (written.time.scheme != automatic_scheme)
        return with_scheme(written, scheme(written.time.scheme), "");
      const std::string  reason = reason_for_default(written);
      const unsigned int cells  = reason.empty() || has_thin_layer(written) ?
                                    cells_of_fronts(written) :
                                    0;
      if (!reason.empty())
        return with_scheme(written,
                           default_scheme(),
                           cells > 0 ?
                             "its mesh resolves the layer of an impact" :
                             reason,
                           cells);
      if (cells > 0 &&
          (written.mesh.cells == 0 || written.mesh.n_cells_along() >= cells))
        return with_scheme(written,
                           default_scheme(),
                           "its mesh resolves all fronts",
                           cells);
      if (const auto limits = limits_of_box(written); !limits.empty())
        return with_scheme(written,
                           default_scheme(),
                           "box cannot have " + limits.front().entry);
      const Scheme &box =
        *find_scheme([](const Scheme &s) { return s.has_no_dispersion; });
      const std::string reason_for_box =
        "waves are sharp, and nothing smooths them";
      const SchemeChoice choice     = with_scheme(written, box, reason_for_box);
      const Parameters  &parameters = choice.parameters;
      const double       n_steps =
        parameters.time.end_time / *parameters.time.step_size;
      const double excess =
        n_steps * parameters.mesh.n_cells_along() / Tolerances::most_cell_steps;
      if (excess <= 1.)
        return choice;
      // a smaller tolerance than the default one is to make nothing worse
      const unsigned int possible =
        parameters.mesh.cells / std::sqrt(excess) / multiple_of_cells;
      if (choice.find("Mesh/Cells") != nullptr && !written.time.step_size &&
          possible * multiple_of_cells >=
            cells_of_tolerance(TimeParameters().tolerance))
        return with_scheme(written,
                           box,
                           reason_for_box + "; cells as many as a run of some "
                                            "seconds can have",
                           possible * multiple_of_cells);
      return with_scheme(written,
                         default_scheme(),
                         "box would take " + about(n_steps) + " steps");
    }



    /** Cells end where the material jumps. */
    void
    end_cells_at_planes(SchemeChoice &choice)
    {
      MeshParameters &mesh      = choice.parameters.mesh;
      mesh.planes               = BodyProfile(choice.parameters).planes();
      const unsigned int fewest = mesh.planes[0].size() + 1;
      for (ChosenEntry &entry : choice.entries)
        if (entry.path == "Mesh/Cells" && mesh.cells < fewest)
          {
            mesh.cells  = fewest;
            entry.value = text(fewest);
          }
    }
  } // namespace



  SchemeChoice
  choose_scheme(const Parameters &written)
  {
    if (written.has_row())
      return choose_scheme_of_row(written);
    SchemeChoice choice = choose_scheme_of_body(written);
    if (written.has_material())
      end_cells_at_planes(choice);
    return choice;
  }
} // namespace ThermoContact
