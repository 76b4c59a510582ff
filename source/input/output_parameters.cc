// SPDX-License-Identifier: LGPL-2.1-or-later

// The sections that say what a run, or a study, leaves behind.

#include <thermocontact/input/parameters.h>
#include <thermocontact/input/section_of_entries.h>

#include <deal.II/base/patterns.h>

namespace ThermoContact
{
  namespace
  {
    using namespace dealii::Patterns;

    const Double non_negative_time(0., 1e15);
  } // namespace



  void
  OutputParameters::add_parameters(ParameterHandler &prm)
  {
    SectionOfEntries entry(prm, "Output");
    entry("Directory", directory)
      .means("Output directory; empty: results/<name of the parameter file>.");
    entry("Fields interval", fields_interval, non_negative_time)
      .means("Fields (VTU) are written at the first step end at or after each "
             "multiple of this time, and at T; 0: none.",
             "time");
    entry("Contact interval", contact_interval, non_negative_time)
      .means("Rows of contact.csv are written at the first step end at or "
             "after each multiple of this time, and at T; 0: every step.",
             "time");
    entry("Probes", probes)
      .means("Positions, separated by ';', the coordinates of each by ',': "
             "histories of the fields there (probes.csv), in the rows of "
             "contact.csv. Empty: none.",
             "length");
    entry("Space-time interval", space_time_interval, non_negative_time)
      .means("The fields on the axis are kept at the first step end at or "
             "after each multiple of this time, and at T, for one picture over "
             "x and t (space-time.vtu); 0: none.",
             "time");
    entry("Period", period, non_negative_time)
      .means("Period P of a drive: steps end at its multiples, and "
             "poincare.csv has a row of contact.csv for each of them; 0: none.",
             "time");
    entry("Land on output times", land_on_times)
      .means("Steps are shortened to end on the multiples of the intervals; "
             "costs solves.");
    entry("Checkpoint interval", checkpoint_interval, Double(0., 1e9))
      .means("Wall-clock seconds between checkpoints, from which --resume goes "
             "on; also at the start and the end; 0: none, but for one when "
             "SIGTERM, SIGINT or SIGHUP ends the run.",
             "s");
    entry("SI", is_si)
      .means("Files and screen in SI units, if section Rod or Scales is given; "
             "false: nondimensional.");
    entry("Error bars", has_error_bars)
      .means("Repeats the run with larger steps and on coarser meshes, without "
             "files, and says how far the key results may be wrong by either "
             "(screen, summary.json); about three times the time.");
  }



  void
  StudyParameters::add_parameters(ParameterHandler &prm)
  {
    SectionOfEntries entry(prm, "Study");
    entry("Vary", vary)
      .means("Runs the scene for all combinations of values: Section/Entry = "
             "value | value ; Section/Entry = value | ... . Values may be "
             "ranges, 0.6 .. 2.6 (61) or 1e-3 .. 1 (7 log), and those of a "
             "constant, Constants/omega. Entries that go together, as many "
             "values of each, are separated by ',': A = a1 | a2 , B = b1 | b2. "
             "Several sets of combinations are separated by ';;'. Values "
             "cannot hold '|' or ';'. Empty: runs once.");
    entry("Reference", reference)
      .means("none, or overrides Section/Entry = value ; ... for the run that "
             "errors are measured against.");
    entry("Repetitions", repetitions, Integer(1, 1000))
      .means("Number of times that each run is made, for timing.");
    entry("Target error", target_error, non_negative_time)
      .means("Largest error of displacement_end that is wanted: the cheapest "
             "run that meets it is named; 0: none.",
             "length");
    entry("Keep files", keep_files)
      .means("Each run writes its files into a folder of its own.");
  }
} // namespace ThermoContact
