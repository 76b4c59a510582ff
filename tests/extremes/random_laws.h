// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_random_laws_h
#define thermocontact_extremes_random_laws_h

#include <iomanip>

#include "random_scene.h"

namespace ThermoContact
{
  /**
   * Draws scenes of RandomScene and changes them: power laws, damped obstacles,
   * second stops, heat exchange by gap and pressure, heat lost along the rod,
   * ends and obstacles that are heated or move, loads that jump and pulse,
   * times at which steps end, the box scheme, bodies in two dimensions. What
   * contradicts itself, and would be refused, is not drawn.
   */
  class RandomLaws : private RandomScene
  {
  public:
    /** The scene @p index of the sequence @p seed, whatever came before. */
    RandomLaws(const unsigned int seed, const unsigned int index)
      : RandomScene(seed, index)
    {
      scene.name = "laws " + std::to_string(seed) + "/" + std::to_string(index);
    }

    TestScene
    draw()
    {
      draw_all();
      const std::string fields = value("Model/Fields", "");
      has_temperature          = fields != "displacement";
      has_displacement         = fields != "temperature";
      is_plane                 = happens(0.12);
      if (is_plane)
        draw_plane();
      else if (is_conserving && has_displacement && happens(0.4))
        draw_box_scheme();
      if (has_displacement)
        {
          draw_law();
          draw_rear_stop();
          draw_moving_end();
          draw_moving_obstacle();
        }
      if (has_temperature)
        {
          draw_exchange();
          draw_lateral_exchange();
          draw_heated_ends();
        }
      draw_loads();
      draw_times();
      remove_unused();
      return scene;
    }

  private:
    bool                     has_temperature  = true;
    bool                     has_displacement = true;
    bool                     is_plane         = false;
    std::vector<std::string> special_times; ///< of the drives so far

    double
    number(const std::string &path, const double otherwise) const
    {
      return std::stod(value(path, text(otherwise)));
    }

    double
    amplitude()
    {
      return sign() * moderate_or_extreme(0.1, 100., 1e-6, 1e6);
    }

    /** Half of them of the run, half anywhere, as a factor of t. */
    std::string
    frequency()
    {
      return text(happens(0.5) ? log_uniform(0.5, 50.) / duration :
                                 log_uniform(1e-3, 1e4));
    }

    /** In the run, where steps may be asked to end. */
    std::string
    moment()
    {
      special_times.push_back(text(duration * uniform()));
      return special_times.back();
    }

    /** A function of time around @p value, with jumps or without. */
    std::string
    drive(const double value, const double change)
    {
      const std::string a = text(value), d = text(change);
      const std::string from = text(value) + (change < 0. ? "" : "+") + d;
      const std::string t0 = moment(), w = frequency();
      const std::string width = text(duration * log_uniform(1e-3, 0.3));
      return pick({from + "*sin(" + w + "*t)",
                   a + "*cos(" + w + "*t)",
                   "if(t<" + t0 + "," + a + "," + d + ")",
                   "if(t<" + t0 + "," + a + ",if(t<" + t0 + "+" + width + "," +
                     d + "," + a + "))",
                   from + "*exp(-((t-" + t0 + ")/" + width + ")^2)",
                   from + "*if(sin(" + w + "*t)>0,1,-1)",
                   from + "*min(t/" + width + ",1)"});
    }

    void
    draw_plane()
    {
      set("Dimension", "2");
      const bool is_round = happens(0.3);
      if (is_round)
        set("Mesh/Geometry", "axisymmetric");
      set("Mesh/Cells", 2. + std::floor(3. * uniform()));
      set("Mesh/Cells across", 1. + std::floor(2. * uniform()));
      set("Mesh/Degree", 1. + std::floor(3. * uniform()));
      set("Mesh/Width", log_uniform(0.05, 1.));
      if (is_round)
        unset("Mesh/Mass matrix"); // nodes on the axis would have no mass
      set("Model/Poisson ratio",
          happens(0.2) ? 0.49 : std::stod(text(-0.5 + 0.95 * uniform())));
      if (happens(0.5))
        set("Boundary/Lateral support", "free");
      has_one_node = false;
    }

    /** Waves that pass a cell in a step, or in another time. */
    void
    draw_box_scheme()
    {
      const double n_cells = 2. + std::floor(30. * uniform());
      set("Mesh/Mass matrix", "midpoint");
      set("Mesh/Degree", "1");
      set("Mesh/Cells", n_cells);
      set("Model/Viscosity", "0");
      unset("Mesh/Grading");
      unset("Contact/Massless nodes");
      if (happens(0.3))
        return;
      step = std::stod(text(std::sqrt(inertia) / n_cells));
      std::ostringstream exact;
      exact << std::setprecision(17) << std::sqrt(inertia) / n_cells;
      set("Time/Step size", exact.str());
      duration = std::stod(text((5. + 40. * uniform()) * step));
      set("Time/End time", duration);
    }

    void
    draw_law()
    {
      if (value("Contact/Condition", "") != "normal compliance" ||
          is_conserving)
        return;
      if (happens(0.6))
        {
          const double exponent =
            happens(0.4) ? std::stod(pick({"1", "1.5", "2", "3", "10"})) :
                           log_uniform(1., 10.);
          set("Contact/Condition", "power law");
          set("Contact/Exponent", std::min(exponent, largest_exponent()));
        }
      if (!happens(0.4))
        return;
      set("Contact/Damping", moderate_or_extreme(0.01, 10., 1e-6, 1e6));
      if (value("Contact/Massless nodes", "") == "on" &&
          number("Model/Viscosity", 0.2) == 0.)
        set("Contact/Massless nodes", "off");
    }

    /** Behind the end, which it does not overlap. */
    void
    draw_rear_stop()
    {
      const std::string gap = value("Contact/Gap", "0");
      if (value("Contact/Condition", "none") == "none" ||
          gap.find_first_not_of("0123456789.e+-") != std::string::npos ||
          !happens(0.35))
        return;
      leave_start_of_paper();
      const double front    = number("Contact/Gap", 0.);
      const double rear_gap = std::max(
        {moderate_or_extreme(1e-3, 1., 1e-9, 1e3), -1.1 * front, -1.1 * u_end});
      if (rear_gap <= 1e15) // as large as the entry may be
        set("Contact/Rear gap", rear_gap);
    }

    /** With which pressures, also times 1e100, have squares that are numbers.
     */
    double
    largest_exponent() const
    {
      const double penetration = std::max(
        {1., u_end - number("Contact/Gap", 0.), std::abs(velocity) * duration});
      const double digits =
        std::log10(penetration / number("Contact/Compliance", 0.01));
      return digits > 0. ? std::max(1., std::floor(50. / digits)) : 10.;
    }

    /** Starts at zero; no jump. */
    void
    draw_moving_end()
    {
      if (is_conserving || !happens(0.3))
        return;
      leave_start_of_paper();
      const std::string size =
        text(sign() * moderate_or_extreme(1e-3, 1., 1e-9, 1e3));
      const std::string w = frequency(), t0 = moment();
      set("Boundary/Fixed end displacement",
          size + pick({"*sin(" + w + "*t)",
                       "*sin(" + w + "*t)^2",
                       "*t^2*exp(-" + w + "*t)",
                       "*max(0,t-" + t0 + ")"}));
    }

    /**
     * From where it is without: waves, ramps that rest before and behind,
     * pulses, turns. Powers of large penetrations would not be numbers.
     */
    void
    draw_moving_obstacle()
    {
      if (value("Contact/Condition", "none") == "none" ||
          value("Contact/Rear gap", "none") != "none" || !happens(0.3))
        return;
      leave_start_of_paper();
      const bool   is_power = value("Contact/Condition", "") == "power law";
      const double size     = is_power ? log_uniform(1e-3, 1.) :
                                         moderate_or_extreme(1e-3, 1., 1e-9, 1e3);
      const std::string w = frequency(), t0 = moment(), t1 = moment();
      const std::string width = text(duration * log_uniform(1e-4, 0.3));
      const std::string shape =
        is_plane && happens(0.5) ? "(1+" + text(sign()) + "*y)*" : "";
      set("Contact/Gap",
          text(number("Contact/Gap", 0.1)) + "+(" + text(sign() * size) + ")*" +
            shape +
            pick(
              {"sin(" + w + "*t)",
               "sin(" + w + "*t)^2",
               "abs(sin(" + w + "*t))",
               "max(0,min(1,(t-" + t0 + ")/" + width + "))",
               "max(0,t-" + t0 + ")",
               "max(abs(t-" + t0 + ")-" + t0 + ",abs(t-" + t1 + ")-" + t1 + ")",
               "t*exp(-((t-" + t0 + ")/" + width + ")^2)"}));
    }

    void
    leave_start_of_paper()
    {
      if (value("Time/Start", "") == "paper")
        set("Time/Start", "consistent");
      is_paper_start = false;
    }

    void
    draw_exchange()
    {
      const std::string condition = value("Contact/Condition", "none");
      if (is_conserving || condition == "none" || !has_displacement ||
          !happens(0.4))
        return;
      leave_start_of_paper();
      const std::string k0 = text(moderate_or_extreme(0.1, 100., 1e-12, 1e12));
      const std::string k1 = text(moderate_or_extreme(0.1, 100., 1e-12, 1e12));
      const std::string width =
        text(happens(0.5) ? log_uniform(1e-4, 1.) : log_uniform(1e-12, 1e3));
      set("Boundary/Heat exchange",
          pick({"if(pressure>0," + k1 + "," + k0 + ")",
                k0 + "+" + k1 + "*exp(-gap/" + width + ")",
                k0 + "*" + width + "/(" + width + "+gap)+" + k1 + "*pressure",
                "if(pressure>0," + k0 + "+" + k1 + "*pressure," + k0 + "*" +
                  width + "/(" + width + "+gap))"}));
      if (happens(0.3))
        draw_switch();
    }

    /** Like prm/examples/thermal-switch.prm: three states of rest. */
    void
    draw_switch()
    {
      const double a   = log_uniform(1e-3, 1.);
      const double hot = log_uniform(0.1, 100.);
      const double g   = 0.35 * a * hot * (0.8 + 0.4 * uniform());
      set("Model/Coupling", a);
      set("Boundary/Fixed end temperature", "0");
      set("Boundary/Obstacle temperature", hot);
      set("Initial values/Temperature", text(hot * 0.8 * uniform()) + "*x");
      unset("Initial values/Displacement");
      u_end = 0.;
      set("Contact/Gap", g);
      set("Boundary/Heat exchange",
          text(0.06 * a * hot) + "/(" + text(0.12 * a * hot) + "+gap)+" +
            text(35. / (a * hot)) + "*pressure");
    }

    void
    draw_lateral_exchange()
    {
      if (!happens(0.35))
        return;
      set("Boundary/Lateral heat exchange",
          moderate_or_extreme(0.1, 100., 1e-6, 1e6));
      if (happens(0.7))
        set("Boundary/Ambient temperature", amplitude());
    }

    void
    draw_heated_ends()
    {
      if (happens(0.3))
        set("Boundary/Fixed end temperature",
            drive(number("Boundary/Fixed end temperature", 10.), amplitude()));
      const std::string exchange = value("Boundary/Heat exchange", "1");
      if (exchange.find_first_not_of("0123456789.e+-") != std::string::npos ||
          !happens(0.3))
        return;
      set("Boundary/Obstacle temperature",
          drive(number("Boundary/Obstacle temperature", 0.), amplitude()) +
            (is_plane ? "+y" : ""));
    }

    /** Up to two loads in place of the one of RandomScene. */
    void
    draw_loads()
    {
      if (happens(0.4))
        return;
      for (const char *load :
           {"Heat source", "Body force", "End traction", "End heat flux"})
        unset(std::string("Sources/") + load);
      const unsigned int n_loads = happens(0.4) ? 2 : 1;
      for (unsigned int i = 0; i < n_loads; ++i)
        set("Sources/" +
              pick(
                {"Heat source", "Body force", "End traction", "End heat flux"}),
            "(" + drive(0., amplitude()) + ")" + pick({"", "", "*x"}));
    }

    /** Where steps end beside their own ends. */
    void
    draw_times()
    {
      if (happens(0.3))
        {
          std::string times;
          const auto  add = [&](const std::string &time) {
            times += (times.empty() ? "" : ";") + time;
          };
          for (const std::string &time : special_times)
            if (happens(0.7))
              add(time);
          add(text(duration * uniform()));
          add(pick({"0", text(duration), text(2. * duration), text(step)}));
          set("Time/Break points", times);
        }
      if (happens(0.2))
        set("Output/Period", duration * log_uniform(0.03, 3.));
    }
  };
} // namespace ThermoContact

#endif
