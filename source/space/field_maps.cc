// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/cell_products.h>
#include <thermocontact/space/field_maps.h>

namespace ThermoContact
{
  namespace
  {
    LinearMap
    map(const SparseMatrix &matrix)
    {
      return {[&matrix](Vector &y, const Vector &x) { matrix.vmult(y, x); }};
    }



    LinearMap
    map(const RodMatrices &rod, const FieldMatrix::Kind kind)
    {
      return {
        [&rod, kind](Vector &y, const Vector &x) {
          rod.combine<1>({{{1., kind, x.begin()}}}, 0., nullptr, y.begin());
        },
        [&rod, kind](const Vector &x, const Vector *y) {
          return y == nullptr ?
                   rod.form(kind, x.begin()) :
                   rod.form_of_difference(kind, x.begin(), y->begin());
        },
        nullptr,
        kind};
    }
  } // namespace



  template <int dim>
  FieldMaps::FieldMaps(const FieldMatrices<dim> &matrices,
                       const RodMatrices        *rod)
  {
    const auto set = [&](LinearMap &to, const FieldMatrix::Kind kind) {
      if (matrices.has(kind))
        to = rod != nullptr ? map(*rod, kind) : map(matrices[kind]);
    };
    set(heat_mass, FieldMatrix::heat_mass);
    set(conduction, FieldMatrix::conduction);
    set(lateral_exchange, FieldMatrix::lateral_exchange);
    set(divergence, FieldMatrix::divergence);
    set(thermal_stress, FieldMatrix::thermal_stress);
    set(momentum_mass, FieldMatrix::momentum_mass);
    set(stiffness, FieldMatrix::stiffness);
    viscous_stiffness = stiffness;
    set(viscous_stiffness, FieldMatrix::viscous_stiffness);
  }



  namespace
  {
    /** @param add adds a multiple of the product */
    template <typename Add>
    LinearMap
    map(const Add &add)
    {
      return {[add](Vector &y, const Vector &x) {
                y = 0.;
                add(1., x, y);
              },
              nullptr,
              add};
    }
  } // namespace



  template <int dim>
  FieldMaps::FieldMaps(const CellProducts<dim, double> &products)
  {
    const auto of_field = [&](const Field::Block field, const bool is_mass) {
      return map([&products, field, is_mass](const double  factor,
                                             const Vector &x,
                                             Vector       &y) {
        products.add(field, is_mass ? factor : 0., is_mass ? 0. : factor, y, x);
      });
    };
    heat_mass     = of_field(Field::temperature, true);
    conduction    = of_field(Field::temperature, false);
    momentum_mass = of_field(Field::displacement, true);
    stiffness     = of_field(Field::displacement, false);
    viscous_stiffness =
      map([&products](const double factor, const Vector &x, Vector &y) {
        products.add(Field::displacement, 0., factor, y, x);
        products.add_contact_viscosity(factor, y, x);
      });
    divergence =
      map([&products](const double factor, const Vector &x, Vector &y) {
        products.add_divergence(factor, y, x);
      });
    thermal_stress =
      map([&products](const double factor, const Vector &x, Vector &y) {
        products.add_thermal_stress(factor, y, x);
      });
    lateral_exchange =
      map([&products](const double factor, const Vector &x, Vector &y) {
        products.add_lateral_exchange(factor, y, x);
      });
  }



  template FieldMaps::FieldMaps(const FieldMatrices<1> &, const RodMatrices *);
  template FieldMaps::FieldMaps(const FieldMatrices<2> &, const RodMatrices *);
  template FieldMaps::FieldMaps(const FieldMatrices<3> &, const RodMatrices *);
  template FieldMaps::FieldMaps(const CellProducts<2, double> &);
  template FieldMaps::FieldMaps(const CellProducts<3, double> &);
} // namespace ThermoContact
