// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What loads do in time, found by enclosures: every jump and every kink, to 2
// units in the last place of its time, nothing else, and no pulse passed by
// steps that go as far as largest_step() and the breaks let them.
//
// 1. Breaks by closed forms, T = 10: each case says them. A jump is between two
//    neighbouring doubles: of t > 1 from 1 on, of floor(4 t), t >= 1 before it.
//    |sin(7 t)| has kinks at k pi/7, k = 1 ... 22; max(0, sin(3 t)) at k pi/3,
//    k = 0 ... 9; sin(5 t) > 0.2 changes at (asin 0.2 + 2 pi k)/5 and
//    (pi - asin 0.2 + 2 pi k)/5: 16 times; if(t*t>2,t*t-2,0) has the slope 0
//    before sqrt(2) and 2.8 behind it. Smooth functions have none.
// 2. Pulses of the widths w = 1e-1 ... 1e-9 around 3.3217, T = 10: Gaussian, on
// a
//    sine ten times as high, rectangular (2 jumps), triangular
//    (3 kinks). Steps are shorter than w where a smooth pulse is above 1/e, and
//    fewer than 100; no more than 500 enclosures each (measured 81 to 255).
// 3. Two jumps one double apart are one, from before the first to behind the
//    second. 1/(t - 5) is not finite at 5; sin(1e6 t) is not resolved.
// 4. An enclosure contains the values and derivatives at 1000 times in 2150
//    spans of all functions of the language; derivatives are those of
//    differences over 2e-5.

#include <thermocontact/input/load_enclosure.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "../tests.h"

using namespace ThermoContact;

namespace
{
  constexpr double pi = numbers::PI;



  TimeFunction
  function(const std::string &text)
  {
    return TimeFunction(
      Expression("Boundary/right/Traction", text, {{"", "", "", "t"}, {}}));
  }



  /** In units of the last place of the larger one. */
  double
  ulps(const double a, const double b)
  {
    const double size = std::max(std::abs(a), std::abs(b));
    return std::abs(a - b) /
           (std::nextafter(size, 2. * size + 1e-300) - size + 1e-300);
  }



  struct Case
  {
    std::string         text;
    std::vector<double> jumps, kinks;
  };



  std::vector<double>
  multiples(const double       step,
            const unsigned int first,
            const unsigned int last)
  {
    std::vector<double> times;
    for (unsigned int k = first; k <= last; ++k)
      times.push_back(k * step);
    return times;
  }



  unsigned int n_cases = 0, n_good = 0;

  void
  check(const Case &expected)
  {
    const EnclosedLoad  load = enclose_load(function(expected.text), 10.);
    std::vector<double> jumps, kinks;
    bool                are_neighbours = true;
    for (const LoadBreak &at : load.history.breaks)
      {
        (at.is_jump ? jumps : kinks).push_back(at.time);
        are_neighbours &=
          !at.is_jump || at.new_time == std::nextafter(at.time, 20.);
      }
    double     worst   = 0.;
    const auto compare = [&](const std::vector<double> &found,
                             const std::vector<double> &known) {
      if (found.size() != known.size())
        return false;
      for (unsigned int i = 0; i < found.size(); ++i)
        raise(worst, ulps(found[i], known[i]));
      return true;
    };
    const bool are_all =
      compare(jumps, expected.jumps) && compare(kinks, expected.kinks);
    ++n_cases;
    if (load.is_resolved && are_all && are_neighbours && worst <= 2.)
      ++n_good;
    else
      deallog << expected.text << ": " << load.is_resolved << are_neighbours
              << ", jumps " << jumps.size() << ", kinks " << kinks.size()
              << ", off by " << worst << " units in the last place"
              << std::endl;
  }



  void
  check_breaks()
  {
    std::vector<double> crossings;
    for (unsigned int k = 0; k < 8; ++k)
      for (const double angle : {std::asin(0.2), pi - std::asin(0.2)})
        crossings.push_back((angle + 2. * pi * k) / 5.);
    for (const Case &expected : std::vector<Case>{
           {"if(t>1,2,0)", {1.}, {}},
           {"abs(sin(7*t))", {}, multiples(pi / 7., 1, 22)},
           {"exp(-((t-3.3)/1e-2)^2)", {}, {}},
           {"exp(-((t-3.3)/1e-6)^2)", {}, {}},
           {"1e-3*sin(t)+exp(-((t-3.3217)/1e-7)^2)", {}, {}},
           {"sin(2*pi*50*t)", {}, {}},
           {"floor(t*4)/10", multiples(0.25, 1, 40), {}},
           {"max(0,sin(3*t))", {}, multiples(pi / 3., 0, 9)},
           {"if(t>0.3,if(t<0.3000001,1,0),0)", {0.3, 0.3000001}, {}},
           {"sqrt(t)", {}, {0.}},
           {"t*exp(-t)*sin(20*t)", {}, {}},
           {"if(sin(5*t)>0.2,1,-1)", crossings, {}},
           {"tanh((t-5)/1e-4)", {}, {}},
           {"if(t*t>2,t*t-2,0)", {}, {std::sqrt(2.)}},
           {"0.1*cos(3*t)*if(t<4,1,exp(-(t-4)))", {}, {4.}},
           {"max(0,1-abs(t-2)/1e-5)", {}, {2. - 1e-5, 2., 2. + 1e-5}},
           // others
           {"t>=1", {1.}, {}},
           {"t<1 ? 3*t : 5", {1.}, {}},
           {"(t>1 && t<2)*t", {1., 2.}, {}},
           {"t<1 || t>2", {1., 2.}, {}},
           {"if((t>1)&(t<2),1,0)", {1., 2.}, {}},
           {"if((t<1)|(t>2),1,0)", {1., 2.}, {}},
           {"ceil(t/5)", {0., 5.}, {}},
           {"rint(t/4)", {2., 6., 10.}, {}},
           {"int(t/4)", {2., 6., 10.}, {}},
           {"sign(t^2-2)", {std::sqrt(2.)}, {}},
           {"t-2*floor(t/2)", {2., 4., 6., 8., 10.}, {}},
           {"(t-2*floor(t/2))<0.5",
            {0.5, 2., 2.5, 4., 4.5, 6., 6.5, 8., 8.5, 10.},
            {}},
           {"min(t,3,9-t)", {}, {3., 6.}},
           {"if(t<2,t^2,4*t-4)", {}, {}},
           {"max(0,t-2)^2", {}, {}},
           {"abs(t-3)^1.5", {}, {}},
           {"sum(t>1,t>2,t>3)", {1., 2., 3.}, {}},
           {"avg(abs(t-1),abs(t-2))", {}, {1., 2.}},
           {"cos(2*t)^2", {}, {}},
           {"atan2(t-5,1)", {}, {}},
           {"erf((t-2)/1e-3)", {}, {}},
           {"sinh(t/9)*cosh(t/7)-asinh(t)+log(1+t)", {}, {}},
           {"pow(t,3)/(1+t^2)", {}, {}},
           {"1e-9*(t>4)", {4.}, {}},
           {"1e9+100*(t>4)", {4.}, {}},
           {"2e4+3e-10*t^2", {}, {}},
           {"if(t>1,2,2)", {}, {}}})
      check(expected);
    deallog << "breaks: " << n_good << " of " << n_cases << " cases"
            << std::endl;
  }



  /** Whether steps that are as long as they may be see a smooth pulse. */
  bool
  is_seen(const LoadHistory &history, const double centre, const double width)
  {
    double       longest = 0., time = 0.;
    unsigned int n = 0;
    for (; time < 10. && n < 1000; ++n)
      {
        const double end = time + history.largest_step(time, 10.);
        if (end > centre - width && time < centre + width)
          raise(longest, end - time);
        time = end;
      }
    return longest < width && n < 100;
  }



  void
  check_pulses()
  {
    constexpr double centre = 3.3217;
    unsigned int     n_seen = 0, n_sharp = 0, n_quick = 0;
    for (int exponent = -1; exponent >= -9; --exponent)
      {
        const double       width = std::pow(10., exponent);
        std::ostringstream w;
        w << "1e" << exponent;
        const std::string x     = "((t-3.3217)/" + w.str() + ")";
        const std::string gauss = "exp(-" + x + "^2)";
        for (const std::string &text : {gauss, "10*sin(t/2)+" + gauss})
          {
            const EnclosedLoad load = enclose_load(function(text), 10.);
            n_seen += load.history.breaks.empty() &&
                      is_seen(load.history, centre, width);
            n_quick += load.n_evaluations <= 500;
          }
        for (const std::string &text :
             {"if(abs" + x + "<1,1,0)", "max(0,1-abs" + x + ")"})
          {
            const EnclosedLoad load = enclose_load(function(text), 10.);
            const auto        &at   = load.history.breaks;
            n_quick += load.n_evaluations <= 500;
            const bool is_box = at.size() == 2 && at[0].is_jump;
            // abs(t - 3.3217) is exact to an ulp of 3.3
            n_sharp += (is_box || at.size() == 3) &&
                       std::abs(at.front().time - (centre - width)) < 2e-15 &&
                       std::abs(at.back().time - (centre + width)) < 2e-15;
          }
      }
    deallog << "pulses: seen " << n_seen << " of 18, ends found " << n_sharp
            << " of 18, in 500 enclosures " << n_quick << " of 36" << std::endl;
  }



  void
  check_others()
  {
    const EnclosedLoad close =
      enclose_load(function("(t>1)+(t>1.0000000000000002)"), 10.);
    deallog << "close jumps: " << close.history.breaks.size() << ' '
            << (close.history.breaks.at(0).time == 1.)
            << (close.history.breaks[0].new_time == 1. + 4.5e-16) << std::endl;
    const EnclosedLoad pole = enclose_load(function("1/(t-5)"), 10.);
    const EnclosedLoad fast = enclose_load(function("sin(1e6*t)"), 10.);
    deallog << "pole: " << pole.is_resolved << pole.is_infinite << ' '
            << pole.time << ", fast: " << fast.is_resolved << fast.is_infinite
            << std::endl;
  }



  bool
  contains(const Interval &interval, const double number)
  {
    // derivatives are rounded, too
    const double slack = 1e-9 * std::max(std::abs(number), 1e-300);
    return !std::isfinite(number) ||
           (interval.low <= number + slack && number - slack <= interval.high);
  }



  void
  check_enclosures()
  {
    std::ofstream("rows.csv") << "t,u\n0.5,5\n1,-2\n4,3\n6,9\n9,1\n";
    unsigned int n_spans = 0, n_outside = 0;
    for (const std::string text : {"sin(3*t)",
                                   "cos(t)-2*t",
                                   "tan(t)",
                                   "asin(t/10)",
                                   "acos(t/10)",
                                   "atan(t-2)",
                                   "atan2(t-3,2-t)",
                                   "sinh(t)",
                                   "cosh(t-3)",
                                   "tanh(t-3)",
                                   "asinh(t-3)",
                                   "acosh(1+t)",
                                   "atanh(t/11)",
                                   "sec(t)",
                                   "csc(t+0.1)",
                                   "cot(t+0.1)",
                                   "exp(-t)",
                                   "log(t+0.1)",
                                   "log2(t+0.1)",
                                   "log10(t+1)",
                                   "sqrt(t)",
                                   "pow(t,2.5)",
                                   "erf(t-3)",
                                   "erfc(t-3)",
                                   "abs(t-3)",
                                   "sign(t-3)",
                                   "rint(t)",
                                   "int(t-3)",
                                   "floor(t)",
                                   "ceil(t)",
                                   "if(t>3,t,1)",
                                   "min(t,3,5-t)",
                                   "max(t,4-t)",
                                   "t^3-t^4",
                                   "2^t",
                                   "(t+1)^-2+(t+1)^t",
                                   "(t-4)/(t-6)",
                                   "-t^2*(t<4)",
                                   "t>3 ? t : -t",
                                   "(t>2&&t<4)+(t<1||t>6)",
                                   "(t==3)+(t!=4)",
                                   "table(rows.csv,t)",
                                   "smooth(rows.csv,t)"})
      {
        const TimeFunction f = function(std::string(text) + "+0*t");
        constexpr double   h = 1e-5;
        for (const double t : {0.37, 2.6, 4.7, 6.2})
          {
            const TimeDerivatives at   = f.derivatives(t),
                                  old  = f.derivatives(t - h),
                                  next = f.derivatives(t + h);
            const double first         = (next.value - old.value) / (2. * h);
            const double second        = (next.first - old.first) / (2. * h);
            if (!(std::abs(first - at.first) < 1e-5 * (1. + std::abs(first)) &&
                  std::abs(second - at.second) <
                    1e-5 * (1. + std::abs(second))))
              deallog << text << " at " << t << ": derivatives " << at.first
                      << ' ' << at.second << ", by differences " << first << ' '
                      << second << std::endl;
          }
        double     seed = 0.37;
        const auto draw = [&seed]() {
          seed = std::fmod(997. * seed + 0.123456789, 1.);
          return seed;
        };
        for (unsigned int i = 0; i < 50; ++i)
          {
            const double low      = 10. * draw(),
                         width    = std::pow(10., -8. * draw());
            const IntervalJet all = f.enclosure({low, low + width});
            ++n_spans;
            for (unsigned int j = 0; j <= 20; ++j)
              {
                const double t = std::min(low + j * width / 20., low + width);
                const TimeDerivatives at = f.derivatives(t);
                if (!contains(all.value, f.value(t)) ||
                    !contains(all.value, at.value) ||
                    !contains(all.first, at.first) ||
                    !contains(all.second, at.second))
                  {
                    ++n_outside;
                    deallog << text << " at " << t << ": " << at.value << ' '
                            << at.first << ' ' << at.second << std::endl;
                    break;
                  }
              }
          }
      }
    deallog << "enclosures: " << n_spans << " spans, outside " << n_outside
            << std::endl;
  }
} // namespace



void
main_load_enclosure()
{
  initlog();
  check_breaks();
  check_pulses();
  check_others();
  check_enclosures();
}
