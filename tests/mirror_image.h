// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_mirror_image_h
#define thermocontact_tests_mirror_image_h

#include <thermocontact/simulation/simulation.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "row_checks.h"

namespace ThermoContact
{
  /**
   * The scene with the solution -u, doc/model.md (M4.3): the coupling and
   * mechanical data have the other sign, an obstacle in front is one behind.
   * Of a single obstacle the other one is out of reach. None where nothing
   * moves, where the obstacle moves or has a shape, as none behind does, and of
   * several bodies.
   */
  inline std::optional<Parameters>
  mirror_image(Parameters scene)
  {
    constexpr double out_of_reach = 100.;
    if (scene.model.fields == "temperature" || scene.row.bodies.size() > 1)
      return {};
    if (ContactParameters &contact = scene.contact; contact.condition != "none")
      {
        if (!contact.gap_expression.empty())
          return {};
        const double rear = contact.rear_gap.value_or(out_of_reach);
        contact.rear_gap  = std::exchange(contact.gap, rear);
        const ContactLawParameters front =
          contact.own_rear_law.instead_of(contact.law);
        for (const auto &[name, value] : std::exchange(contact.law, front))
          contact.own_rear_law.numbers[name] = value;
      }
    scene.model.coupling *= -1.;
    std::vector<std::string *> values = {&scene.initial_values.displacement,
                                         &scene.initial_values.velocity,
                                         &scene.sources.body_force,
                                         &scene.boundary.left.displacement,
                                         &scene.boundary.left.traction,
                                         &scene.boundary.right.traction};
    for (BodyParameters &body : scene.row.bodies)
      {
        values.push_back(&body.displacement);
        values.push_back(&body.velocity);
      }
    for (std::string *const value : values)
      if (*value != "0")
        *value = "-(" + *value + ')';
    return scene;
  }



  /** Rows of a run, with columns that have the sign of u times @p sign. */
  inline Columns
  signed_table(std::vector<StepRecord> rows, const double sign)
  {
    for (StepRecord &r : rows)
      for (double *const value : {&r.displacement_end,
                                  &r.displacement_mid,
                                  &r.velocity_end,
                                  &r.stress_end,
                                  &r.contact_force,
                                  &r.contact_impulse})
        *value *= sign;
    return table_of(rows);
  }



  /** Times, sides, kinds and velocities. */
  inline Columns
  signed_table(const std::vector<ContactEvent> &events, const double sign)
  {
    Columns table = {{0., 0., 0., 0.}}; // there may be no event
    for (const ContactEvent &event : events)
      table.push_back({event.time,
                       sign * event.side,
                       event.kind == ContactEvent::begin ? 1. : 0.,
                       sign * event.velocity});
    return table;
  }



  /** The mirror images of the runs of a test. */
  class MirrorImages
  {
  public:
    /** simulation.run(@p observers), and its mirror image, if there is one. */
    template <int dim>
    void
    run(Simulation<dim>                                &simulation,
        std::vector<typename Simulation<dim>::Observer> observers = {})
    {
      std::vector<StepRecord> rows, mirrored_rows;
      const auto              record_in = [](std::vector<StepRecord> &all) {
        return [&all](const Simulation<dim> &s) { all.push_back(s.record()); };
      };
      observers.push_back(record_in(rows));
      simulation.run(observers);
      const auto image = mirror_image(simulation.parameters());
      if (!image)
        return;
      Simulation<dim> mirrored(*image, MPI_COMM_SELF);
      mirrored.run({record_in(mirrored_rows)});
      ++n_runs;
      raise(largest,
            difference(signed_table(rows, 1.),
                       signed_table(mirrored_rows, -1.)));
      raise(largest,
            difference(signed_table(simulation.events(), 1.),
                       signed_table(mirrored.events(), -1.)));
    }

    /** Their number, and the largest difference of a column. */
    std::string
    words(const double bound) const
    {
      return std::to_string(n_runs) +
             " mirror images: " + noise_within(largest, bound);
    }

  private:
    unsigned int n_runs  = 0;
    double       largest = 0.;
  };
} // namespace ThermoContact

#endif
