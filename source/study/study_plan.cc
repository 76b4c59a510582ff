// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/number_text.h>
#include <thermocontact/base/text.h>
#include <thermocontact/input/constants.h>
#include <thermocontact/input/si_scene.h>
#include <thermocontact/input/unit_text.h>
#include <thermocontact/scene/scene_checks.h>
#include <thermocontact/study/study_plan.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    const char *const notation =
      "\n  allowed: Section/Entry = value | value ; Section/Entry = value | ..., "
      "ranges such as 0.6 .. 2.6 (61) or 1e-3 .. 1 (7 log), and ',' between "
      "entries that go together: A = a1 | a2 , B = b1 | b2";



    /** The parts of @p text between separators, trimmed. */
    std::vector<std::string>
    split_at(const std::string &text, const std::string &separator)
    {
      std::vector<std::string> parts;
      std::size_t              begin = 0;
      while (true)
        {
          const auto end = text.find(separator, begin);
          parts.push_back(
            dealii::Utilities::trim(text.substr(begin, end - begin)));
          if (end == std::string::npos)
            return parts;
          begin = end + separator.size();
        }
    }



    [[noreturn]] void
    refuse_notation(const std::string &entry,
                    const std::string &text,
                    const std::string &fault)
    {
      throw InputError("Study/" + entry + ": " + fault + " in '" + quote(text) +
                       "'" + notation);
    }



    /** The values of "first .. last (n)" or "first .. last (n log)". */
    std::vector<std::string>
    range_of_values(const std::string &text)
    {
      const auto fail = [&](const std::string &fault) {
        refuse_notation("Vary", text, fault);
      };
      const std::vector<std::string> ends = split_at(text, "..");
      const auto                     open = ends.back().rfind('(');
      if (ends.size() != 2 || open == std::string::npos ||
          ends.back().back() != ')')
        fail("a range without its number of values");
      const auto first = split_unit(ends[0]);
      const auto last =
        split_unit(dealii::Utilities::trim(ends[1].substr(0, open)));
      std::istringstream count(
        ends[1].substr(open + 1, ends[1].size() - open - 2));
      unsigned int n = 0;
      std::string  word, rest;
      count >> n >> word >> rest;
      const bool is_log = word == "log";
      if (!first || !last ||
          !(first->unit.empty() || first->unit == last->unit))
        fail("no numbers at the ends of a range");
      if (first->number == last->number)
        fail("ends that are the same");
      if (n < 2 || n > StudyPlan::max_runs || !(word.empty() || is_log) ||
          !rest.empty())
        fail("no number of values from 2 on, or log behind it,");
      if (is_log && !(first->number * last->number > 0.))
        fail("ends that are not both positive, for log,");
      std::vector<std::string> values;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double part = static_cast<double>(i) / (n - 1);
          const double value =
            is_log ?
              first->number * std::pow(last->number / first->number, part) :
              (1. - part) * first->number + part * last->number;
          // without rounding: 0.3, not 0.30000000000000004
          values.push_back(
            significant(i == 0     ? first->number :
                        i == n - 1 ? last->number :
                                     *parse_number(significant(value, 15)),
                        all_digits) +
            (last->unit.empty() ? "" : " " + last->unit));
        }
      return values;
    }



    /** Parts at commas behind which an entry stands, not at commas of
     * functions. */
    std::vector<std::string>
    split_entries(const std::string &text)
    {
      std::vector<std::string> parts{""};
      for (const std::string &part : split_at(text, ","))
        {
          const auto sign = part.find('=');
          const bool is_entry =
            sign != std::string::npos && part.find('/') < sign &&
            part.find_first_of("()|<>!") > sign && part[sign + 1] != '=';
          if (parts.back().empty())
            parts.back() = part;
          else if (is_entry)
            parts.push_back(part);
          else
            parts.back() += "," + part;
        }
      return parts;
    }



    StudyPlan::Variation
    read_variation(const std::string &entry, const std::string &text)
    {
      const auto fail = [&](const std::string &fault) {
        refuse_notation(entry, text, fault);
      };
      const auto equal_sign = text.find('=');
      if (equal_sign == std::string::npos)
        fail("no '='");
      StudyPlan::Variation variation = {
        dealii::Utilities::trim(text.substr(0, equal_sign)), {}};
      for (const std::string &value :
           split_at(text.substr(equal_sign + 1), "|"))
        if (value.find("..") == std::string::npos)
          variation.values.push_back(value);
        else
          for (const std::string &one : range_of_values(value))
            variation.values.push_back(one);
      if (variation.path.empty() || variation.path.back() == '/')
        fail("no entry before '='");
      if (variation.path.rfind("Study/", 0) == 0 ||
          variation.path == "Output/Directory")
        fail("an entry that is the study's own");
      if (variation.path.rfind("Scales/", 0) == 0 ||
          variation.path == "Output/SI")
        fail("units, which all rows of study.csv have in common,");
      for (const std::string &value : variation.values)
        if (value.empty())
          fail("an empty value");
        else if (const auto comma = value.find(',');
                 variation.path != "Output/Probes" && comma < value.size() &&
                 parse_number(value.substr(0, comma)))
          fail("a ',' behind a number, '|' separates values,");
        else if (const auto colon = value.find(':');
                 colon < value.size() && parse_number(value.substr(0, colon)))
          fail("a ':', which makes no range, write first .. last (n),");
      return variation;
    }



    /** The axes of a set. @param entry Vary or Reference, for messages */
    std::vector<StudyPlan::Axis>
    read_set(const std::string &entry, const std::string &set)
    {
      std::vector<StudyPlan::Axis> axes;
      std::set<std::string>        paths;
      for (const std::string &text : split_at(set, ";"))
        {
          StudyPlan::Axis axis;
          for (const std::string &part : split_entries(text))
            {
              axis.push_back(read_variation(entry, part));
              const auto n = axis.back().values.size();
              if (n != axis.front().values.size())
                refuse_notation(entry,
                                text,
                                std::to_string(axis.front().values.size()) +
                                  " values of the first and " +
                                  std::to_string(n) +
                                  " of another entry that goes with it");
            }
          for (const StudyPlan::Variation &variation : axis)
            if (!paths.insert(variation.path).second)
              throw InputError("Study/" + entry + ": " + quote(variation.path) +
                               " twice in one run\n  remedy:  name each entry "
                               "once");
          axes.push_back(axis);
        }
      return axes;
    }



    double
    n_runs_of(const std::vector<StudyPlan::Axis> &set)
    {
      double n = 1.;
      for (const StudyPlan::Axis &axis : set)
        n *= axis.front().values.size();
      return n;
    }



    std::vector<std::vector<StudyPlan::Axis>>
    read_sets(const std::string &vary)
    {
      std::vector<std::vector<StudyPlan::Axis>> sets;
      double                                    n_all = 0.;
      for (const std::string &set : split_at(vary, ";;"))
        {
          sets.push_back(read_set("Vary", set));
          n_all += n_runs_of(sets.back());
          if (n_all > StudyPlan::max_runs)
            throw InputError(text("Study/Vary: ",
                                  n_all,
                                  " runs or more\n  allowed: at most ",
                                  StudyPlan::max_runs,
                                  "\n  remedy:  fewer values, or several "
                                  "studies"));
        }
      return sets;
    }



    std::vector<std::string>
    paths_of(const std::vector<std::vector<StudyPlan::Axis>> &sets)
    {
      std::vector<std::string> paths;
      for (const auto &set : sets)
        for (const StudyPlan::Axis &axis : set)
          for (const auto &[path, values] : axis)
            if (std::find(paths.begin(), paths.end(), path) == paths.end())
              paths.push_back(path);
      return paths;
    }



    std::optional<Overrides>
    read_reference(const std::string &text)
    {
      if (text == "none")
        return {};
      Overrides reference;
      for (const StudyPlan::Axis &axis : read_set("Reference", text))
        for (const auto &[path, values] : axis)
          {
            if (values.size() > 1)
              throw InputError("Study/Reference: several values of " +
                               quote(path) +
                               "\n  allowed: one value per entry");
            reference.emplace_back(path, values[0]);
          }
      return reference;
    }



    /** The meaning of an error, which is one of nondimensional quantities. */
    void
    check_scales_of_errors(const ScalesParameters &a,
                           const ScalesParameters &b,
                           const std::string      &what)
    {
      for (const ScalesParameters::Scale &scale : ScalesParameters::all())
        if (a.*scale.value != b.*scale.value)
          throw InputError("Study/Reference: " + quote(what) +
                           " makes another rod, and no errors are measured "
                           "between two\n  allowed: entries that leave the "
                           "scales as they are\n  remedy:  Study/Reference = "
                           "none");
    }



    /** The value of @p path among overrides, or nothing. */
    std::optional<std::string>
    find_override(const Overrides &overrides, const std::string &path)
    {
      for (const auto &[name, value] : overrides)
        if (name == path)
          return value;
      return {};
    }
  } // namespace



  StudyPlan::StudyPlan(const std::vector<Assignment> &assignments,
                       const StudyParameters         &parameters)
    : assignments(assignments)
    , sets(read_sets(parameters.vary))
    , varied(paths_of(sets))
    , reference(read_reference(parameters.reference))
  {
    if (!reference && parameters.target_error > 0.)
      throw InputError("Study/Target error: there is no reference to "
                       "measure errors against\n  remedy:  Study/Reference "
                       "= Time/Tolerance = 1e-9, or another run that is "
                       "much more accurate");
    double n_all = 0.;
    for (const auto &set : sets)
      {
        first_runs.push_back(n_all);
        n_all += n_runs_of(set);
      }
    first_runs.push_back(n_all);
    check_values();
    if (reference)
      check_reference();
  }



  void
  StudyPlan::check_values()
  {
    SceneReader            reader(assignments);
    const double           own_end_time = reader.scene().time.end_time;
    const ScalesParameters own_scales   = reader.scene().scales;
    for (const std::string &path : varied)
      if (is_constant_path(path) &&
          std::none_of(assignments.begin(),
                       assignments.end(),
                       [&](const Assignment &own) { return own.path == path; }))
        throw InputError("Study/Vary: there is no " + quote(path) +
                         "\n  remedy:  section Constants with a value of it");
    for (const auto &axes : sets)
      {
        bool varies_end = false;
        for (const Axis &axis : axes)
          for (unsigned int i = 0; i < axis.front().values.size(); ++i)
            {
              Overrides together;
              bool      is_end = false, is_constant = false;
              for (const Variation &variation : axis)
                {
                  together.emplace_back(variation.path, variation.values[i]);
                  is_end |= variation.path == "Time/End time";
                  is_constant |= is_constant_path(variation.path);
                }
              reader.read("Study/Vary", together);
              if (reference)
                check_scales_of_errors(own_scales,
                                       reader.scene().scales,
                                       together.front().first + " = " +
                                         together.front().second);
              if (is_end || is_constant)
                longest = std::max(longest, reader.scene().time.end_time);
              varies_end |= is_end;
            }
        if (!varies_end)
          longest = std::max(longest, own_end_time);
      }
    for (const std::string &path : varied)
      own_values.push_back(reader.own_value(path));
  }



  void
  StudyPlan::check_reference() const
  {
    SceneReader            reader(assignments);
    const ScalesParameters own_scales = reader.scene().scales;
    try
      {
        read_scene(*reference, reader);
      }
    catch (const InputError &error)
      {
        throw InputError(std::string("Study/Reference: ") + error.what());
      }
    check_scales_of_errors(own_scales, reader.scene().scales, "an entry of it");
    if (reader.scene().time.end_time < longest)
      throw InputError("Study/Reference: it ends at t = " +
                       find_override(*reference, "Time/End time")
                         .value_or(reader.own_value("Time/End time")) +
                       ", before the longest run\n  remedy:  give it the "
                       "largest Time/End time of all runs");
  }



  unsigned int
  StudyPlan::set_of(const unsigned int run) const
  {
    return std::upper_bound(first_runs.begin(), first_runs.end(), run) -
           first_runs.begin() - 1;
  }



  Overrides
  StudyPlan::overrides(const unsigned int run) const
  {
    const unsigned int set = set_of(run);
    unsigned int       n   = run - first_runs[set];
    Overrides          result;
    for (auto axis = sets[set].rbegin(); axis != sets[set].rend(); ++axis)
      {
        const unsigned int n_values = axis->front().values.size();
        for (auto v = axis->rbegin(); v != axis->rend(); ++v)
          result.emplace_back(v->path, v->values[n % n_values]);
        n /= n_values;
      }
    std::reverse(result.begin(), result.end());
    return result;
  }



  std::vector<std::string>
  StudyPlan::entries(const unsigned int run) const
  {
    const Overrides          present = overrides(run);
    std::vector<std::string> values;
    for (unsigned int i = 0; i < varied.size(); ++i)
      values.push_back(without_unit(
        {"",
         varied[i],
         find_override(present, varied[i]).value_or(own_values[i])}));
    return values;
  }



  std::string
  StudyPlan::description(const unsigned int run) const
  {
    std::vector<std::string> words;
    for (const auto &[path, value] : overrides(run))
      words.push_back(path + " = " + value);
    return text("run ", run, ": ") + join_words(words);
  }



  std::unique_ptr<const Scene>
  StudyPlan::read_scene(const Overrides &overrides, SceneReader &reader) const
  {
    reader.read(reference && overrides == *reference ? "Study/Reference" :
                                                       "Study/Vary",
                overrides);
    auto scene = std::make_unique<const Scene>(reader.scene());
    for (const auto &unused : unused_entries(*scene))
      if (const auto value = find_override(overrides, unused.path))
        throw InputError(unused.path + " = " + *value +
                         " has no effect, since " + unused.reason);
    check_scene(*scene);
    return scene;
  }
} // namespace ThermoContact
