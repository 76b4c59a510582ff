// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/nonlinear_body.h>
#include <thermocontact/space/nonlinear_rod.h>

namespace ThermoContact
{
  template <int dim>
  std::unique_ptr<const NonlinearTerms<dim>>
  make_nonlinear_terms(const Scene                           &scene,
                       const ThermoviscoelasticOperator<dim> &equations)
  {
    if (!scene.sources.has_nonlinear_terms)
      return nullptr;
    if constexpr (dim == 1)
      return std::make_unique<const NonlinearRod>(scene, equations);
    else
      return std::make_unique<const NonlinearBody<dim>>(scene, equations);
  }



#define INSTANTIATE(dim)                                                    \
  template std::unique_ptr<const NonlinearTerms<dim>> make_nonlinear_terms( \
    const Scene &, const ThermoviscoelasticOperator<dim> &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
