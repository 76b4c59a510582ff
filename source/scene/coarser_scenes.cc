// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/number_text.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/method/scheme.h>
#include <thermocontact/scene/coarser_scenes.h>
#include <thermocontact/scene/scene.h>

#include <algorithm>
#include <cmath>

namespace ThermoContact
{
  namespace
  {
    constexpr double largest_tolerance = 0.1; // of the entry

    /** Degrees that can be lowered twice and still be of some order. */
    constexpr unsigned int smallest_high_degree = 4;

    /** By which the error falls at most from one degree to the next. */
    constexpr double smallest_rate_of_degrees = 0.03;

    /** The error of solutions with kinks falls like a power of the degree. */
    constexpr double smallest_rate_of_kinks = 0.5;

    bool
    has_joined_steps_and_cells(const Parameters &parameters)
    {
      return scheme(parameters.time.scheme).has_no_dispersion;
    }



    /** All entries that keep steps smaller than the tolerance does. */
    void
    scale_limits_of_steps(const double factor, Parameters &parameters)
    {
      TimeParameters &time = parameters.time;
      time.maximum_step_size *= factor;
      if (time.first_step_size)
        *time.first_step_size *= factor;
      parameters.output.period *= factor;
      if (parameters.output.land_on_times)
        for (double *const interval : {&parameters.output.fields_interval,
                                       &parameters.output.contact_interval,
                                       &parameters.output.space_time_interval})
          *interval *= factor;
    }



    /** @param factor of the tolerance or of the step size */
    CoarserScene
    with_steps(const Parameters &parameters,
               const double      factor,
               const double      step_factor,
               const double      weight)
    {
      CoarserScene    scene{parameters, "", weight};
      TimeParameters &time = scene.parameters.time;
      double &accuracy     = time.step_size ? *time.step_size : time.tolerance;
      accuracy *= factor;
      scale_limits_of_steps(step_factor, scene.parameters);
      scene.words =
        (time.step_size ? "Time/Step size = " : "Time/Tolerance = ") +
        significant(accuracy, 6);
      return scene;
    }



    /** Half as many cells of each rod; false if there are no fewer. */
    bool
    halve_cells_of_row(Parameters &parameters)
    {
      bool changes = false;
      for (BodyParameters &body : parameters.row.bodies)
        if (!body.is_mass())
          {
            const unsigned int fewest = RodProfile(parameters, body).n_parts();
            changes                   = changes || body.cells > fewest;
            body.cells                = std::max((body.cells + 1) / 2, fewest);
          }
      if (changes && has_joined_steps_and_cells(parameters))
        parameters.time.step_size.reset(); // it follows from the cells
      return changes;
    }



    /** Half as many cells along and across; false if there are no fewer. */
    bool
    halve_cells(Parameters &parameters)
    {
      if (parameters.has_row())
        return halve_cells_of_row(parameters);
      MeshParameters &mesh    = parameters.mesh;
      const double    spacing = mesh.contact_spacing();
      const bool      changes = mesh.halve(parameters.dimension);
      if (changes && has_joined_steps_and_cells(parameters) &&
          parameters.time.step_size)
        *parameters.time.step_size *= mesh.contact_spacing() / spacing;
      return changes;
    }



    std::string
    mesh_description(const Parameters &scene, const Parameters &original)
    {
      const MeshParameters &mesh = scene.mesh;
      std::string           words;
      const auto            add =
        [&words](const char *name, const double value, const double before) {
          if (value != before)
            words += (words.empty() ? "" : ", ") + std::string(name) + " = " +
                     significant(value, 6);
        };
      add("Mesh/Degree", mesh.degree, original.mesh.degree);
      add("Mesh/Refinements", mesh.refinements, original.mesh.refinements);
      add("Mesh/Cells", mesh.cells, original.mesh.cells);
      add("Mesh/Cells across",
          mesh.n_cells_across(),
          original.mesh.n_cells_across());
      for (unsigned int i = 0; scene.has_row() && i < scene.row.bodies.size();
           ++i)
        if (!scene.row.bodies[i].is_mass())
          add(("Bodies/" + scene.row.bodies[i].name + "/Cells").c_str(),
              scene.row.bodies[i].cells,
              original.row.bodies[i].cells);
      if (scene.time.step_size && original.time.step_size)
        add("Time/Step size", *scene.time.step_size, *original.time.step_size);
      return words;
    }
  } // namespace



  std::vector<CoarserScene>
  coarser_in_time(const Parameters &parameters)
  {
    const TimeParameters     &time = parameters.time;
    std::vector<CoarserScene> scenes;
    if (has_joined_steps_and_cells(parameters))
      return scenes;
    if (time.has_error_control())
      {
        // products with powers of ten may miss by rounding
        const double largest =
          largest_tolerance * (1. + Tolerances::rounding_of_data);
        // near the largest tolerance larger ones may not change the steps
        if (100. * time.tolerance > largest)
          scenes.push_back(with_steps(parameters, 0.1, 0.5, 1.5));
        if (10. * time.tolerance <= largest)
          scenes.push_back(with_steps(parameters, 10., 2., 0.5));
        if (100. * time.tolerance <= largest)
          scenes.push_back(with_steps(parameters, 100., 4., 0.05));
        return scenes;
      }
    if (time.n_steps() < 8)
      return {with_steps(parameters, 0.5, 0.5, 2.)};
    return {with_steps(parameters, 2., 2., 1.),
            with_steps(parameters, 4., 4., 1. / 3.)};
  }



  std::vector<CoarserScene>
  coarser_in_space(const Parameters &parameters)
  {
    std::vector<CoarserScene> scenes;
    CoarserScene              scene{parameters, "", 1.};
    // their errors leap from degree to degree, and are of no order on few cells
    const bool has_massless_nodes =
      Scene(parameters).contact.has_massless_nodes;
    for (unsigned int n = 0; n < 2; ++n)
      {
        MeshParameters &mesh = scene.parameters.mesh;
        scene.smallest_rate  = has_smooth_waves(parameters) ?
                                 smallest_rate_of_degrees :
                                 smallest_rate_of_kinks;
        if (parameters.mesh.degree >= smallest_high_degree &&
            !has_massless_nodes)
          --mesh.degree;
        else if (halve_cells(scene.parameters))
          // the error of the displacement is of this order
          scene.smallest_rate =
            std::pow(0.5, has_massless_nodes ? 1 : mesh.degree + 1);
        else
          {
            if (mesh.degree == 1)
              break;
            --mesh.degree;
          }
        scene.has_coarser_steps = has_joined_steps_and_cells(parameters);
        scene.words = mesh_description(scene.parameters, parameters);
        scenes.push_back(scene);
      }
    return scenes;
  }



  std::string
  reason_for_no_repeats(const Parameters &parameters)
  {
    if (!coarser_in_time(parameters).empty() ||
        !coarser_in_space(parameters).empty())
      return "";
    return parameters.has_masses_alone() ?
             "all bodies are rigid masses, which have no cells" :
             "there are no fewer cells";
  }



  std::string
  describe_repeats(const Parameters &parameters)
  {
    if (const std::string reason = reason_for_no_repeats(parameters);
        !reason.empty())
      return "none for error bars, since " + reason;
    std::string line = "for error bars, without files:";
    for (const auto &scenes :
         {coarser_in_time(parameters), coarser_in_space(parameters)})
      for (const CoarserScene &scene : scenes)
        line += (line.back() == ':' ? " " : "; ") + scene.words;
    return line + "; with these the run takes about 3 times as long";
  }
} // namespace ThermoContact
