// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/output_tables.h>

#include <deal.II/base/exceptions.h>

#include <fnmatch.h>

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
          "what is left between body and obstacle, g − u(1), g that of the time, "
          "negative for penetration of an elastic one; the smallest of the "
          "face, and of two stops"},
         {"penetration",
          "length",
          "into an elastic obstacle, by its law from the pressure; the largest "
          "of the face; 0 for a rigid one"},
         {"contact_force",
          "force",
          "pressure of the obstacle, its mean over the face; negative at a rear "
          "stop"},
         {"contact_impulse",
          "force × time",
          "sum of force times step size, and of impacts on a rigid obstacle, "
          "with its sign"},
         {"temperature_end", "temperature", "θ(1), above the reference"},
         {"heat_flux_end",
          "heat flux",
          "from the body to the obstacle, k (θ − θ_obs)"},
         {"energy",
          "energy",
          "of motion, strain, heat about the steady profile, and of an elastic "
          "obstacle, (M.8)"},
         {"dissipation",
          "energy",
          "by viscosity and heat, summed up from the start, (M.23)"},
         {"numerical_dissipation",
          "energy",
          "by the scheme, summed up, (M.24)"},
         {"in_contact",
          "",
          "1 if any node has pressure, with damped contact penetrates, else "
          "0"},
         {"iterations",
          "",
          "of the contact solver or of the fixed point, in the step"},
         {"work", "energy", "of loads and drives, summed up, (M.25)"},
         {"temperature_mean", "temperature", "over the body"},
         {"contact_area",
          "",
          "2-D, 3-D: part of the face whose pressure is positive"},
         {"max_pressure", "stress", "2-D, 3-D: the largest of the nodes"},
         {"min_gap",
          "length",
          "2-D, 3-D: the smallest g − u of the nodes, corners included"},
         {"moment_y",
          "force × length",
          "2-D, 3-D: mean of pressure times y from the axis"},
         {"moment_z", "force × length", "3-D: the same with z; else 0"},
         {"algebraic",
          "energy",
          "iterative solver: what residuals of linear systems do, summed up, "
          "(M.65); energy(0) + work + algebraic = energy + dissipation + "
          "numerical_dissipation in each row"},
         {"contact_dissipation",
          "energy",
          "damped contact: what the damping of the obstacle takes, summed up, "
          "(M.85); the right-hand side of that balance has it as well"},
         {"lateral_heat_flux",
          "heat flux",
          "lateral heat exchange: to the surroundings along the whole body, "
          "per cross-section, (M.102)"},
         {"lateral_dissipation",
          "energy",
          "lateral heat exchange: its part of dissipation, (M.105)"}}};
    }



    OutputTable
    event_table()
    {
      return {
        "events.csv",
        "Begins and ends of contact, where there is an obstacle, in order.",
        "column",
        {{"time", "time", "of the event; located where that is asked for"},
         {"kind", "", "`begin` or `end`; contact at t = 0 is a `begin`"},
         {"velocity",
          "velocity",
          "axial, of the contact end against the obstacle, u_t(1) − g′, before "
          "an impact, after a release; positive towards the obstacle at x = 1"},
         {"duration", "time", "of the contact that ends; `nan` of a `begin`"},
         {"side", "", "with `Contact/Rear gap`: `front` or `rear`"}}};
    }



    OutputTable
    attempt_table()
    {
      return {
        "steps.csv",
        "Every attempt at a step, with steps that are chosen.",
        "column",
        {{"time", "time", "at its beginning"},
         {"step_size", "time", "that was tried"},
         {"error", "", "estimated, in units of the tolerance; 1 is allowed"},
         {"accepted", "", "1 or 0"},
         {"reason",
          "",
          "of a step why it ends there: `ok` (as far as the error allows), "
          "`event`, `output`, `load` (a break), `end`; of others why it was "
          "not accepted: `tolerance`, `contact` (changes within it), `failed` "
          "(not solved)"},
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
      return {"poincare.csv",
              "The rows of contact.csv, whose columns it has, at the multiples "
              "of `Output/Period`, from t = 0 on; steps end there.",
              "column",
              {{"*", "", "as in contact.csv"}}};
    }



    OutputTable
    study_table()
    {
      return {
        "study.csv",
        "A row for each run of a study; those of key results have the meaning "
        "that they have in summary.json. Errors are those against the "
        "reference at the own step ends, absolute; `nan` without one.",
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
          "number, from 1, of the state of rest that is reached"}}};
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
        {{"contact_pressure", "stress", "not negative, but at a rear stop"},
         {"gap",
          "length",
          "what is left, g − u, g that of the time; of two stops, to the "
          "nearer one"},
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
} // namespace ThermoContact
