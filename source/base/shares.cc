// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/shares.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace ThermoContact
{
  std::vector<unsigned int>
  shares(const std::vector<double> &weights, const unsigned int n)
  {
    const unsigned int wanted =
      std::max<unsigned int>(n, static_cast<unsigned int>(weights.size()));
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.);
    std::vector<unsigned int> counts(weights.size(), 1);
    for (std::size_t part = 0; part < counts.size(); ++part)
      counts[part] = std::max(1., std::floor(wanted * weights[part] / sum));
    unsigned int n_counted = std::accumulate(counts.begin(), counts.end(), 0U);
    const auto   excess    = [&](const std::size_t part) {
      return counts[part] - wanted * weights[part] / sum;
    };
    // one more where a share is the smallest against its weight, or one less
    while (n_counted != wanted)
      {
        std::size_t best = counts.size();
        for (std::size_t part = 0; part < counts.size(); ++part)
          if ((n_counted < wanted || counts[part] > 1) &&
              (best == counts.size() ||
               (n_counted < wanted ? excess(part) < excess(best) :
                                     excess(part) > excess(best))))
            best = part;
        counts[best] += n_counted < wanted ? 1 : -1;
        n_counted += n_counted < wanted ? 1 : -1;
      }
    return counts;
  }
} // namespace ThermoContact
