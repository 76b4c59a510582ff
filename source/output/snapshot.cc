// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/patch_units.h>
#include <thermocontact/output/snapshot.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    /** Rows of the stress in space; that of a rod is a scalar. */
    template <int dim>
    constexpr unsigned int n_rows = dim == 1 ? 1 : 3;

    template <int dim>
    constexpr unsigned int n_stresses = n_rows<dim> *n_rows<dim>;

    using Interpretation =
      DataComponentInterpretation::DataComponentInterpretation;

    /** Velocity alone, from a vector of both fields. */
    template <int dim>
    class VelocityPostprocessor : public DataPostprocessorVector<dim>
    {
    public:
      /** @param first component of the displacement */
      explicit VelocityPostprocessor(const unsigned int first)
        : DataPostprocessorVector<dim>("velocity", update_values)
        , first(first)
      {}

      void
      evaluate_vector_field(
        const DataPostprocessorInputs::Vector<dim> &inputs,
        std::vector<dealii::Vector<double>>        &computed) const override
      {
        for (unsigned int q = 0; q < computed.size(); ++q)
          for (unsigned int d = 0; d < dim; ++d)
            computed[q](d) = inputs.solution_values[q](first + d);
      }

      /** The displacement of a rod, alone in its FESystem, is a scalar. */
      void
      evaluate_scalar_field(
        const DataPostprocessorInputs::Scalar<dim> &inputs,
        std::vector<dealii::Vector<double>>        &computed) const override
      {
        for (unsigned int q = 0; q < computed.size(); ++q)
          computed[q](0) = inputs.solution_values[q];
      }

    private:
      const unsigned int first;
    };



    /**
     * Stress from a vector of $(\theta, u+\zeta v)$: n_stresses scalars,
     * which vtu_piece() makes a tensor.
     */
    template <int dim>
    class StressPostprocessor : public DataPostprocessor<dim>
    {
    public:
      /** @param body borrowed */
      explicit StressPostprocessor(const Body<dim> &body)
        : body(body)
        , first(body.discretization.first_component(Field::displacement))
      {}

      std::vector<std::string>
      get_names() const override
      {
        return std::vector<std::string>(n_stresses<dim>, "stress");
      }

      std::vector<Interpretation>
      get_data_component_interpretation() const override
      {
        return std::vector<Interpretation>(
          n_stresses<dim>, DataComponentInterpretation::component_is_scalar);
      }

      UpdateFlags
      get_needed_update_flags() const override
      {
        return update_values | update_gradients | update_quadrature_points;
      }

      void
      evaluate_vector_field(
        const DataPostprocessorInputs::Vector<dim> &inputs,
        std::vector<dealii::Vector<double>>        &computed) const override
      {
        for (unsigned int q = 0; q < computed.size(); ++q)
          {
            Tensor<1, dim> value;
            Tensor<2, dim> gradient;
            for (unsigned int d = 0; d < dim; ++d)
              {
                value[d]    = inputs.solution_values[q](first + d);
                gradient[d] = inputs.solution_gradients[q][first + d];
              }
            const Strain strain = body.discretization.geometry().strain(
              gradient, value, inputs.evaluation_points[q]);
            const Material &material = body.scene.material;
            const double    thermal =
              material.has_thermal_stress() ?
                   material.thermal_stress * inputs.solution_values[q](0) :
                   0.;
            for (unsigned int d = 0; d < n_rows<dim>; ++d)
              for (unsigned int e = 0; e < n_rows<dim>; ++e)
                computed[q](d * n_rows<dim> + e) =
                  elastic_stress(material, strain, d, e) -
                  (d == e ? thermal : 0.);
          }
      }

      void
      evaluate_scalar_field(
        const DataPostprocessorInputs::Scalar<dim> &inputs,
        std::vector<dealii::Vector<double>>        &computed) const override
      {
        for (unsigned int q = 0; q < computed.size(); ++q)
          computed[q](0) = inputs.solution_gradients[q][0];
      }

    private:
      const Body<dim> &body;

      /** Component of the axial displacement. */
      const unsigned int first;
    };



    /** DataOut whose part of a file can be had as text. */
    template <int dim>
    class Snapshot : public DataOut<dim>
    {
    public:
      using DataOut<dim>::get_patches;
      using DataOut<dim>::get_dataset_names;
      using DataOut<dim>::get_nonscalar_data_ranges;
    };



    /**
     * The stress is a tensor in space whatever the dimension of the mesh. None
     * without patches: ParaView does not read a file that starts so.
     */
    template <int dim>
    std::string
    vtu_piece(const Snapshot<dim>         &snapshot,
              const DataOutBase::VtkFlags &flags,
              const OutputUnits           &units)
    {
      if (snapshot.get_patches().empty())
        return "";
      const std::vector<std::string> names = snapshot.get_dataset_names();
      auto       ranges = snapshot.get_nonscalar_data_ranges();
      const auto stress = std::find(names.begin(), names.end(), "stress");
      if (dim > 1 && stress != names.end())
        {
          const unsigned int first = stress - names.begin();
          ranges.emplace_back(
            first,
            first + n_stresses<dim> - 1,
            "stress",
            DataComponentInterpretation::component_is_part_of_tensor);
        }
      std::ostringstream text;
      DataOutBase::write_vtu_main(
        in_units(snapshot.get_patches(), names, "fields/fields-*.vtu", units),
        names,
        ranges,
        flags,
        text);
      return text.str();
    }



    /**
     * Both fields in one vector. By blocks: DataOut takes other vectors only if
     * the owned indices are contiguous.
     */
    template <int dim>
    BlockVector
    joined(const Discretization<dim> &discretization,
           const Vector              &temperature,
           const Vector              &displacement)
    {
      BlockVector result = discretization.make_ghosted_vector();
      for (const auto &[field, values] :
           {std::pair(Field::temperature, &temperature),
            std::pair(Field::displacement, &displacement)})
        if (discretization.has_field(field))
          result.block(discretization.ghosted_block(field))
            .copy_locally_owned_data_from(*values);
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<std::string>
  snapshot_pieces(const Body<dim>             &body,
                  const State                 &state,
                  const DataOutBase::VtkFlags &flags,
                  const OutputUnits           &units)
  {
    const Discretization<dim> &discretization = body.discretization;
    const SceneFields         &fields         = body.scene.fields;
    const unsigned int         n_directions = fields.has_displacement ? dim : 0;
    std::vector<std::string>   names(fields.has_temperature, "temperature");
    names.resize(names.size() + n_directions, "displacement");
    std::vector<Interpretation> interpretation(
      fields.has_temperature, DataComponentInterpretation::component_is_scalar);
    interpretation.resize(
      names.size(), DataComponentInterpretation::component_is_part_of_vector);

    const VelocityPostprocessor<dim> velocity_postprocessor(
      discretization.first_component(Field::displacement));
    const StressPostprocessor<dim> stress_postprocessor(body);
    Vector                         viscous_displacement = state.displacement;
    viscous_displacement.add(body.scene.material.viscosity, state.velocity);

    const auto present =
      joined(discretization, state.temperature, state.displacement);
    const auto velocity =
      joined(discretization, state.temperature, state.velocity);
    const auto strain =
      joined(discretization, state.temperature, viscous_displacement);

    Snapshot<dim> snapshot;
    snapshot.attach_dof_handler(discretization.dof_handler());
    snapshot.add_data_vector(present,
                             names,
                             DataOut<dim>::type_dof_data,
                             interpretation);
    if (fields.has_displacement)
      {
        snapshot.add_data_vector(velocity, velocity_postprocessor);
        snapshot.add_data_vector(strain, stress_postprocessor);
      }

    constexpr double   max_points = 50000.;
    const unsigned int degree     = discretization.degree();
    const unsigned int n_at_once =
      std::max(1., max_points / std::pow(degree + 1, dim));
    const unsigned int n =
      discretization.dof_handler().get_triangulation().n_active_cells();
    std::vector<std::string> pieces;
    for (unsigned int begin = 0; begin < n; begin += n_at_once)
      {
        snapshot.set_cell_selection(
          [=](const typename Triangulation<dim>::cell_iterator &cell) {
            return cell->is_active() && cell->is_locally_owned() &&
                   cell->active_cell_index() >= begin &&
                   cell->active_cell_index() - begin < n_at_once;
          });
        snapshot.build_patches(discretization.mapping(), degree);
        pieces.push_back(vtu_piece(snapshot, flags, units));
      }
    return pieces;
  }



#define INSTANTIATE(dim)                             \
  template std::vector<std::string> snapshot_pieces( \
    const Body<dim> &,                               \
    const State &,                                   \
    const DataOutBase::VtkFlags &,                   \
    const OutputUnits &)

  INSTANTIATE(1);
  INSTANTIATE(2);
  INSTANTIATE(3);

#undef INSTANTIATE
} // namespace ThermoContact
