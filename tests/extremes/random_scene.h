// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_random_scene_h
#define thermocontact_extremes_random_scene_h

#include <thermocontact/input/parameter_file.h>
#include <thermocontact/input/parameters.h>
#include <thermocontact/scene/scene_checks.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "test_scene.h"

namespace ThermoContact
{
  /**
   * Draws scenes. Numbers have three digits and go through text, so that the
   * options which rerun a scene are short and exact.
   */
  class RandomScene
  {
  public:
    /** The scene @p index of the sequence @p seed, whatever came before. */
    RandomScene(const unsigned int seed, const unsigned int index)
    {
      std::seed_seq sequence = {seed, index};
      generator.seed(sequence);
      scene.name =
        "random " + std::to_string(seed) + "/" + std::to_string(index);
    }

    TestScene
    draw()
    {
      draw_all();
      remove_unused();
      return scene;
    }

  protected:
    std::mt19937_64 generator;
    TestScene       scene;
    double          duration       = 0.; ///< end time
    double          step           = 0.; ///< 0: error-controlled
    double          inertia        = 0.;
    double          velocity       = 0.; ///< amplitude
    double          u_end          = 0.; ///< initial displacement of the end
    bool            is_paper_start = false;
    bool            is_conserving  = false;
    bool            has_one_node   = false; ///< that is not held

    /** In [0,1), the same with every standard library. */
    double
    uniform()
    {
      return std::ldexp(static_cast<double>(generator() >> 11), -53);
    }

    bool
    happens(const double probability)
    {
      return uniform() < probability;
    }

    static std::string
    text(const double value)
    {
      std::ostringstream stream;
      stream.precision(3);
      stream << value;
      return stream.str();
    }

    /** Log-uniform in (@p low, @p high), rounded to what is written. */
    double
    log_uniform(const double low, const double high)
    {
      const double value = low * std::pow(high / low, uniform());
      return std::stod(text(value));
    }

    /** Half of the values in the whole range, half where the scene moves. */
    double
    moderate_or_extreme(const double low,
                        const double high,
                        const double extreme_low,
                        const double extreme_high)
    {
      return happens(0.5) ? log_uniform(low, high) :
                            log_uniform(extreme_low, extreme_high);
    }

    double
    sign()
    {
      return happens(0.5) ? 1. : -1.;
    }

    std::string
    pick(const std::vector<std::string> &choices)
    {
      return choices[static_cast<std::size_t>(uniform() * choices.size())];
    }

    void
    set(const std::string &path, const std::string &value)
    {
      unset(path);
      scene.overrides.push_back(path + "=" + value);
    }

    void
    set(const std::string &path, const double value)
    {
      set(path, text(value));
    }

    /** The default is left. */
    void
    unset(const std::string &path)
    {
      scene.overrides.erase(std::remove_if(scene.overrides.begin(),
                                           scene.overrides.end(),
                                           [&](const std::string &text) {
                                             return text.rfind(path + "=", 0) ==
                                                    0;
                                           }),
                            scene.overrides.end());
    }

    /** What is drawn for an entry, or else @p otherwise. */
    std::string
    value(const std::string &path, const std::string &otherwise) const
    {
      for (const std::string &text : scene.overrides)
        if (text.rfind(path + "=", 0) == 0)
          return text.substr(path.size() + 1);
      return otherwise;
    }

    /** Entries that the scene cannot use would be refused. */
    void
    remove_unused()
    {
      Parameters               parameters;
      dealii::ParameterHandler prm;
      parameters.add_parameters(prm);
      for (const std::string &text : scene.overrides)
        assign_entries({parse_override(text)}, prm);
      for (const UnusedEntry &entry : unused_entries(parameters))
        unset(entry.path);
    }

    /** What contradicts itself, and would be refused, is not drawn. */
    void
    draw_all()
    {
      draw_model();
      draw_mesh();
      draw_time();
      draw_boundary();
      draw_initial_values();
      draw_contact();
      draw_sources();
    }

  private:
    void
    draw_model()
    {
      if (happens(0.2))
        set("Model/Fields", pick({"temperature", "displacement"}));
      inertia = happens(0.1)  ? 0. :
                happens(0.05) ? 4e-18 :
                                moderate_or_extreme(0.01, 10., 1e-12, 1e8);
      set("Model/Inertia", inertia);
      set("Model/Viscosity",
          happens(0.2) ? 0. : moderate_or_extreme(1e-3, 1., 1e-12, 1e6));
      set("Model/Coupling",
          happens(0.15) ? 0. :
                          sign() * moderate_or_extreme(1e-3, 1., 1e-12, 1e3));
      if (happens(0.1))
        set("Model/Thermoelastic heating", "false");
    }

    void
    draw_mesh()
    {
      const double n_cells = 1. + std::floor(20. * uniform());
      const double degree  = 1. + std::floor(6. * uniform());
      has_one_node         = n_cells == 1. && degree == 1.;
      set("Mesh/Cells", n_cells);
      set("Mesh/Degree", degree);
      if (happens(0.3))
        set("Mesh/Grading", log_uniform(1e-4, 1e4));
      if (happens(0.2))
        set("Mesh/Mass matrix", "lumped");
    }

    void
    draw_time()
    {
      std::vector<std::string> schemes = {
        "backward euler", "sdirk2", "sdirk3", "sdirk4", "sdirk4 controlled"};
      if (inertia > 0. && !has_one_node)
        schemes.push_back("energy conserving");
      const std::string scheme = pick(schemes);
      is_conserving            = scheme == "energy conserving";
      set("Time/Scheme", scheme.substr(0, scheme.find(" controlled")));
      if (scheme == "sdirk4 controlled")
        {
          duration = log_uniform(1e-4, 100.);
          set("Time/Tolerance", log_uniform(1e-6, 1e-3));
        }
      else
        {
          step = moderate_or_extreme(1e-3, 1., 1e-6, 10.);
          set("Time/Step size", step);
          duration = std::stod(text((5. + 20. * uniform()) * step));
        }
      set("Time/End time", duration);
      if (scheme == "backward euler")
        {
          is_paper_start = inertia > 0. && happens(0.5);
          set("Time/Start", is_paper_start ? "paper" : "consistent");
        }
    }

    void
    draw_boundary()
    {
      const double k =
        happens(0.15) ? 0. : moderate_or_extreme(0.1, 100., 1e-12, 1e12);
      set("Boundary/Heat exchange", k);
      if (happens(0.5))
        set("Boundary/Obstacle temperature",
            sign() * moderate_or_extreme(0.1, 100., 1e-6, 1e6));
      set("Boundary/Fixed end temperature",
          happens(0.15) ? 0. :
                          sign() * moderate_or_extreme(0.1, 100., 1e-6, 1e6));
    }

    void
    draw_initial_values()
    {
      const std::string amplitude =
        text(sign() * moderate_or_extreme(0.1, 100., 1e-6, 1e6));
      set("Initial values/Temperature",
          pick({"theta_A",
                "theta_A*(1-x)",
                amplitude,
                "theta_A+" + amplitude + "*sin(4*x)",
                "theta_A*cos(9*x)+" + amplitude + "*abs(x-0.4)"}));
      velocity =
        happens(0.15) ? 0. : sign() * moderate_or_extreme(0.1, 100., 1e-6, 1e6);
      set("Initial values/Velocity",
          text(velocity) +
            pick({"*x", "*x^2", "*x*(x-1)^2", "*sin(9*x)", "*sin(pi*x)"}));
      if (happens(0.4))
        return;
      u_end = sign() * moderate_or_extreme(1e-3, 1., 1e-9, 1e3);
      set("Initial values/Displacement",
          text(u_end) + pick({"*x", "*x^3", "*sin(pi*x/2)"}));
    }

    void
    draw_contact()
    {
      const std::string condition =
        pick({"normal compliance", "normal compliance", "rigid", "none"});
      set("Contact/Condition", condition);
      if (condition == "none")
        return;
      // a third where the body goes within the run, a third anywhere, a third
      // at the body; a preload only if the obstacle yields
      const bool is_rigid = condition == "rigid";
      double     gap      = happens(0.33) ?
                              std::abs(velocity) * duration * log_uniform(1e-3, 1.) :
                            happens(0.5) ? moderate_or_extreme(1e-3, 1., 1e-15, 1e30) :
                                           0.;
      if (happens(0.2))
        gap = -gap;
      if (is_rigid && u_end <= 0.)
        gap = std::abs(gap);
      if (is_rigid && u_end > 0.)
        gap = u_end * 1.01 + std::abs(gap);
      set("Contact/Gap", gap);
      if (!is_rigid)
        set("Contact/Compliance", moderate_or_extreme(1e-3, 1., 1e-14, 1e12));
      if (is_rigid && is_paper_start)
        set("Time/Start", "consistent"); // that of the paper may penetrate
      if (step > 0. && !is_conserving && happens(0.15))
        set("Time/Locate contact events", "true");
      if (happens(0.5) && !has_one_node)
        set("Contact/Massless nodes",
            pick({is_paper_start && !is_rigid ? "automatic" : "on",
                  is_conserving ? "automatic" : "off"}));
    }

    void
    draw_sources()
    {
      const std::string size =
        text(sign() * moderate_or_extreme(0.1, 100., 1e-6, 1e6));
      if (happens(0.8))
        return;
      const std::string rate = text(log_uniform(0.1, 10.) / duration);
      set("Sources/" +
            pick(
              {"Heat source", "Body force", "End traction", "End heat flux"}),
          size + "*cos(" + rate + "*t)");
    }
  };
} // namespace ThermoContact

#endif
