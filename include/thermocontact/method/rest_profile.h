// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_rest_profile_h
#define thermocontact_method_rest_profile_h

namespace ThermoContact
{
  /** The temperatures and heat exchange of the ends and sides of a rod. */
  struct RodSurroundings
  {
    double fixed_end;        ///< $\theta_A$
    double obstacle;         ///< $\theta_{obs}$
    double lateral_exchange; ///< $m\ge0$, of the sides
    double ambient;          ///< $\theta_\infty$
  };



  /**
   * The temperature of a rod at rest, doc/model.md (M2.1), or with a lateral
   * heat exchange (M5.6):
   * @f[
   *   \theta'' = m\,(\theta-\theta_\infty) , \quad \theta(0)=\theta_A , \quad
   *   -(1-c)\,\theta'(1) = c\,(\theta(1)-\theta_{obs}) , \quad c=\frac k{1+k} .
   * @f]
   */
  class RestProfile
  {
  public:
    /** @param drop $c$, from 0 (no heat exchange at the end) to 1 */
    RestProfile(const RodSurroundings &surroundings, const double drop);

    /** $\theta(1)$. */
    double
    end() const
    {
      return end_;
    }

    /** $\int_0^1\theta\,dx$. */
    double
    mean() const
    {
      return mean_;
    }

  private:
    double end_;
    double mean_;
  };
} // namespace ThermoContact

#endif
