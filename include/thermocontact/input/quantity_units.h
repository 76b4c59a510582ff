// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_quantity_units_h
#define thermocontact_input_quantity_units_h

#include <thermocontact/base/conversion.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/input/parameters.h>

#include <map>
#include <string>
#include <string_view>

namespace ThermoContact
{
  /** How numbers of each kind of quantity are written. */
  using ConversionsByKind = std::map<std::string, Conversion, std::less<>>;

  /** From a scene with @p scales, which are complete, to SI units. */
  ConversionsByKind
  conversions_by_kind(const ScalesParameters &scales);

  /** The one of a kind; as it is, of one without a scale. */
  const Conversion &
  conversion_of(const std::string_view kind, const ConversionsByKind &all);



  /**
   * In which units files, screen and messages have the quantities of a scene:
   * SI units if there are Scales and Output/SI is true, else none. The only
   * place that decides. Files for other runs of the program, checkpoints and
   * space-time.columns, are nondimensional.
   *
   * Kinds of quantities are words: "time", "length" (of displacements),
   * "position", "velocity", "stress", "force", "force × time", "force ×
   * length", "temperature", "temperature difference", "heat flux", "heat",
   * "energy"; of entries alone "body force", "compliance", "damping", "heat
   * source", "heat exchange", "heat loss" (per volume); "s" and "MB" of the
   * computer; "" a number.
   */
  class QuantityUnits
  {
  public:
    /** @param parameters that check_scales() has found complete */
    explicit QuantityUnits(const Parameters &parameters);

    bool
    is_si() const
    {
      return !conversions.empty();
    }

    /** Of a kind of quantity. */
    const Conversion &
    of(const std::string_view kind) const;

    /** A number of this kind in a sentence, with its unit. */
    std::string
    text(const std::string_view kind,
         const double           value,
         const unsigned int     digits = few_digits) const;

    /**
     * The same for who needs it in the parameter file, too, whose entries may
     * have no units: "0.25 ms (nondimensional: 1.2e-09)".
     */
    std::string
    text_for_entry(const std::string_view kind, const double value) const;

    /** The units in words; nothing if there are none. */
    std::string
    description() const;

  private:
    ConversionsByKind conversions;
    bool              has_si_entries; ///< of section Rod
  };
} // namespace ThermoContact

#endif
