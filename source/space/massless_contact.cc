// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/tolerances.h>
#include <thermocontact/space/massless_contact.h>

#include <deal.II/base/polynomial.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <vector>

namespace ThermoContact
{
  namespace
  {
    /** Lagrange polynomials of the nodes of FE_Q on (0, 1) other than 1. */
    std::vector<Polynomials::Polynomial<double>>
    basis_off_contact(const unsigned int degree)
    {
      std::vector<Point<1>> points = QGaussLobatto<1>(degree + 1).get_points();
      points.pop_back();
      return Polynomials::generate_complete_Lagrange_basis(points);
    }



    template <int dim>
    Quadrature<dim>
    tensor_product(const Quadrature<1> &along, const Quadrature<1> &across)
    {
      if constexpr (dim == 1)
        return along;
      else if constexpr (dim == 2)
        return QAnisotropic<2>(along, across);
      else
        return QAnisotropic<3>(along, across, across);
    }



    Quadrature<1>
    mass_rule(const unsigned int degree, const bool is_lumped)
    {
      if (is_lumped)
        return QGaussLobatto<1>(degree + 1);
      return QGauss<1>(degree + 1);
    }
  } // namespace



  template <int dim>
  Quadrature<dim>
  mass_quadrature(const unsigned int degree, const bool is_lumped)
  {
    const Quadrature<1> rule = mass_rule(degree, is_lumped);
    return tensor_product<dim>(rule, rule);
  }



  template <int dim>
  Quadrature<dim>
  massless_quadrature(const unsigned int degree, const bool is_lumped)
  {
    const QGaussLobatto<1> nodes(degree + 1);
    const QGauss<1>        exact_rule(degree + 1);
    std::vector<Point<1>>  points;
    std::vector<double>    weights;
    for (const auto &polynomial : basis_off_contact(degree))
      {
        points.push_back(nodes.point(weights.size()));
        double weight = 0.;
        for (unsigned int q = 0; q < exact_rule.size(); ++q)
          weight +=
            polynomial.value(exact_rule.point(q)[0]) * exact_rule.weight(q);
        weights.push_back(weight);
      }
    return tensor_product<dim>(Quadrature<1>(points, weights),
                               mass_rule(degree, is_lumped));
  }



  std::vector<double>
  extension_from_other_nodes(const unsigned int degree)
  {
    std::vector<double> factors;
    for (const auto &polynomial : basis_off_contact(degree))
      factors.push_back(polynomial.value(1.));
    return factors;
  }



  template <int dim>
  FullMatrix<double>
  extension_to_contact_nodes(const Discretization<dim> &discretization)
  {
    const FiniteElement<dim> &fe = discretization.finite_element();
    const unsigned int        n  = fe.dofs_per_cell;
    const unsigned int        axial =
      discretization.first_component(Field::displacement);
    const std::vector<double>   factors = extension_from_other_nodes(fe.degree);
    const std::vector<Point<1>> nodes =
      QGaussLobatto<1>(fe.degree + 1).get_points();
    const auto is_axial = [&](const unsigned int i) {
      return fe.system_to_component_index(i).first == axial;
    };

    FullMatrix<double> extension{IdentityMatrix(n)};
    for (unsigned int i = 0; i < n; ++i)
      if (is_axial(i) &&
          fe.unit_support_point(i)[0] > 1. - Tolerances::rounding_of_data)
        {
          extension(i, i) = 0.;
          for (unsigned int j = 0; j < n; ++j)
            {
              Point<dim> shifted = fe.unit_support_point(j);
              shifted[0]         = 1.;
              if (!is_axial(j) || shifted.distance(fe.unit_support_point(i)) >
                                    Tolerances::rounding_of_data)
                continue;
              for (unsigned int k = 0; k < factors.size(); ++k)
                if (std::abs(nodes[k][0] - fe.unit_support_point(j)[0]) <
                    Tolerances::rounding_of_data)
                  extension(i, j) = factors[k];
            }
        }
    return extension;
  }



#define INSTANTIATE(dim)                                                   \
  template Quadrature<dim>    mass_quadrature<dim>(const unsigned int,     \
                                                const bool);            \
  template Quadrature<dim>    massless_quadrature<dim>(const unsigned int, \
                                                    const bool);        \
  template FullMatrix<double> extension_to_contact_nodes<dim>(             \
    const Discretization<dim> &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
