// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/output_tables.h>

#include <utility>

namespace ThermoContact
{
  OutputTable
  summary_table()
  {
    OutputTable table = {
      "summary.json",
      "The run in one object, written when it ends, also when it fails. "
      "Keys `predicted_*` were known before the run (doc/model.md, "
      "forecasts); `null` is what is not known.",
      "key",
      {{"title", "", "entry `Title`"},
       {"status", "", "`done`, `failed: ` or `interrupted: ` and why"},
       {"version", "", "of the program and of deal.II"},
       {"dimension", "", "1, 2, 3"},
       {"ranks", "", "processes"},
       {"fields", "", "that are computed"},
       {"terms", "", "of the equations that the scene has"},
       {"dofs", "", "unknowns of temperature and displacement"},
       {"factorized_unknowns",
        "",
        "of the largest matrix that is factorised; with the iterative solver "
        "of the coarsest level, 0 if it has algebraic multigrid"},
       {"scheme", "", "entry `Time/Scheme`"},
       {"linear_solver",
        "",
        "`block tridiagonal` (rods), `direct` (sparse factors), both where "
        "blocks grow, or `iterative`"},
       {"steps", "", "accepted"},
       {"rejected_steps", "", "attempts that were not accepted"},
       {"factorizations",
        "",
        "of all matrices; with the iterative solver preconditioners made"},
       {"responses", "", "of the body to a unit load at a contact node"},
       {"solves", "", "of stages"},
       {"linear_iterations", "", "of GMRES, all"},
       {"max_linear_iterations", "", "of one linear system"},
       {"active_set_iterations",
        "",
        "sets of active contact nodes for which the iterative solver solved"},
       {"contact_begins", "", "how often contact began, by events.csv"},
       {"first_contact_time", "time", "of the first event"},
       {"contact_duration", "time", "in contact altogether"},
       {"contact_impulse", "force × time", "of contact.csv at the end"},
       {"restitution",
        "",
        "velocity of the last release over that of the first impact, positive "
        "for a body that comes back"},
       {"max_penetration", "length", "over all steps, not only all rows"},
       {"max_contact_force",
        "force",
        "over all steps; the largest magnitude of two obstacles"},
       {"final_time", "time", "that was reached"},
       {"final_displacement_end", "length", "of contact.csv at the end"},
       {"final_energy", "energy", "likewise"},
       {"max_energy_increase",
        "energy",
        "largest of a step, beyond the work; what the scheme creates"},
       {"set_up_seconds", "s", "before the time loop"},
       {"loop_seconds", "s", "time loop, without snapshots"},
       {"step_seconds", "s", "of these, attempts at steps"},
       {"factorization_seconds", "s", "of these, factorisations"},
       {"solve_seconds", "s", "of these, solves"},
       {"contact_seconds", "s", "of these, contact and responses"},
       {"output_seconds", "s", "snapshots and checkpoints"},
       {"wall_seconds",
        "s",
        "from the start of the program; of a run of a study, from its own"},
       {"units",
        "",
        "of the keys that have one, an object; a scene with `Scales` and "
        "`Output/SI`"},
       {"peak_memory_mb", "MB", "of all ranks, each at its largest"},
       {"peak_memory_mb_per_rank", "MB", "a list"},
       {"warnings", "", "all that were shown, a list"},
       {"final_contact_force", "force", "of contact.csv at the end"},
       {"final_temperature_end", "temperature", "likewise"},
       {"final_in_contact", "", "likewise, `true` or `false`"},
       {"predicted_displacement_end",
        "length",
        "of the steady state, the nearest one to the end, (M.10)"},
       {"predicted_contact_force", "force", "likewise"},
       {"predicted_temperature_end", "temperature", "likewise"},
       {"predicted_in_contact", "", "likewise"},
       {"predicted_remark", "", "why there is none, or how it is reached"},
       {"difference_displacement_end", "length", "end less steady state"},
       {"difference_contact_force", "force", "likewise"},
       {"difference_temperature_end", "temperature difference", "likewise"},
       {"predicted_first_contact_time", "time", "of the first impact"},
       {"predicted_first_penetration", "length", "peak of the first contact"},
       {"predicted_critical_step_size",
        "time",
        "below which the paper's iteration contracts"},
       {"predicted_steps", "", "that the run was expected to take"},
       {"states_of_rest",
        "",
        "heat exchange that depends on the contact: all steady states, objects "
        "with `displacement_end`, `contact_force`, `temperature_end`, "
        "`in_contact`, `is_stable`"},
       {"reached_state_of_rest",
        "",
        "likewise: number, from 1, of the one that is reached"}}};
    for (const auto &[key, kind] :
         {std::pair("first_contact_time", "time"),
          std::pair("max_contact_force", "force"),
          std::pair("max_penetration", "length"),
          std::pair("contact_impulse", "force × time"),
          std::pair("final_displacement_end", "length"),
          std::pair("final_temperature_end", "temperature difference")})
      for (const auto &[error, text] :
           {std::pair("_time_error",
                      "with `Output/Error bars`: how far the steps may have "
                      "moved it (doc/numerics.md); `null` if not known"),
            std::pair("_space_error", "likewise, the mesh")})
        table.terms.push_back({std::string(key) + error, kind, text});
    return table;
  }
} // namespace ThermoContact
