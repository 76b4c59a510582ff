// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/load_enclosure.h>
#include <thermocontact/scene/material_coefficients.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ThermoContact
{
  namespace
  {
    auto
    parts_of(const EquationFactors &coefficients)
    {
      const auto &[a, b, c, d, e, f, g, h] = coefficients;
      return std::tie(a, b, c, d, e, f, g, h);
    }



    template <typename Terms, typename Value>
    EquationFactors
    collect(const Terms &c, const Value &value)
    {
      return {value(c[0]),
              value(c[1]),
              value(c[2]),
              value(c[3]),
              value(c[4]),
              value(c[5]),
              value(c[6]),
              value(c[7])};
    }



    double
    plain_value(const double number)
    {
      return number;
    }

    double
    plain_value(const NumberJet &jet)
    {
      return jet.value;
    }
  } // namespace



  EquationFactors &
  EquationFactors::operator-=(const EquationFactors &other)
  {
    section -= other.section;
    heat_mass -= other.heat_mass;
    conduction -= other.conduction;
    coupling -= other.coupling;
    inertia -= other.inertia;
    stiffness -= other.stiffness;
    viscosity -= other.viscosity;
    poisson_ratio -= other.poisson_ratio;
    return *this;
  }



  bool
  operator==(const EquationFactors &one, const EquationFactors &other)
  {
    return parts_of(one) == parts_of(other);
  }



  LoadHistory
  history_along(const TimeFunction &coefficient,
                const double        length,
                const std::string  &coordinate)
  {
    const EnclosedLoad found = enclose_load(coefficient, length);
    if (!found.is_resolved)
      throw InputError(
        text(coefficient.expression.path(),
             " = ",
             coefficient.expression.text(),
             found.is_infinite ? ": not finite" : ": changes too fast",
             " near ",
             coordinate,
             significant(100. * found.time / length, 6),
             " % of the body\n  allowed: finite values, and jumps that can be "
             "told apart\n  remedy:  a smoother expression"));
    return found.history;
  }



  MaterialCoefficients::MaterialCoefficients(
    const Parameters                 &parameters,
    const BodyParameters             &body,
    const std::array<std::string, 4> &variables)
    : variable_names(variables)
    , length(body.length)
    , width(parameters.mesh.width)
    , is_rod(parameters.dimension == 1)
  {
    if (parameters.dimension < 3)
      std::replace(variable_names.begin(),
                   variable_names.end(),
                   std::string("z"),
                   std::string());
    const auto set = [&](const Name            name,
                         const char           *entry,
                         const RodCoefficient &given) {
      all[name].number   = given.value;
      all[name].entry    = entry;
      all[name].is_given = !given.expression.empty() || given.value != 1.;
      if (given.expression.empty())
        return;
      const std::string path  = "Bodies/" + body.name + "/" + entry;
      ExpressionNames   names = parameters.names(path);
      const auto known = entry_of_program(path).variables(parameters.dimension);
      names.variables.assign(variables.begin(), variables.end());
      for (std::string &variable : names.variables)
        if (std::find(known.begin(), known.end(), variable) == known.end())
          variable = "";
      names.checks_values = false; // where the body need not be
      all[name].expression.emplace(path, given.expression, names);
      all[name].is_of_theta = all[name].expression->depends_on("theta");
    };
    set(section, "Section", body.section);
    set(stiffness, "Stiffness", body.stiffness);
    set(density, "Density", body.density);
    set(viscosity, "Viscosity", body.viscosity);
    const bool has_coupling = body.coupling != "none";
    const auto number       = parse_number(body.coupling);
    set(coupling,
        "Coupling",
        {number.value_or(1.), has_coupling && !number ? body.coupling : ""});
    all[coupling].is_given = has_coupling;
    set(conductivity, "Conductivity", body.conductivity);
    set(heat_capacity, "Heat capacity", body.heat_capacity);
    set(poisson_ratio,
        "Poisson ratio",
        {parameters.model.poisson_ratio,
         body.poisson_ratio == "none" ? "" : body.poisson_ratio});
    all[poisson_ratio].is_given    = body.poisson_ratio != "none";
    all[viscosity].may_equal_lower = true;
    all[viscosity].allowed         = "numbers from 0 on";
    all[coupling].lower            = -infinity;
    all[coupling].allowed          = "finite numbers";
    all[poisson_ratio].lower       = -1.;
    all[poisson_ratio].upper       = 0.5;
    all[poisson_ratio].allowed     = "numbers between -1 and 1/2";
  }



  bool
  MaterialCoefficients::vary() const
  {
    return !expressions().empty();
  }



  std::vector<const Expression *>
  MaterialCoefficients::expressions() const
  {
    std::vector<const Expression *> found;
    for (const Coefficient &one : all)
      if (one.expression)
        found.push_back(&*one.expression);
    return found;
  }



  std::vector<std::pair<std::string, std::string>>
  MaterialCoefficients::own_entries() const
  {
    std::vector<std::pair<std::string, std::string>> own;
    for (const Coefficient &one : all)
      if (one.is_given)
        own.emplace_back(one.entry,
                         one.expression ? one.expression->text() :
                                          significant(one.number, 6));
    return own;
  }



  template <typename Number>
  std::string
  MaterialCoefficients::place_in_words(const Coefficient       &one,
                                       const Variables<Number> &variables) const
  {
    std::string words, temperature;
    for (unsigned int i = 0; i < variables.size(); ++i)
      if (const double value = plain_value(variables[i]);
          variable_names[i] == "theta")
        temperature =
          one.expression->depends_on("theta") ?
            " where theta is " + significant(value, 6) + " (nondimensional)" :
            "";
      else if (variable_names[i] == "x")
        words = " at " + significant(100. * value / length, 6) +
                (is_rod ? " % of the rod" : " % of the length") + words;
      else if (!variable_names[i].empty())
        words += ", " + variable_names[i] + " at " +
                 significant(100. * value / width, 6) + " % of the width";
    return words + temperature;
  }



  template <typename Number>
  Number
  MaterialCoefficients::at(const Name               name,
                           const Variables<Number> &variables) const
  {
    const Coefficient &one = all[name];
    if (!one.expression)
      return Number(one.number);
    const Number result    = one.expression->evaluate(variables.data());
    const double value     = plain_value(result);
    const bool   is_number = parse_number(one.expression->text()).has_value();
    if (!std::isfinite(value) || value < one.lower || value >= one.upper ||
        (!one.may_equal_lower && value == one.lower))
      throw InputError(text(one.expression->path(),
                            " = ",
                            one.expression->text(),
                            ": ",
                            significant(value, 6),
                            is_number ? "" : place_in_words(one, variables),
                            "\n  allowed: ",
                            one.allowed,
                            is_number ? "\n  remedy:  one of them" :
                                        "\n  remedy:  an expression that has "
                                        "them in the whole body",
                            one.expression->depends_on("theta") ?
                              ", at all of its temperatures" :
                              ""));
    return result;
  }



  template <typename Number>
  std::array<Number, 8>
  MaterialCoefficients::terms(const Variables<Number> &variables,
                              const Values *const      known) const
  {
    const auto of = [&](const Name name) -> Number {
      return known != nullptr && !all[name].is_of_theta ?
               Number((*known)[name]) :
               at<Number>(name, variables);
    };
    // P-wave modulus over Young's modulus
    const auto p_wave_factor = [](const Number &nu) -> Number {
      const Number one(1.), two(2.);
      return (one - nu) / ((one + nu) * (one - two * nu));
    };
    const Number A = of(section), nu = of(poisson_ratio);
    Number       E = of(stiffness);
    Number       a = all[coupling].is_given ? of(coupling) : E;
    if (all[poisson_ratio].is_given)
      {
        const Number of_model(all[poisson_ratio].number);
        E = E * p_wave_factor(nu) / p_wave_factor(of_model);
        // E alpha/(1 - 2 nu)
        a = a * (Number(1.) - Number(2.) * of_model) /
            (Number(1.) - Number(2.) * nu);
      }
    return {{A,
             A * of(heat_capacity),
             A * of(conductivity),
             A * a,
             A * of(density),
             A * E,
             A * E * of(viscosity),
             nu}};
  }



  EquationFactors
  MaterialCoefficients::in_equations(const Variables<double> &variables) const
  {
    return collect(terms<double>(variables), [](const double c) { return c; });
  }



  MaterialCoefficients::Values
  MaterialCoefficients::values(const Variables<double> &variables) const
  {
    Values result;
    for (unsigned int name = 0; name < n_names; ++name)
      result[name] = at<double>(static_cast<Name>(name), variables);
    return result;
  }



  EquationTangents
  MaterialCoefficients::tangents(const Variables<double> &variables,
                                 const Values *const      known) const
  {
    Variables<NumberJet> jets;
    for (unsigned int i = 0; i < jets.size(); ++i)
      jets[i] = variable_names[i] == "theta" ? NumberJet(variables[i], 1., 0.) :
                                               NumberJet(variables[i]);
    const auto all_terms = terms<NumberJet>(jets, known);
    return {collect(all_terms, [](const NumberJet &c) { return c.value; }),
            collect(all_terms, [](const NumberJet &c) { return c.first; })};
  }



  std::vector<const Expression *>
  MaterialCoefficients::of_temperature() const
  {
    std::vector<const Expression *> found = expressions();
    found.erase(std::remove_if(found.begin(),
                               found.end(),
                               [](const Expression *const one) {
                                 return !one->depends_on("theta");
                               }),
                found.end());
    return found;
  }



  bool
  MaterialCoefficients::operator==(const MaterialCoefficients &other) const
  {
    return std::equal(all.begin(),
                      all.end(),
                      other.all.begin(),
                      [](const Coefficient &a, const Coefficient &b) {
                        return a.number == b.number &&
                               a.is_given == b.is_given &&
                               a.expression == b.expression;
                      });
  }



  template double
  MaterialCoefficients::at(const Name, const Variables<double> &) const;
  template std::array<NumberJet, 8>
  MaterialCoefficients::terms(const Variables<NumberJet> &,
                              const Values *) const;
} // namespace ThermoContact
