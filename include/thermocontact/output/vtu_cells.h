// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_output_vtu_cells_h
#define thermocontact_output_vtu_cells_h

#include <thermocontact/output/output_units.h>

#include <deal.II/base/data_out_base.h>

#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace ThermoContact
{
  /**
   * Cells of a VTU file, lines or quadrilaterals or hexahedra in space, with
   * arrays in the units of the scene.
   */
  template <int dim, int spacedim = dim>
  class VtuCells
  {
  public:
    using Patch = dealii::DataOutBase::Patch<dim, spacedim>;

    /**
     * @param file whose table on the output_page has the arrays
     * @param names of the components of arrays, the same for those of one
     */
    VtuCells(const std::string              &file,
             const std::vector<std::string> &names,
             const OutputUnits              &units)
      : names(names)
    {
      for (const std::string &name : names)
        {
          conversions.push_back(units.of(file, name));
          if (!conversions.back().unit.empty())
            flags.physical_units[name] = conversions.back().unit;
        }
      flags.compression_level = decltype(flags.compression_level)::best_speed;
    }

    /** Components @p first to @p last are a vector, or a tensor in space. */
    void
    join(const unsigned int first, const unsigned int last)
    {
      using namespace dealii::DataComponentInterpretation;
      ranges.emplace_back(first,
                          last,
                          names[first],
                          last - first < 3 ? component_is_part_of_vector :
                                             component_is_part_of_tensor);
    }

    /**
     * Adds a cell.
     *
     * @param n_parts along each direction
     * @param vertex of a number, the place of a corner as the file has it
     * @param value of component and point, x fastest, nondimensional
     */
    template <typename Vertex, typename Value>
    void
    add(const unsigned int n_parts, const Vertex &vertex, const Value &value)
    {
      patches.emplace_back();
      Patch &patch         = patches.back();
      patch.patch_index    = patches.size() - 1;
      patch.n_subdivisions = n_parts;
      patch.reference_cell =
        dealii::ReferenceCells::template get_hypercube<dim>();
      for (const unsigned int i : dealii::GeometryInfo<dim>::vertex_indices())
        patch.vertices[i] = vertex(i);
      patch.data.reinit(names.size(), dealii::Utilities::pow(n_parts + 1, dim));
      for (unsigned int row = 0; row < patch.data.n_rows(); ++row)
        for (unsigned int i = 0; i < patch.data.n_cols(); ++i)
          patch.data(row, i) = conversions[row](value(row, i));
    }

    const std::vector<Patch> &
    cells() const
    {
      return patches;
    }

    /** The cells as a whole file; then there are none any more. */
    std::string
    file()
    {
      return head() + take_piece() + foot();
    }

    /** The head of a file, before its pieces. */
    static std::string
    head()
    {
      dealii::DataOutBase::VtkFlags flags;
      flags.print_date_and_time = false;
      std::ostringstream text;
      dealii::DataOutBase::write_vtu_header(text, flags);
      return text.str();
    }

    /** The cells as a piece of a file; then there are none any more. */
    std::string
    take_piece()
    {
      std::ostringstream text;
      dealii::DataOutBase::write_vtu_main(
        std::exchange(patches, {}), names, ranges, flags, text);
      return text.str();
    }

    /** The end of a file, behind its pieces. */
    static std::string
    foot()
    {
      std::ostringstream text;
      dealii::DataOutBase::write_vtu_footer(text);
      return text.str();
    }

    dealii::DataOutBase::VtkFlags flags;

  private:
    using Range = std::tuple<
      unsigned int,
      unsigned int,
      std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>;

    const std::vector<std::string> names;
    Conversions                    conversions;
    std::vector<Range>             ranges;
    std::vector<Patch>             patches;
  };
} // namespace ThermoContact

#endif
