# SPDX-License-Identifier: LGPL-2.1-or-later
"""How often and how long a rod with an insulated end is in contact, by the mean of its
temperature (short_spans.prm), sampled each second: within two seconds."""
import sys

import numpy

sys.dont_write_bytecode = True
from run_files import Run  # noqa: E402

run = Run(sys.argv[1])
length, diffusivity, expansion, phase = 0.1, 53.3 / (7850 * 440), 12e-6, 0.48
time = numpy.arange(0, 604801)
mean = numpy.zeros(len(time))
for size, frequency in ((5, 7.27220521664304e-05), (1, 1.0388864595204343e-05)):
    m = numpy.sqrt(1j * frequency * length**2 / diffusivity)
    mean += numpy.imag(size * numpy.tanh(m) / m * numpy.exp(1j * (frequency * time + phase)))
# the stop behind the end meets the mirror image
gap = min(run.settings.number("Contact/Gap"), run.settings.number("Contact/Rear gap", 1))
touches = expansion * length * mean > gap
touches[time < 3600] = gap < 0  # before the initial temperature has gone
begins = int(touches[0]) + int(numpy.sum(touches[1:] & ~touches[:-1]))
summary = run.summary
faults = [name for name, found, expected, bound in (
    ("contact_begins", summary["contact_begins"], begins, 0),
    ("contact_duration", summary["contact_duration"], int(touches.sum()), 2))
          if not abs(found - expected) <= bound]
print(f"{begins} times, the shortest span of {600 * round(min(touches.sum(), (~touches).sum()) / 600)} s:",
      f"{', '.join(faults)} differ" if faults else "as derived")
