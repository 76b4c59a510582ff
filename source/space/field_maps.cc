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



  template <int dim>
  FieldMaps::FieldMaps(const CellProducts<dim, double> &products)
    : heat_mass{[&](Vector &y, const Vector &x) {
      products.vmult(Field::temperature, 1., 0., y, x);
    }}
    , conduction{[&](Vector &y, const Vector &x) {
      products.vmult(Field::temperature, 0., 1., y, x);
    }}
    , lateral_exchange{[&](Vector &y, const Vector &x) {
      products.lateral_exchange(y, x);
    }}
    , divergence{[&](Vector &y, const Vector &x) { products.divergence(y, x); }}
    , thermal_stress{[&](Vector &y, const Vector &x) {
      products.thermal_stress(y, x);
    }}
    , momentum_mass{[&](Vector &y, const Vector &x) {
      products.vmult(Field::displacement, 1., 0., y, x);
    }}
    , stiffness{[&](Vector &y, const Vector &x) {
      products.vmult(Field::displacement, 0., 1., y, x);
    }}
    , viscous_stiffness{[&](Vector &y, const Vector &x) {
      products.vmult(Field::displacement, 0., 1., y, x);
      products.add_contact_viscosity(1., y, x);
    }}
  {}



  template FieldMaps::FieldMaps(const FieldMatrices<1> &, const RodMatrices *);
  template FieldMaps::FieldMaps(const FieldMatrices<2> &, const RodMatrices *);
  template FieldMaps::FieldMaps(const FieldMatrices<3> &, const RodMatrices *);
  template FieldMaps::FieldMaps(const CellProducts<2, double> &);
  template FieldMaps::FieldMaps(const CellProducts<3, double> &);
} // namespace ThermoContact
