// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/output/contact_face_file.h>
#include <thermocontact/output/patch_units.h>
#include <thermocontact/space/node_laws.h>

#include <sstream>

namespace ThermoContact
{
  namespace
  {
    /** Nodes along y; the nodes are sorted by z, then by y. */
    template <int dim>
    unsigned int
    n_along_y(const std::vector<ContactNode<dim>> &nodes)
    {
      unsigned int n = 1;
      while (dim > 1 && n < nodes.size() &&
             nodes[n].position[dim > 1 ? 1 : 0] >
               nodes[n - 1].position[dim > 1 ? 1 : 0])
        ++n;
      return n;
    }



    /** A name and the values at the contact nodes. */
    using NamedValues = std::pair<std::string, std::vector<double>>;

    template <int dim>
    std::vector<NamedValues>
    values_of(const Body<dim> &body, const State &state)
    {
      std::vector<double>  temperature, in_contact, gap;
      std::vector<NodeLaw> laws;
      get_node_laws(body, state, laws, gap);
      for (unsigned int i = 0; i < gap.size(); ++i)
        gap[i] = 0. - laws[i].penetration(gap[i]);
      for (const double pressure : state.contact_pressure)
        in_contact.push_back(pressure != 0. ? 1. : 0.);
      std::vector<NamedValues> values = {{"contact_pressure",
                                          state.contact_pressure},
                                         {"gap", gap},
                                         {"in_contact", in_contact}};
      if (body.scene.fields.has_temperature)
        {
          body.contact_end().get_values(Field::temperature,
                                        state.temperature,
                                        temperature);
          values.emplace_back("temperature", temperature);
        }
      return values;
    }
  } // namespace



  template <int dim>
  std::vector<unsigned int>
  contact_face_corners(const std::vector<ContactNode<dim>> &nodes)
  {
    const unsigned int        n = n_along_y(nodes);
    std::vector<unsigned int> corners;
    for (unsigned int j = 0; j + (dim > 2 ? n : 0) < nodes.size(); j += n)
      for (unsigned int i = j; i + 1 < j + n; ++i)
        {
          corners.insert(corners.end(), {i, i + 1});
          if (dim > 2)
            corners.insert(corners.end(), {i + 1 + n, i + n});
        }
    return corners;
  }



  template <int dim>
  std::string
  contact_face_file(const Body<dim>             &body,
                    const State                 &state,
                    const DataOutBase::VtkFlags &flags,
                    const OutputUnits           &units)
  {
    const std::vector<NamedValues> values = values_of(body, state);
    if (Utilities::MPI::this_mpi_process(body.discretization.communicator()) !=
        0)
      return "";

    const auto    &nodes     = body.contact_end().nodes();
    const auto     corners   = contact_face_corners(nodes);
    constexpr auto n_corners = GeometryInfo<dim - 1>::vertices_per_cell;
    constexpr std::array<unsigned int, 4> order = {{0, 1, 3, 2}}; // not VTK's
    std::vector<DataOutBase::Patch<dim - 1, dim>> patches(corners.size() /
                                                          n_corners);
    for (unsigned int c = 0; c < patches.size(); ++c)
      {
        auto &patch          = patches[c];
        patch.patch_index    = c;
        patch.n_subdivisions = 1;
        patch.reference_cell = ReferenceCells::get_hypercube<dim - 1>();
        patch.data.reinit(values.size(), n_corners);
        for (unsigned int i = 0; i < n_corners; ++i)
          {
            const unsigned int node = corners[c * n_corners + order[i]];
            patch.vertices[i]       = nodes[node].position;
            for (unsigned int k = 0; k < values.size(); ++k)
              patch.data(k, i) = values[k].second[node];
          }
      }
    std::vector<std::string> names;
    for (const auto &[name, at_nodes] : values)
      names.push_back(name);
    const std::string     file     = "fields/contact-*.vtu";
    DataOutBase::VtkFlags in_flags = flags;
    in_flags.physical_units        = units_of_arrays(names, file, units);
    std::ostringstream text;
    DataOutBase::write_vtu(in_units(std::move(patches), names, file, units),
                           names,
                           {},
                           in_flags,
                           text);
    return text.str();
  }



  template std::vector<unsigned int>
  contact_face_corners(const std::vector<ContactNode<1>> &);
  template std::vector<unsigned int>
  contact_face_corners(const std::vector<ContactNode<2>> &);
  template std::vector<unsigned int>
  contact_face_corners(const std::vector<ContactNode<3>> &);
  template std::string
  contact_face_file(const Body<2> &,
                    const State &,
                    const DataOutBase::VtkFlags &,
                    const OutputUnits &);
  template std::string
  contact_face_file(const Body<3> &,
                    const State &,
                    const DataOutBase::VtkFlags &,
                    const OutputUnits &);
} // namespace ThermoContact
