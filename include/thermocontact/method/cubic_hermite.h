// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_method_cubic_hermite_h
#define thermocontact_method_cubic_hermite_h

namespace ThermoContact
{
  /** The cubic on (0, 1) with these values and slopes at its ends. */
  class CubicHermite
  {
  public:
    /** @param slope0,slope1 per unit of the interval */
    CubicHermite(const double s0,
                 const double slope0,
                 const double s1,
                 const double slope1);

    /** At @p x in the unit interval. */
    double
    value(const double x) const;

    /** Derivative there. */
    double
    slope(const double x) const;

    /**
     * Where it first becomes negative in (0, 1), and infinity if it does not.
     * One that begins below zero must first become positive; if it does not,
     * the answer is 0. A dip that does not reach @p tolerable_dip below zero
     * between two positive values is none; one that does not end there begins
     * at its lowest point.
     */
    double
    first_zero(const double tolerable_dip) const;

    /** The zero next to 1, on either side; 1 if there is none near. */
    double
    zero_near_end() const;

  private:
    const double s0, slope0, s1, slope1, quadratic, cubic;
  };
} // namespace ThermoContact

#endif
