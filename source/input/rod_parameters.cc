// SPDX-License-Identifier: LGPL-2.1-or-later

// The section that makes a file one in SI units.

#include <thermocontact/input/parameters.h>
#include <thermocontact/input/section_of_entries.h>

#include <deal.II/base/patterns.h>

namespace ThermoContact
{
  void
  RodParameters::add_parameters(ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    const Double     positive(0., 1e30);
    SectionOfEntries entry(prm, "Rod");
    entry("Length", length, positive)
      .means(
        "Length L of the body, m. A file with this section is in SI units; "
        "0: there is none.",
        "length");
    entry.unbound("Cross-section area", "0", positive)
      .means("Area A of the cross-section, m^2.", "area");
    entry.unbound("Density", "0", positive)
      .means("Density rho, kg/m^3.", "density");
    entry.unbound("Young's modulus", "0", positive)
      .means("Young's modulus E, Pa.", "stress");
    entry.unbound("Poisson ratio", "0", Double(-0.999, 0.4999))
      .means("Poisson ratio nu, for confined lateral sides and Dimension > 1.");
    entry.unbound("Lateral sides", "free", Selection("free|confined"))
      .means("For Dimension = 1: free, a thin rod, whose stiffness is Young's "
             "modulus; or confined, no lateral strain: that of P-waves.");
    entry.unbound("Viscosity", "0", positive)
      .means("Kelvin-Voigt viscosity eta, Pa s: stress eta u_xt.", "viscosity");
    entry.unbound("Linear expansion", "0", Double(-1., 1.))
      .means("Coefficient alpha of linear thermal expansion, 1/K.",
             "thermal expansion");
    entry.unbound("Conductivity", "0", positive)
      .means("Heat conductivity kappa, W/(m K).", "conductivity");
    entry.unbound("Heat capacity", "0", positive)
      .means("Specific heat capacity c, J/(kg K).", "heat capacity");
    entry.unbound("Reference temperature", "0", positive)
      .means("Temperature of the body without stress, K; that of the body, the "
             "obstacle and the surroundings unless they are given.",
             "temperature");
    entry
      .unbound("Small terms", "automatic", Selection("automatic|kept|dropped"))
      .means(
        "Inertia and viscosity: kept, dropped, or automatic: dropped where "
        "their times, that of a wave through the body and that of "
        "relaxation, are below 1e-5 of the run, which has no initial "
        "velocity, moving end or rear stop.");
  }
} // namespace ThermoContact
