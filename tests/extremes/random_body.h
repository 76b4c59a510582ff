// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_extremes_random_body_h
#define thermocontact_extremes_random_body_h

#include "random_scene.h"

namespace ThermoContact
{
  /**
   * Draws bodies in two and three dimensions for a few fixed steps, which every
   * solver of stages can do, with all that makes stages hard: flat cells,
   * nearly incompressible materials, soft and hard obstacles, short and long
   * steps, nodes without mass and viscosity. What contradicts itself, and would
   * be refused, is drawn and left out.
   */
  class RandomBody : private RandomScene
  {
  public:
    /** The scene @p index of the sequence @p seed, whatever came before. */
    RandomBody(const unsigned int seed, const unsigned int index)
      : RandomScene(seed, index)
    {
      scene.name = "body " + std::to_string(seed) + "/" + std::to_string(index);
    }

    TestScene
    draw()
    {
      step = happens(0.3) ? log_uniform(1e-9, 1e3) : log_uniform(1e-4, 1.);
      draw_body();
      draw_material();
      draw_motion();
      draw_obstacle();
      remove_unused();
      return scene;
    }

  private:
    bool has_free_sides = false;
    bool slides         = false;
    bool is_round       = false;

    void
    draw_body()
    {
      const bool   is_block = happens(0.4);
      const double along    = 1. + std::floor(8. * uniform());
      const double across   = 1. + std::floor((is_block ? 3. : 6.) * uniform());
      const double ratio    = happens(0.3) ? 1. : log_uniform(1., 20.);
      set("Dimension", is_block ? "3" : "2");
      is_round = !is_block && happens(0.3);
      if (is_round)
        set("Mesh/Geometry", "axisymmetric");
      set("Mesh/Cells", along);
      set("Mesh/Cells across", across);
      set("Mesh/Width", across / along * (happens(0.5) ? ratio : 1. / ratio));
      set("Mesh/Degree", 1. + std::floor((is_block ? 2. : 4.) * uniform()));
      set("Mesh/Refinements", happens(0.3) && !is_block ? 1. : 0.);
      if (happens(0.2))
        set("Mesh/Grading", log_uniform(0.1, 10.));
      if (happens(0.2) && !is_round) // nodes on the axis would have no mass
        set("Mesh/Mass matrix", "lumped");
      has_free_sides = happens(0.7);
      set("Boundary/Lateral support", has_free_sides ? "free" : "rollers");
      slides = happens(0.3);
    }

    void
    draw_material()
    {
      set("Model/Poisson ratio",
          happens(0.3) ? 0.5 - log_uniform(1e-3, 0.1) :
                         -0.5 + 0.95 * uniform());
      const double inertia = happens(0.25) ? 0. : log_uniform(0.01, 10.);
      set("Model/Inertia", inertia);
      if (slides && !(has_free_sides && inertia == 0. && !is_round))
        set("Boundary/Fixed end support", "sliding"); // or nothing holds it
      set("Model/Viscosity", happens(0.3) ? 0. : log_uniform(1e-3, 10.));
      set("Model/Coupling", happens(0.2) ? 0. : sign() * log_uniform(1e-3, 2.));
      set("Boundary/Heat exchange", happens(0.2) ? 0. : log_uniform(0.1, 1e3));
      set("Boundary/Fixed end temperature", sign() * log_uniform(0.1, 10.));
    }

    void
    draw_motion()
    {
      set("Time/Scheme", pick({"backward euler", "sdirk2", "sdirk4"}));
      set("Time/Start", "consistent");
      set("Time/Step size", step);
      set("Time/End time", std::stod(text(4. * step)));
      set("Initial values/Temperature", "theta_A*cos(3*x)");
      velocity = log_uniform(0.1, 10.) * (happens(0.85) ? 1. : -1.);
      set("Initial values/Velocity", text(velocity) + "*x*(1+0.5*y)");
      if (happens(0.3))
        set("Sources/Body force", log_uniform(0.1, 10.));
    }

    void
    draw_obstacle()
    {
      const std::string condition =
        pick({"normal compliance", "normal compliance", "rigid", "none"});
      set("Contact/Condition", condition);
      if (condition == "none")
        return;
      const double way = std::abs(velocity) * step;
      const double gap = happens(0.2) ? 0. : way * log_uniform(0.01, 4.);
      set("Contact/Gap",
          text(gap) + (happens(0.4) ? "+" + text(0.5 * way) + "*y" : ""));
      if (condition != "rigid")
        set("Contact/Compliance", log_uniform(1e-12, 1e6));
    }
  };
} // namespace ThermoContact

#endif
