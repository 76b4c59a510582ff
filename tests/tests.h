// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_tests_h
#define thermocontact_tests_h

#include <thermocontact/contact/contact_law.h>
#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/simulation/measurements.h>

#include <deal.II/base/logstream.h>
#include <deal.II/base/parameter_handler.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

using dealii::deallog;

/** Sends deallog into the file that the test harness compares. */
void
initlog();



/** Raises @p largest to @p value; a NaN counts as infinitely large. */
inline void
raise(double &largest, const double value)
{
  if (!(value <= largest))
    largest =
      std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
}



/**
 * A value that must not exceed its bound, with both, "3e-13 <= 1e-09"; one that
 * does says so in a word, since numdiff passes over '>'. Of the value the first
 * digit alone: numdiff accepts any change of a number below 1e-6, which is
 * rounding, and larger ones are errors of the method, whose first digit is the
 * same on every machine.
 */
std::string
within(const double value, const double bound);

/**
 * The same for what is rounding alone and too large for numdiff to pass: the
 * value is shown if it is above the bound.
 */
std::string
noise_within(const double value, const double bound);



/** All columns of contact.csv but the two counters. */
inline std::array<double, 18>
all_columns(const ThermoContact::StepRecord &r)
{
  return {{r.time,
           r.step_size,
           r.displacement_end,
           r.displacement_mid,
           r.velocity_end,
           r.stress_end,
           r.gap,
           r.penetration,
           r.contact_force,
           r.contact_impulse,
           r.temperature_end,
           r.heat_flux_end,
           r.energy,
           r.dissipation,
           r.numerical_dissipation,
           static_cast<double>(r.in_contact),
           r.work,
           r.temperature_mean}};
}



/**
 * The parameters of a published file, e.g. "paper/experiment-1.prm", with
 * overrides 'Section/Entry=value' and all checks that the program makes.
 */
ThermoContact::Parameters
read_parameters(const std::string              &name,
                const std::vector<std::string> &overrides = {});



/** The law of an obstacle: rigid if @p compliance is 0, else with damping. */
std::unique_ptr<const ThermoContact::ContactLaw>
make_law(const double compliance, const double damping = 0.);

#endif
