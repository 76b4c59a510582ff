// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/output_tables.h>

#include <deal.II/base/exceptions.h>

#include <fnmatch.h>

#include <utility>

namespace ThermoContact
{
  namespace
  {
    OutputTable
    contact_table()
    {
      return {
        "contact.csv",
        "The state and the balances, a row for the initial state and for each "
        "step, or every `Output/Contact interval`. In two and three dimensions "
        "values at the contact end are means over it unless it says otherwise.",
        "column",
        {{"step", "", "number of the step, 0 for the initial state"},
         {"time", "time", "at the end of the step"},
         {"step_size", "time", "of the step; 0 for the initial state"},
         {"displacement_end", "length", "axial, u(1)"},
         {"displacement_mid",
          "length",
          "axial, of the middle, u(1/2); on the axis"},
         {"velocity_end",
          "velocity",
          "axial, of the scheme; `nan` where a body without inertia and "
          "viscosity has none"},
         {"stress_end",
          "stress",
          "at the contact end, end traction less pressure; tension is positive"},
         {"gap",
          "length",
          "between body and obstacle, g(t) − u(1); negative: penetration of an "
          "elastic obstacle; the smallest over the contact face and both "
          "obstacles"},
         {"penetration",
          "length",
          "of an elastic obstacle, from the pressure by its law; the largest "
          "over the contact face; 0 for a rigid one"},
         {"contact_force",
          "force",
          "mean pressure of the obstacle over the contact face; negative at a "
          "rear obstacle"},
         {"contact_impulse",
          "force × time",
          "time integral of the force, with the impulses of impacts on a rigid "
          "obstacle"},
         {"temperature_end", "temperature", "θ(1), above the reference"},
         {"heat_flux_end",
          "heat flux",
          "from the body to the obstacle, k (θ − θ_obs)"},
         {"energy",
          "energy",
          "of motion, strain, heat about the steady state, and of an elastic "
          "obstacle, (M.8)"},
         {"dissipation",
          "energy",
          "by viscosity and heat, summed up from the start, (M.23)"},
         {"numerical_dissipation",
          "energy",
          "by the scheme, summed up, (M.24)"},
         {"in_contact",
          "",
          "1 if any node has pressure (damped obstacle: penetration), else 0"},
         {"iterations",
          "",
          "of the contact solver or of the paper's iteration, in the step"},
         {"work", "energy", "of loads and drives, summed up, (M.25)"},
         {"temperature_mean", "temperature", "over the body"},
         {"contact_area",
          "",
          "2-D, 3-D: part of the contact face that has pressure"},
         {"max_pressure", "stress", "2-D, 3-D: the largest of all nodes"},
         {"min_gap",
          "length",
          "2-D, 3-D: the smallest g − u of the nodes, corners included"},
         {"moment_y",
          "force × length",
          "2-D, 3-D: mean of pressure times y from the axis"},
         {"moment_z", "force × length", "3-D: the same with z; else 0"},
         {"algebraic",
          "energy",
          "iterative solver: energy that residuals of linear systems bring in, "
          "summed up, (M.65); in each row energy(0) + work + algebraic = energy "
          "+ dissipation + numerical_dissipation + contact_dissipation"},
         {"contact_dissipation",
          "energy",
          "damped obstacle: what it dissipates, summed up, (M.85)"},
         {"lateral_heat_flux",
          "heat flux",
          "lateral heat exchange: to the surroundings along the body, per "
          "cross-section, (M.102)"},
         {"lateral_dissipation",
          "energy",
          "lateral heat exchange: its part of dissipation, (M.105)"}}};
    }



    OutputTable
    event_table()
    {
      return {
        "events.csv",
        "Begins and ends of contact in the order of time.",
        "column",
        {{"time",
          "time",
          "of the event; located if `Time/Locate contact events`"},
         {"kind", "", "`begin` or `end`; contact at t = 0 is a `begin`"},
         {"velocity",
          "velocity",
          "axial, of the contact end relative to the obstacle, u_t(1) − g′; at "
          "a `begin` before the impact, at an `end` after the release; positive "
          "towards the front obstacle"},
         {"duration", "time", "of the contact that ends; `nan` of a `begin`"},
         {"side", "", "with `Contact/Rear gap`: `front` or `rear`"}}};
    }



    OutputTable
    attempt_table()
    {
      return {
        "steps.csv",
        "Every attempt at a step, with error-controlled steps.",
        "column",
        {{"time", "time", "at its beginning"},
         {"step_size", "time", "that was tried"},
         {"error", "", "estimated, in units of the tolerance; 1 is allowed"},
         {"accepted", "", "1 or 0"},
         {"reason",
          "",
          "accepted: why the step ends there, `ok` (by the error), `event`, "
          "`output`, `load` (discontinuity or kink of an input), `end`; else why "
          "not: `tolerance`, `contact` (changes within it), `failed` (not "
          "solved)"},
         {"wall_seconds", "s", "that the attempt took"}}};
    }



    OutputTable
    probe_table()
    {
      return {"probes.csv",
              "The fields at the places of `Output/Probes`, which the head "
              "lists, a row for each row of contact.csv. * is the number of "
              "the place, from 1.",
              "column",
              {{"time", "time", "of the row"},
               {"temperature_*", "temperature", "θ"},
               {"displacement_*", "length", "axial"},
               {"velocity_*", "velocity", "axial"},
               {"stress_*", "stress", "axial; tension is positive"}}};
    }



    OutputTable
    poincare_table()
    {
      return {
        "poincare.csv",
        "Rows as in contact.csv at the multiples of `Output/Period`, from "
        "t = 0 on; steps end there.",
        "column",
        {{"*", "", "as in contact.csv"}}};
    }



    OutputTable
    study_table()
    {
      return {
        "study.csv",
        "A row for each run of a study; key results are those of summary.json. "
        "Errors are absolute, against the reference at the step ends of the "
        "run; `nan` without a reference.",
        "column",
        {{"run", "", "number of the run, from 0"},
         {"*/*", "", "value of an entry that the study varies"},
         {"status", "", "`done`, or `failed: ` and why"},
         {"dofs", "", "unknowns"},
         {"steps", "", "accepted"},
         {"rejected_steps", "", "attempts that were not accepted"},
         {"factorizations", "", "of matrices; preconditioners made"},
         {"solves", "", "of stages"},
         {"loop_seconds", "s", "of the time loop; the least of repetitions"},
         {"error_displacement_end", "length", "largest over time"},
         {"error_velocity_end", "velocity", "likewise"},
         {"error_contact_force", "force", "likewise"},
         {"error_temperature_end", "temperature difference", "likewise"},
         {"error_first_contact_time", "time", "of the first event"},
         {"error_energy", "energy", "largest over time"},
         {"loop_seconds_median", "s", "the median of repetitions"},
         {"final_error_displacement_end", "length", "at the end time"},
         {"final_error_velocity_end", "velocity", "likewise"},
         {"final_error_contact_force", "force", "likewise"},
         {"final_error_temperature_end", "temperature difference", "likewise"},
         {"final_error_energy", "energy", "likewise"},
         {"first_contact_time", "time", "of the first event"},
         {"contact_begins", "", "how often contact began"},
         {"contact_duration", "time", "in contact altogether"},
         {"max_contact_force", "force", "over all steps, as in summary.json"},
         {"max_penetration", "length", "over all steps"},
         {"contact_impulse", "force × time", "at the end"},
         {"restitution", "", "as in summary.json"},
         {"final_displacement_end", "length", "at the end"},
         {"final_temperature_end", "temperature", "at the end"},
         {"reached_state_of_rest",
          "",
          "number, from 1, of the steady state that is reached"}}};
    }



    OutputTable
    field_table()
    {
      return {
        "fields/fields-*.vtu",
        "Snapshots of the body; `fields.pvd` opens all at their times. Cells "
        "of degree p are cut into p parts along each direction; single "
        "precision.",
        "array",
        {{"temperature", "temperature", "θ"},
         {"displacement", "length", "a vector in space; a rod's is axial"},
         {"velocity", "velocity", "likewise"},
         {"stress",
          "stress",
          "with its viscous part; of a rod axial, else a tensor in space"},
         {"TIME", "time", "of the snapshot, field data of the file"},
         {"CYCLE", "", "its number, likewise; 0 is left out"}}};
    }



    OutputTable
    face_table()
    {
      return {
        "fields/contact-*.vtu",
        "The contact end of a strip or a block at the times of the "
        "snapshots; `contact.pvd`.",
        "array",
        {{"contact_pressure", "stress", "negative at a rear obstacle"},
         {"gap", "length", "g(t) − u; to the nearer one of two obstacles"},
         {"in_contact", "", "1 where there is pressure, else 0"},
         {"temperature", "temperature", "θ"},
         {"TIME", "time", "of the snapshot, field data of the file"},
         {"CYCLE", "", "its number, likewise; 0 is left out"}}};
    }



    OutputTable
    obstacle_table()
    {
      return {
        "obstacle.vtu",
        "An obstacle with a shape (`Contact/Gap` an expression in y, z), "
        "and the rear stop, if there is one. An obstacle that moves is in "
        "`fields/obstacle-*.vtu`, one file for each snapshot, which "
        "`obstacle.pvd` opens at their times.",
        "array",
        {{"gap", "length", "g of the time, without displacement"},
         {"displacement",
          "length",
          "that moves a copy of the end to the obstacle"}}};
    }



    OutputTable
    space_time_table()
    {
      return {"space-time.vtu",
              "All of a rod over x and t, with `Output/Space-time interval`; "
              "of a body its axis. `space-time.columns` has what of it is "
              "written while the run goes on.",
              "array",
              {{"temperature", "temperature", "θ"},
               {"displacement", "length", "axial"},
               {"velocity", "velocity", "axial"},
               {"stress", "stress", "axial, with its viscous part"}}};
    }
  } // namespace



  const std::vector<OutputTable> &
  output_tables()
  {
    static const std::vector<OutputTable> tables = {contact_table(),
                                                    event_table(),
                                                    attempt_table(),
                                                    probe_table(),
                                                    poincare_table(),
                                                    summary_table(),
                                                    study_table(),
                                                    field_table(),
                                                    face_table(),
                                                    obstacle_table(),
                                                    space_time_table()};
    return tables;
  }


  const std::string &
  kind_of(const std::string &file, const std::string &name)
  {
    for (const OutputTable &table : output_tables())
      if (table.file == file)
        for (const OutputTerm &term : table.terms)
          if (fnmatch(term.name.c_str(), name.c_str(), 0) == 0)
            return term.kind;
    AssertThrow(false, dealii::ExcMessage(file + ": " + name + " has no text"));
    return file; // not reached
  }



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
