// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/atomic_file.h>
#include <thermocontact/base/collective_errors.h>
#include <thermocontact/base/exceptions.h>
#include <thermocontact/base/parallel_file.h>
#include <thermocontact/output/contact_face_file.h>
#include <thermocontact/output/field_output.h>
#include <thermocontact/output/obstacle_file.h>
#include <thermocontact/output/output_directory.h>
#include <thermocontact/output/patch_units.h>
#include <thermocontact/output/snapshot.h>

#include <deal.II/numerics/data_postprocessor.h>

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
  } // namespace



  template <int dim>
  FieldOutput<dim>::FieldOutput(const std::string &directory,
                                const Body<dim>   &body)
    : directory(directory)
    , body(body)
    , discretization(body.discretization)
    , is_writer(
        Utilities::MPI::this_mpi_process(discretization.communicator()) == 0)
    , units(body.scene.parameters)
    , fields(directory, "fields", units.of("time"))
    , gap(contact_gap<dim>(body.scene))
  {
    if (dim > 1 && body.obstacle.is_active())
      obstacle.emplace(directory, "obstacle", units.of("time"));
    if (dim > 1 && body.law().is_active())
      contact_face.emplace(directory, "contact", units.of("time"));
    if constexpr (dim == 1)
      if (RodSnapshot::is_for(body) && !units.is_si())
        rod_snapshot.emplace(body);
  }



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
    DataOutBase::VtkFlags flags;
    flags.time  = units.of("time")(state.time);
    flags.cycle = times().size();
    flags.physical_units =
      units_of_arrays({"temperature", "displacement", "velocity", "stress"},
                      "fields/fields-*.vtu",
                      units);
    flags.print_date_and_time = false;
    flags.compression_level   = DataOutBase::VtkFlags::best_speed;

    std::string fault =
      rod_snapshot ? write_atomically(fields.next_path(),
                                      rod_snapshot->file(state, flags.cycle)) :
                     write_patches(state, flags);
    if (fault.empty())
      fault = write_others(state, flags);
    throw_everywhere<ComputationError>(fault, discretization.communicator());
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_patches(const State                 &state,
                                  const DataOutBase::VtkFlags &flags)
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

    const auto present  = joined(state.temperature, state.displacement);
    const auto velocity = joined(state.temperature, state.velocity);
    const auto strain   = joined(state.temperature, viscous_displacement);

    Snapshot<dim> data_out;
    data_out.attach_dof_handler(discretization.dof_handler());
    data_out.add_data_vector(present,
                             names,
                             DataOut<dim>::type_dof_data,
                             interpretation);
    if (body.scene.fields.has_displacement)
      {
        data_out.add_data_vector(velocity, velocity_postprocessor);
        data_out.add_data_vector(strain, stress_postprocessor);
      }

    return write_fields(data_out.vtu_pieces(discretization, flags, units),
                        flags);
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_fields(const std::vector<std::string> &pieces,
                                 const DataOutBase::VtkFlags    &flags) const
  {
    const MPI_Comm     communicator = discretization.communicator();
    std::ostringstream header, footer;
    if (is_writer)
      DataOutBase::write_vtu_header(header, flags);
    if (Utilities::MPI::this_mpi_process(communicator) + 1 ==
        Utilities::MPI::n_mpi_processes(communicator))
      DataOutBase::write_vtu_footer(footer);
    const std::string             first = header.str(), last = footer.str();
    std::vector<std::string_view> part(pieces.begin(), pieces.end());
    part.insert(part.begin(), first);
    part.push_back(last);
    return write_parallel_file_atomically(fields.next_path(),
                                          part,
                                          communicator);
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_others(const State                 &state,
                                 const DataOutBase::VtkFlags &flags)
  {
    std::string fault;
    const auto  write = [&](const std::string &path, const std::string &text) {
      if (is_writer && fault.empty())
        fault = write_atomically(path, text);
    };
    if (obstacle)
      {
        gap->set_time(state.time);
        write(obstacle->next_path(),
              obstacle_file(body.contact_end(),
                            units,
                            body.scene.contact.rear_gap,
                            gap.get()));
      }
    else if (fields.times().empty() && !body.scene.contact.has_uniform_gap())
      write(directory + "/obstacle.vtu",
            obstacle_file(body.contact_end(),
                          units,
                          body.scene.contact.rear_gap));
    if constexpr (dim > 1)
      if (contact_face)
        write(contact_face->next_path(),
              contact_face_file(body, state, flags, units));
    for (SnapshotSeries *series : all_series())
      series->add(state.time);
    return fault.empty() ? write_lists(fields.times().size() > 1) : fault;
  }



  template <int dim>
  std::string
  FieldOutput<dim>::write_lists(const bool only_due)
  {
    const auto now = std::chrono::steady_clock::now();
    if (!is_writer || (only_due && now - last_lists < std::chrono::seconds(1)))
      return "";
    last_lists = now;
    std::string fault;
    for (SnapshotSeries *series : all_series())
      if (fault.empty())
        fault = series->write_pvd();
    return fault;
  }



  template <int dim>
  std::vector<SnapshotSeries *>
  FieldOutput<dim>::all_series()
  {
    std::vector<SnapshotSeries *> all = {&fields};
    if (contact_face)
      all.push_back(&*contact_face);
    if (obstacle)
      all.push_back(&*obstacle);
    return all;
  }



  template <int dim>
  void
  FieldOutput<dim>::restore(const std::vector<double> &times)
  {
    std::string fault;
    for (SnapshotSeries *series : all_series())
      {
        series->restore(times);
        if (is_writer && fault.empty())
          fault = series->remove_later(); // it will be written again
      }
    throw_everywhere<ComputationError>(fault, discretization.communicator());
  }



  template <int dim>
  std::string
  FieldOutput<dim>::sync()
  {
    std::string fault = fields.sync();
    for (SnapshotSeries *series : all_series())
      if (series != &fields && is_writer && fault.empty())
        fault = series->sync();
    return first_fault(fault, discretization.communicator());
  }



  template class FieldOutput<1>;
  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace ThermoContact
