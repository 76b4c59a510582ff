// SPDX-License-Identifier: LGPL-2.1-or-later

// The section that makes a file one in SI units.

#include <thermocontact/input/parameters.h>

#include <deal.II/base/patterns.h>

namespace ThermoContact
{
  void
  RodParameters::add_parameters(ParameterHandler &prm)
  {
    using namespace dealii::Patterns;
    const auto add = [&prm](const std::string &name,
                            const std::string &text,
                            double            &member,
                            const Double      &pattern = Double(0., 1e30)) {
      prm.add_parameter(name, member, text, pattern);
    };
    prm.enter_subsection("Rod");
    add("Length",
        "Length L of the body, m. A file with this section is in SI units; 0: "
        "there is none.",
        length);
    add("Cross-section area", "Area A of the cross-section, m^2.", area);
    add("Density", "Density rho, kg/m^3.", density);
    add("Young's modulus", "Young's modulus E, Pa.", youngs_modulus);
    add("Poisson ratio",
        "Poisson ratio nu, for confined lateral sides and Dimension > 1.",
        poisson_ratio,
        Double(-0.999, 0.4999));
    prm.add_parameter("Lateral sides",
                      lateral_sides,
                      "For Dimension = 1: free, a thin rod, whose stiffness is "
                      "Young's modulus; or confined, no lateral strain: that "
                      "of P-waves.",
                      Selection("free|confined"));
    add("Viscosity",
        "Kelvin-Voigt viscosity eta, Pa s: stress eta u_xt.",
        viscosity);
    add("Linear expansion",
        "Coefficient alpha of linear thermal expansion, 1/K.",
        linear_expansion,
        Double(-1., 1.));
    add("Conductivity", "Heat conductivity kappa, W/(m K).", conductivity);
    add("Heat capacity", "Specific heat capacity c, J/(kg K).", heat_capacity);
    add("Reference temperature",
        "Temperature of the body without stress, K; that of the body, the "
        "obstacle and the surroundings unless they are given.",
        reference_temperature);
    prm.add_parameter("Small terms",
                      small_terms,
                      "Inertia and viscosity: kept, dropped, or automatic: "
                      "dropped where their times, that of a wave through the "
                      "body and that of relaxation, are below 1e-5 of the run, "
                      "which has no initial velocity, moving end or rear stop.",
                      Selection("automatic|kept|dropped"));
    prm.leave_subsection();
  }
} // namespace ThermoContact
