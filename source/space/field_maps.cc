// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/field_maps.h>
#include <thermocontact/space/matrix_free_operator.h>

namespace ThermoContact
{
  namespace
  {
    std::unique_ptr<const LinearMap>
    map(const SparseMatrix &matrix)
    {
      return std::make_unique<MatrixMap>(matrix);
    }



    /** What the scene does not have can be named all the same, not used. */
    void
    fill_absent(FieldMaps &maps)
    {
      for (auto *const map : {&maps.heat_mass,
                              &maps.conduction,
                              &maps.divergence,
                              &maps.thermal_stress,
                              &maps.momentum_mass,
                              &maps.stiffness,
                              &maps.viscous_stiffness,
                              &maps.lateral_exchange})
        if (*map == nullptr)
          *map = std::make_unique<FunctionMap>([](Vector &, const Vector &) {
            AssertThrow(false, dealii::ExcInternalError());
          });
    }



    template <int dim>
    FieldMaps
    make_maps(const Scene &scene, const FieldMatrices<dim> &matrices)
    {
      FieldMaps maps;
      if (scene.fields.has_temperature)
        {
          maps.heat_mass  = map(matrices.mass.block(0, 0));
          maps.conduction = map(matrices.stiffness.block(0, 0));
          if (scene.heat.has_lateral_exchange())
            maps.lateral_exchange = map(matrices.lateral_exchange.block(0, 0));
        }
      if (scene.fields.has_displacement)
        {
          maps.momentum_mass = map(last_block(matrices.mass));
          maps.stiffness     = map(last_block(matrices.stiffness));
        }
      if (scene.material.has_thermal_stress())
        {
          maps.divergence     = map(matrices.coupling.block(0, 1));
          maps.thermal_stress = map(matrices.coupling.block(1, 0));
        }
      if (scene.has_elastic_contact_nodes())
        maps.viscous_stiffness = map(last_block(matrices.viscous_stiffness));
      return maps;
    }



    template <int dim>
    FieldMaps
    make_maps(const MatrixFreeOperator<dim> &products)
    {
      using Operator  = MatrixFreeOperator<dim>;
      const auto heat = [&](const typename Operator::HeatFactors &factors) {
        return std::make_unique<FunctionMap>(
          [&products, factors](Vector &y, const Vector &x) {
            products.heat(factors, y, x);
          });
      };
      const auto momentum =
        [&](const typename Operator::MomentumFactors &factors) {
          return std::make_unique<FunctionMap>(
            [&products, factors](Vector &y, const Vector &x) {
              products.momentum(factors, y, x);
            });
        };
      FieldMaps maps;
      maps.heat_mass     = heat({1., 0.});
      maps.conduction    = heat({0., 1.});
      maps.momentum_mass = momentum({1., 0.});
      maps.stiffness     = momentum({0., 1.});
      maps.divergence    = std::make_unique<FunctionMap>(
        [&products](Vector &y, const Vector &x) { products.divergence(y, x); });
      maps.thermal_stress =
        std::make_unique<FunctionMap>([&products](Vector &y, const Vector &x) {
          products.thermal_stress(y, x);
        });
      maps.lateral_exchange =
        std::make_unique<FunctionMap>([&products](Vector &y, const Vector &x) {
          products.lateral_exchange(y, x);
        });
      return maps;
    }



    FieldMaps
    make_maps(const RodMatrices &matrices)
    {
      const auto rod_map = [&](const RodMatrices::Matrix matrix) {
        return std::make_unique<RodMap>(matrices, matrix);
      };
      FieldMaps maps;
      maps.heat_mass         = rod_map(RodMatrices::heat_mass);
      maps.conduction        = rod_map(RodMatrices::conduction);
      maps.divergence        = rod_map(RodMatrices::divergence);
      maps.thermal_stress    = rod_map(RodMatrices::thermal_stress);
      maps.momentum_mass     = rod_map(RodMatrices::momentum_mass);
      maps.stiffness         = rod_map(RodMatrices::stiffness);
      maps.viscous_stiffness = rod_map(RodMatrices::viscous_stiffness);
      return maps;
    }
  } // namespace



  template <int dim>
  FieldMaps
  make_field_maps(const Scene                   &scene,
                  const FieldMatrices<dim>      *matrices,
                  const RodMatrices             *rod,
                  const MatrixFreeOperator<dim> *products)
  {
    FieldMaps maps;
    if (rod != nullptr)
      {
        maps = make_maps(*rod);
        if (scene.heat.has_lateral_exchange())
          maps.lateral_exchange = map(matrices->lateral_exchange.block(0, 0));
      }
    else if (products != nullptr)
      {
        if constexpr (dim > 1)
          maps = make_maps(*products);
      }
    else
      maps = make_maps(scene, *matrices);
    fill_absent(maps);
    return maps;
  }



#define INSTANTIATE(dim)                                              \
  template FieldMaps make_field_maps<dim>(const Scene &,              \
                                          const FieldMatrices<dim> *, \
                                          const RodMatrices *,        \
                                          const MatrixFreeOperator<dim> *)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
