// SPDX-License-Identifier: LGPL-2.1-or-later

#include "field_output.h"

#include <deal.II/base/data_out_base.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/data_postprocessor.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "exceptions.h"
#include "output_directory.h"

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
      std::vector<std::string>
      get_names() const override
      {
        return std::vector<std::string>(dim, "velocity");
      }

      std::vector<Interpretation>
      get_data_component_interpretation() const override
      {
        return std::vector<Interpretation>(
          dim,
          dim == 1 ? DataComponentInterpretation::component_is_scalar :
                     DataComponentInterpretation::component_is_part_of_vector);
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
            computed[q](d) = inputs.solution_values[q](1 + d);
      }
    };



    /** Stress from a vector of $(\theta, u+\zeta v)$. */
    template <int dim>
    class StressPostprocessor : public DataPostprocessor<dim>
    {
    public:
      explicit StressPostprocessor(const ModelParameters &model)
        : lambda(model.poisson_ratio / (1. - model.poisson_ratio))
        , mu(0.5 * (1. - 2. * model.poisson_ratio) / (1. - model.poisson_ratio))
        , coupling(model.coupling)
      {}

      std::vector<std::string>
      get_names() const override
      {
        return std::vector<std::string>(dim * dim, "stress");
      }

      std::vector<Interpretation>
      get_data_component_interpretation() const override
      {
        return std::vector<Interpretation>(
          dim * dim,
          dim == 1 ? DataComponentInterpretation::component_is_scalar :
                     DataComponentInterpretation::component_is_part_of_tensor);
      }

      UpdateFlags
      get_needed_update_flags() const override
      {
        return update_values | update_gradients;
      }

      void
      evaluate_vector_field(
        const DataPostprocessorInputs::Vector<dim> &inputs,
        std::vector<dealii::Vector<double>>        &computed) const override
      {
        for (unsigned int q = 0; q < computed.size(); ++q)
          {
            const auto &gradients  = inputs.solution_gradients[q];
            double      divergence = 0.;
            for (unsigned int d = 0; d < dim; ++d)
              divergence += gradients[1 + d][d];
            for (unsigned int d = 0; d < dim; ++d)
              for (unsigned int e = 0; e < dim; ++e)
                computed[q](d * dim + e) =
                  mu * (gradients[1 + d][e] + gradients[1 + e][d]) +
                  (d == e ? lambda * divergence -
                              coupling * inputs.solution_values[q](0) :
                            0.);
          }
      }

    private:
      const double lambda;
      const double mu;
      const double coupling;
    };



    std::string
    describe_fault(const std::string &path)
    {
      return path +
             ": cannot be written\n  remedy:  check free space and rights, or "
             "set Output/Fields interval = 0";
    }
  } // namespace



  template <int dim>
  FieldOutput<dim>::FieldOutput(const std::string         &directory,
                                const Parameters          &parameters,
                                const Discretization<dim> &discretization)
    : directory(directory)
    , model(parameters.model)
    , discretization(discretization)
  {}



  template <int dim>
  Vector
  FieldOutput<dim>::ghosted(const Vector &temperature,
                            const Vector &displacement) const
  {
    Vector system = discretization.make_system_vector();
    discretization.join(temperature, displacement, system);
    Vector result(discretization.owned(),
                  discretization.relevant(),
                  discretization.communicator());
    result = system;
    return result;
  }



  template <int dim>
  void
  FieldOutput<dim>::write(const State &state)
  {
    const VelocityPostprocessor<dim> velocity_postprocessor;
    const StressPostprocessor<dim>   stress_postprocessor(model);
    Vector                           viscous_displacement = state.displacement;
    viscous_displacement.add(model.viscosity, state.velocity);

    const Vector fields   = ghosted(state.temperature, state.displacement);
    const Vector velocity = ghosted(state.temperature, state.velocity);
    const Vector strain   = ghosted(state.temperature, viscous_displacement);

    std::vector<std::string> names(1 + dim, "displacement");
    names[0] = "temperature";
    std::vector<Interpretation> interpretation(
      1 + dim,
      dim == 1 ? DataComponentInterpretation::component_is_scalar :
                 DataComponentInterpretation::component_is_part_of_vector);
    interpretation[0] = DataComponentInterpretation::component_is_scalar;

    DataOut<dim> data_out;
    data_out.attach_dof_handler(discretization.dof_handler());
    data_out.add_data_vector(fields,
                             names,
                             DataOut<dim>::type_dof_data,
                             interpretation);
    data_out.add_data_vector(velocity, velocity_postprocessor);
    data_out.add_data_vector(strain, stress_postprocessor);

    DataOutBase::VtkFlags flags;
    flags.time                = state.time;
    flags.cycle               = times_and_names.size();
    flags.print_date_and_time = false;
    flags.compression_level   = DataOutBase::VtkFlags::best_speed;
    data_out.set_flags(flags);
    data_out.build_patches(discretization.mapping(), discretization.degree());

    std::ostringstream name;
    name << "fields/fields-" << std::setw(5) << std::setfill('0')
         << times_and_names.size() << ".vtu";
    times_and_names.emplace_back(state.time, name.str());
    write_vtu(data_out, directory + "/" + name.str());
    write_pvd(directory + "/fields.pvd");
  }



  template <int dim>
  void
  FieldOutput<dim>::write_vtu(const DataOut<dim> &data_out,
                              const std::string  &path) const
  {
    const MPI_Comm communicator = discretization.communicator();
    if (Utilities::MPI::n_mpi_processes(communicator) > 1)
      data_out.write_vtu_in_parallel(path, communicator);
    else
      {
        std::ofstream file(path);
        data_out.write_vtu(file);
        file.close();
        throw_everywhere<ComputationError>(file ? "" : describe_fault(path),
                                           communicator);
      }
  }



  template <int dim>
  void
  FieldOutput<dim>::write_pvd(const std::string &path) const
  {
    const MPI_Comm communicator = discretization.communicator();
    std::string    fault;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::ofstream file(path + ".part");
        DataOutBase::write_pvd_record(file, times_and_names);
        file.close();
        std::error_code error;
        if (file)
          std::filesystem::rename(path + ".part", path, error);
        if (!file || error)
          fault = describe_fault(path);
      }
    throw_everywhere<ComputationError>(fault, communicator);
  }



  template class FieldOutput<1>;
  template class FieldOutput<2>;
  template class FieldOutput<3>;
} // namespace ThermoContact
