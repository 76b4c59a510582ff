// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/output_tables.h>
#include <thermocontact/report/output_reference.h>

namespace ThermoContact
{
  std::string
  output_reference()
  {
    std::string page =
      R"(# What a run writes

Every file of an output directory and every name in it, as `thermocontact --print-output` prints them. Numbers are
nondimensional, or in SI units if the scene has section `Rod` or `Scales`, unless `Output/SI = false`: then a comment line
`# units:` above the names of a CSV file has the unit of each column, `units` of summary.json that of each key, and a VTU
file those of its arrays. Times have the unit of `Time/End time`. Extensive quantities of a strip or a block are per unit cross-section, so that they are those of the rod.
`nan` (in JSON `null`) is what the scene does not have. Where events are located, each begin and end of contact is the end
of a step, and has a row.

All CSV files have the same head, comment lines that begin with `#` (title, versions, units, places of probes) and a line of names:

```python
import numpy
rows = [line for line in open("contact.csv") if line[0] != "#"]
table = numpy.genfromtxt(rows, delimiter=",", names=True, dtype=None, encoding="utf-8")
```

```python
import pandas
table = pandas.read_csv("contact.csv", comment="#")
```

`used.prm` has every entry of the run, and runs it again; `checkpoint.bin` and `checkpoint.previous.bin` are for `--resume`; `log.txt` is the screen.
)";
    for (const OutputTable &table : output_tables())
      {
        page += "\n## " + table.file + "\n\n" + table.text + "\n\n| " +
                table.kind + " | unit | meaning |\n|---|---|---|\n";
        for (const OutputTerm &term : table.terms)
          page +=
            "| `" + term.name + "` | " + term.kind + " | " + term.text + " |\n";
      }
    return page;
  }
} // namespace ThermoContact
