// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/atomic_file.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/text.h>
#include <thermocontact/output/field_output.h>
#include <thermocontact/output/obstacle_file.h>
#include <thermocontact/output/output_directory.h>

#include <deal.II/base/data_out_base.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

namespace ThermoContact
{
  namespace
  {
    using Interpretation =
      DataComponentInterpretation::DataComponentInterpretation;

    /** Velocity alone, from a vector of both fields. */
    template <int dim>
    class VelocityPostprocessor : public DataPostprocessor<dim>
    {
    public:
      /** @param first component of the displacement */
      explicit VelocityPostprocessor(const unsigned int first)
        : first(first)
      {}

      std::vector<std::string>
      get_names() const override
      {
        return std::vector<std::string>(dim, "velocity");
      }

      std::vector<Interpretation>
      get_data_component_interpretation() const override
      {
        return std::vector<Interpretation>(
          dim, DataComponentInterpretation::component_is_part_of_vector);
      }

      UpdateFlags
      get_needed_update_flags() const override
      {
        return update_values;
      }

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



    /** Rows of the stress in space; that of a rod is a scalar. */
    template <int dim>
    constexpr unsigned int n_rows = dim == 1 ? 1 : 3;

    template <int dim>
    constexpr unsigned int n_stresses = n_rows<dim> *n_rows<dim>;



    /**
     * Stress from a vector of $(\theta, u+\zeta v)$: scalars, which Snapshot
     * makes a tensor.
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



    /**
     * DataOut whose part of a file can be had as text, and in which the stress
     * is a tensor in space whatever the dimension of the mesh.
     */
    template <int dim>
    class Snapshot : public DataOut<dim>
    {
    public:
      /**
       * This rank's part of a VTU file, without header and footer. None if the
       * rank has no cells: ParaView does not read a file that starts so.
       */
      std::string
      vtu_piece(const DataOutBase::VtkFlags &flags) const
      {
        if (this->get_patches().empty())
          return "";
        const std::vector<std::string> names = this->get_dataset_names();
        auto       ranges = this->get_nonscalar_data_ranges();
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
          this->get_patches(), names, ranges, flags, text);
        return text.str();
      }
    };



    /** File of snapshot @p i, from the output directory. */
    std::string
    snapshot_name(const unsigned int i)
    {
      return "fields/fields-" + align_right(text(i), 5, '0') + ".vtu";
    }
  } // namespace



  template <int dim>
  FieldOutput<dim>::FieldOutput(const std::string &directory,
                                const Body<dim>   &body)
    : directory(directory)
    , body(body)
    , discretization(body.discretization)
  {}



  template <int dim>
  BlockVector
  FieldOutput<dim>::joined(const Vector &temperature,
                           const Vector &displacement) const
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



  template <int dim>
  void
  FieldOutput<dim>::write(const State &state)
  {
    std::vector<std::string>    names;
    std::vector<Interpretation> interpretation;
    if (body.scene.fields.has_temperature)
      {
        names.emplace_back("temperature");
        interpretation.push_back(
          DataComponentInterpretation::component_is_scalar);
      }
    if (body.scene.fields.has_displacement)
      for (unsigned int d = 0; d < dim; ++d)
        {
          names.emplace_back("displacement");
          interpretation.push_back(
            DataComponentInterpretation::component_is_part_of_vector);
        }

    const VelocityPostprocessor<dim> velocity_postprocessor(
      discretization.first_component(Field::displacement));
    const StressPostprocessor<dim> stress_postprocessor(body);
    Vector                         viscous_displacement = state.displacement;
    viscous_displacement.add(body.scene.material.viscosity, state.velocity);

    const auto fields   = joined(state.temperature, state.displacement);
    const auto velocity = joined(state.temperature, state.velocity);
    const auto strain   = joined(state.temperature, viscous_displacement);

    Snapshot<dim> data_out;
    data_out.attach_dof_handler(discretization.dof_handler());
    data_out.add_data_vector(fields,
                             names,
                             DataOut<dim>::type_dof_data,
                             interpretation);
    if (body.scene.fields.has_displacement)
      {
        data_out.add_data_vector(velocity, velocity_postprocessor);
        data_out.add_data_vector(strain, stress_postprocessor);
      }

    DataOutBase::VtkFlags flags;
    flags.time                = state.time;
    flags.cycle               = times_.size();
    flags.print_date_and_time = false;
    flags.compression_level   = DataOutBase::VtkFlags::best_speed;
    data_out.build_patches(discretization.mapping(), discretization.degree());

    const std::string fault =
      write_files(state.time,
                  Utilities::MPI::gather(discretization.communicator(),
                                         data_out.vtu_piece(flags)),
                  flags);
    throw_everywhere<ComputationError>(fault, discretization.communicator());
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_files(const double                    time,
                                const std::vector<std::string> &pieces,
                                const DataOutBase::VtkFlags    &flags)
  {
    const std::string name = snapshot_name(times_.size());
    times_.push_back(time);
    if (Utilities::MPI::this_mpi_process(discretization.communicator()) != 0)
      return "";

    std::ostringstream text;
    DataOutBase::write_vtu_header(text, flags);
    for (const std::string &piece : pieces)
      text << piece;
    DataOutBase::write_vtu_footer(text);
    std::string fault = write_atomically(directory + "/" + name, text.str());
    if (fault.empty() && times_.size() == 1 &&
        !body.scene.contact.has_uniform_gap())
      fault = write_atomically(directory + "/obstacle.vtu",
                               obstacle_file(body.contact_end()));
    return fault.empty() ? write_pvd(directory + "/fields.pvd") : fault;
  }



  template <int dim>
  void
  FieldOutput<dim>::restore(const std::vector<double> &times)
  {
    times_   = times;
    n_synced = times.size(); // before the checkpoint was written
    std::string fault;
    if (Utilities::MPI::this_mpi_process(discretization.communicator()) == 0)
      {
        // what was written after the checkpoint will be written again
        unsigned int i = times.size();
        while (std::remove((directory + "/" + snapshot_name(i)).c_str()) == 0)
          ++i;
        const std::string pvd = directory + "/fields.pvd";
        if (times.empty())
          std::remove(pvd.c_str());
        else
          fault = write_pvd(pvd);
      }
    throw_everywhere<ComputationError>(fault, discretization.communicator());
  }



  template <int dim>
  std::string
  FieldOutput<dim>::sync()
  {
    if (n_synced == times_.size())
      return "";
    std::string fault;
    for (; n_synced < times_.size() && fault.empty(); ++n_synced)
      fault = sync_file(directory + "/" + snapshot_name(n_synced));
    sync_directory(directory + "/fields");
    return fault;
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_pvd(const std::string &path) const
  {
    std::ostringstream text;
    text << "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"Collection\" version=\"0.1\">\n"
            "  <Collection>\n";
    for (unsigned int i = 0; i < times_.size(); ++i)
      text << "    <DataSet timestep=\"" << significant(times_[i], all_digits)
           << "\" group=\"\" part=\"0\" file=\"" << snapshot_name(i)
           << "\"/>\n";
    text << "  </Collection>\n</VTKFile>\n";

    return write_atomically(path, text.str());
  }



  template class FieldOutput<1>;
  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace ThermoContact
