// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/input/parameters.h>

#include <cmath>

namespace ThermoContact
{
  std::vector<double>
  MeshParameters::cell_sizes() const
  {
    const double factor =
      cells > 1 ? std::pow(grading, -1. / (cells - 1.)) : 1.;
    std::vector<double> sizes(cells);
    double              sum = 0.;
    for (unsigned int i = 0; i < cells; ++i)
      sum += sizes[i] = std::pow(factor, i);
    for (double &size : sizes)
      size /= sum;
    return sizes;
  }



  double
  MeshParameters::contact_spacing() const
  {
    return std::ldexp(cell_sizes().back(), -static_cast<int>(refinements)) /
           degree;
  }



  ContactLaw
  Parameters::contact_law() const
  {
    const bool is_elastic = !contact.is_none() && !contact.is_rigid();
    return {!contact.is_none() && model.has_displacement(),
            is_elastic ? contact.compliance : 0.,
            contact.gap};
  }



  bool
  Parameters::has_massless_contact() const
  {
    const bool has_other_nodes =
      mesh.degree * std::ldexp(mesh.cells, mesh.refinements) > 1.;
    if (!contact_law().is_active || model.inertia == 0. || !has_other_nodes)
      return false;
    if (contact.massless_nodes != "automatic")
      return contact.massless_nodes == "on";
    if (has_prescribed_start())
      return false; // the paper's scheme, as it is
    return time.is_energy_conserving() ||
           (dimension > 1 && contact.is_rigid()) ||
           model.viscosity < std::sqrt(model.inertia) * mesh.contact_spacing();
  }



  bool
  Parameters::has_contact_equilibrium() const
  {
    const bool has_viscous_stress =
      model.viscosity > 0. && !time.is_energy_conserving();
    return contact_law().is_active && !has_contact_mass() &&
           !has_viscous_stress;
  }



  bool
  Parameters::has_prescribed_start() const
  {
    return model.has_displacement() && model.inertia > 0. &&
           (time.start == "paper" ||
            (time.start == "automatic" && time.scheme == "backward euler" &&
             contact.massless_nodes != "on"));
  }



  std::vector<Parameters::UnusedEntry>
  Parameters::unused_entries() const
  {
    std::vector<UnusedEntry> unused;
    add_unused_by_model(unused);
    const auto add = [&unused](const std::vector<const char *> &paths,
                               const std::string               &reason) {
      for (const char *path : paths)
        unused.push_back({path, reason});
    };
    if (dimension == 1)
      add({"Model/Poisson ratio",
           "Boundary/Lateral support",
           "Mesh/Width",
           "Mesh/Cells across"},
          "Dimension = 1");
    const std::string condition = "Contact/Condition = " + contact.condition;
    if (contact.is_none() || contact.is_rigid())
      add({"Contact/Compliance"}, condition);
    if (contact.is_none())
      add({"Contact/Gap",
           "Contact/Massless nodes",
           "Time/Locate contact events"},
          condition);
    if (boundary.heat_exchange == 0.)
      add({"Boundary/Obstacle temperature"}, "Boundary/Heat exchange = 0");
    if (!time.has_error_control())
      add({"Time/Tolerance",
           "Time/First step size",
           "Time/Minimum step size",
           "Time/Maximum step size"},
          "Time/Step size = a number");
    if (output.fields_interval == 0. && output.contact_interval == 0. &&
        output.space_time_interval == 0.)
      add({"Output/Land on output times"},
          "Output/Contact interval = 0 and no other interval is set");
    if (!study.is_active())
      add({"Study/Reference",
           "Study/Repetitions",
           "Study/Target error",
           "Study/Keep files"},
          "Study/Vary = (empty)");
    if (!solver.is_fixed_point())
      add({"Solver/Fixed point tolerance", "Solver/Fixed point iterations"},
          "Solver/Step solver = monolithic");
    return unused;
  }



  void
  Parameters::add_unused_by_model(std::vector<UnusedEntry> &unused) const
  {
    const auto add = [&unused](const std::vector<const char *> &paths,
                               const std::string               &reason) {
      for (const char *path : paths)
        unused.push_back({path, reason});
    };
    const std::string fields = "Model/Fields = " + model.fields;
    if (!model.has_displacement())
      add({"Model/Inertia",
           "Model/Viscosity",
           "Model/Coupling",
           "Model/Thermoelastic heating",
           "Model/Poisson ratio",
           "Boundary/Lateral support",
           "Contact/Condition",
           "Contact/Compliance",
           "Contact/Gap",
           "Contact/Massless nodes",
           "Initial values/Displacement",
           "Initial values/Velocity",
           "Sources/Body force",
           "Sources/End traction",
           "Time/Start",
           "Time/Locate contact events"},
          fields);
    if (!model.has_temperature())
      add({"Model/Coupling",
           "Model/Thermoelastic heating",
           "Boundary/Fixed end temperature",
           "Boundary/Heat exchange",
           "Boundary/Obstacle temperature",
           "Initial values/Temperature",
           "Sources/Heat source",
           "Sources/End heat flux"},
          fields);
    if (model.coupling == 0.)
      add({"Model/Thermoelastic heating"}, "Model/Coupling = 0");
    if (model.inertia == 0. && !model.has_temperature())
      add({"Mesh/Mass matrix"}, "Model/Inertia = 0");
    if (!model.has_displacement())
      add({"Study/Target error"}, fields);
    if (model.inertia == 0.)
      add({"Initial values/Velocity", "Contact/Massless nodes"},
          "Model/Inertia = 0");
    if (model.is_static())
      add({"Initial values/Displacement"},
          "Model/Inertia = 0 and Viscosity = 0");
  }
} // namespace ThermoContact
