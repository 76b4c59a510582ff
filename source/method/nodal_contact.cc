// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/exceptions.h>
#include <thermocontact/method/nodal_contact.h>

#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ThermoContact
{
  namespace
  {
    using dealii::FullMatrix;

    /** What node @p i loses by all pressures. */
    double
    loss(const FullMatrix<double>  &response,
         const std::vector<double> &pressure,
         const unsigned int         i)
    {
      double sum = 0.;
      for (unsigned int j = 0; j < pressure.size(); ++j)
        sum += response(i, j) * pressure[j];
      return sum;
    }



    /** The nodes at some x. */
    struct Nodes
    {
      std::vector<double> x, pressure, defect;
      double              largest_defect = 0.;
      double              scale          = 0.; ///< of what a defect consists
    };



    /** Defects of the pressures. */
    void
    measure(const FullMatrix<double>  &response,
            const std::vector<double> &free_x,
            Nodes                     &nodes)
    {
      const unsigned int n = nodes.x.size();
      nodes.defect.resize(n);
      nodes.largest_defect = nodes.scale = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double by_pressure = loss(response, nodes.pressure, i);
          nodes.defect[i]          = nodes.x[i] + by_pressure - free_x[i];
          // a NaN is no small defect
          nodes.largest_defect =
            std::abs(nodes.defect[i]) <= nodes.largest_defect ?
              nodes.largest_defect :
              std::abs(nodes.defect[i]);
          nodes.scale = std::max({nodes.scale,
                                  std::abs(free_x[i]),
                                  std::abs(nodes.x[i]),
                                  std::abs(by_pressure)});
        }
    }



    /** Pressures of the law, and defects. */
    void
    evaluate(const NodalLaws           &laws,
             const FullMatrix<double>  &response,
             const std::vector<double> &free_x,
             Nodes                     &nodes)
    {
      nodes.pressure.resize(nodes.x.size());
      for (unsigned int i = 0; i < nodes.x.size(); ++i)
        nodes.pressure[i] = laws.pressure(i, nodes.x[i]);
      measure(response, free_x, nodes);
    }



    /** Where a step of Newton's method leads to. */
    std::vector<double>
    newton_step(const NodalLaws          &laws,
                const FullMatrix<double> &response,
                const Nodes              &nodes)
    {
      const unsigned int     n = nodes.x.size();
      FullMatrix<double>     matrix(response);
      dealii::Vector<double> rhs(n), change(n);
      std::vector<double>    scale(n);
      for (unsigned int j = 0; j < n; ++j)
        {
          // columns of stiff nodes are larger by any factor: their diagonal is
          // made 1
          const double stiffness =
            laws.stiffness(j, nodes.x[j], nodes.pressure[j]);
          scale[j] = 1. + stiffness * response(j, j);
          for (unsigned int i = 0; i < n; ++i)
            matrix(i, j) *= stiffness / scale[j];
          matrix(j, j) = 1.;
          rhs(j)       = nodes.defect[j];
        }
      matrix.gauss_jordan();
      matrix.vmult(change, rhs);
      std::vector<double> x(nodes.x);
      for (unsigned int i = 0; i < n; ++i)
        x[i] -= change(i) / scale[i];
      return x;
    }



    /** One node after another meets its law. */
    void
    sweep(const NodalLaws           &laws,
          const FullMatrix<double>  &response,
          const std::vector<double> &free_x,
          Nodes                     &nodes)
    {
      std::vector<double> &p = nodes.pressure;
      for (unsigned int i = 0; i < p.size(); ++i)
        {
          const double alone =
            free_x[i] - loss(response, p, i) + response(i, i) * p[i];
          p[i]       = laws.local_pressure(i, alone, response(i, i));
          nodes.x[i] = laws.position(i, alone, response(i, i), p[i]);
        }
    }
  } // namespace



  unsigned int
  solve_nodal_contact(const NodalLaws           &laws,
                      const FullMatrix<double>  &response,
                      const std::vector<double> &free_x,
                      std::vector<double>        x,
                      std::vector<double>       &pressure)
  {
    constexpr unsigned int max_iterations = 1000;
    constexpr double       smallest_part  = 1e-6; // of a step
    const unsigned int     n              = free_x.size();
    Nodes                  nodes;
    nodes.x = std::move(x);
    evaluate(laws, response, free_x, nodes);
    double smallest_defect = nodes.largest_defect;
    for (unsigned int iteration = 1; iteration <= max_iterations; ++iteration)
      {
        const std::vector<double> aim = newton_step(laws, response, nodes);
        Nodes                     trial(nodes);
        bool                      is_better = false;
        for (double part = 1.; part > smallest_part && !is_better; part *= 0.5)
          {
            for (unsigned int i = 0; i < n; ++i)
              trial.x[i] = part * aim[i] + (1. - part) * nodes.x[i];
            evaluate(laws, response, free_x, trial);
            is_better = trial.largest_defect < smallest_defect;
          }
        if (is_better)
          nodes = trial;
        if (nodes.largest_defect <= (is_better ? 1e-15 : 1e-13) * nodes.scale)
          {
            pressure = nodes.pressure;
            return iteration;
          }
        if (!is_better)
          {
            // with its pressures, which that of a rounded x may be far from:
            // a sweep may end farther away than it began, and what it begins
            // is not to be undone by a step back to where it began
            sweep(laws, response, free_x, nodes);
            measure(response, free_x, nodes);
          }
        smallest_defect = std::min(nodes.largest_defect, smallest_defect);
      }
    throw ComputationError("the pressures of " + std::to_string(n) +
                           " contact nodes were not found\n  remedy:  a "
                           "smaller Time/Step size");
  }
} // namespace ThermoContact
