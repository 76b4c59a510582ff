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
    entry("Cross-section area", area, positive)
      .means("Area A of the cross-section, m^2.", "area");
    entry("Density", density, positive)
      .means("Density rho, kg/m^3.", "density");
    entry("Young's modulus", youngs_modulus, positive)
      .means("Young's modulus E, Pa.", "stress");
    entry("Poisson ratio", poisson_ratio, Double(-0.999, 0.4999))
      .means("Poisson ratio nu, for confined lateral sides and Dimension > 1.");
    entry("Lateral sides", lateral_sides, Selection("free|confined"))
      .means("For Dimension = 1: free, a thin rod, whose stiffness is Young's "
             "modulus; or confined, no lateral strain: that of P-waves.");
    entry("Viscosity", viscosity, positive)
      .means("Kelvin-Voigt viscosity eta, Pa s: stress eta u_xt.", "viscosity");
    entry("Linear expansion", linear_expansion, Double(-1., 1.))
      .means("Coefficient alpha of linear thermal expansion, 1/K.",
             "thermal expansion");
    entry("Conductivity", conductivity, positive)
      .means("Heat conductivity kappa, W/(m K).", "conductivity");
    entry("Heat capacity", heat_capacity, positive)
      .means("Specific heat capacity c, J/(kg K).", "heat capacity");
    entry("Reference temperature", reference_temperature, positive)
      .means("Temperature of the body without stress, K; that of the body, the "
             "obstacle and the surroundings unless they are given.",
             "temperature");
    entry("Small terms", small_terms, Selection("automatic|kept|dropped"))
      .means(
        "Inertia and viscosity: kept, dropped, or automatic: dropped where "
        "their times, that of a wave through the body and that of "
        "relaxation, are below 1e-5 of the run, which has no initial "
        "velocity, moving end or rear stop.");
  }
} // namespace ThermoContact
