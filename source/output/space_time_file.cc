// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/atomic_file.h>
#include <thermocontact/output/patch_units.h>
#include <thermocontact/output/space_time_file.h>

#include <deal.II/base/data_out_base.h>

#include <filesystem>
#include <fstream>

namespace ThermoContact
{
  namespace
  {
    using namespace dealii;

    /** Quadrilaterals of a piece of the file, which is held in memory. */
    constexpr unsigned int patches_per_piece = 50000;



    /** False at the end of the file. */
    bool
    read(std::istream &file, std::vector<double> &numbers)
    {
      file.read(reinterpret_cast<char *>(numbers.data()),
                numbers.size() * sizeof(double));
      return file.good();
    }



    /** That of SpaceTimeLayout::head(); @p file is not good if there is none. */
    SpaceTimeLayout
    read_layout(std::istream &file)
    {
      SpaceTimeLayout     layout;
      std::vector<double> numbers(4);
      if (!read(file, numbers))
        return layout;
      layout.places_per_cell  = numbers[1];
      layout.has_temperature  = numbers[2] != 0.;
      layout.has_displacement = numbers[3] != 0.;
      layout.x.resize(numbers[0]);
      read(file, layout.x);
      return layout;
    }



    /** Writes quadrilaterals into a VTU file, piece by piece. */
    class PieceWriter
    {
    public:
      PieceWriter(const SpaceTimeLayout &layout,
                  const OutputUnits     &units,
                  std::ostream          &file)
        : layout(layout)
        , names(layout.field_names())
        , position(units.of("position"))
        , time(units.of("time"))
        , file(file)
      {
        for (const std::string &name : names)
          conversions.push_back(units.of("space-time.vtu", name));
        flags.physical_units = units_of_arrays(names, "space-time.vtu", units);
        flags.print_date_and_time = false;
        flags.compression_level   = DataOutBase::VtkFlags::best_speed;
      }

      /** Adds what lies between two columns. */
      void
      add_slab(const std::vector<double> &lower,
               const std::vector<double> &upper)
      {
        const unsigned int n = layout.x.size();
        for (unsigned int place = 0; place + 1 < n; ++place)
          if ((place + 1) % layout.places_per_cell != 0)
            {
              DataOutBase::Patch<2, 2> patch;
              patch.patch_index    = patches.size();
              patch.n_subdivisions = 1;
              patch.reference_cell = ReferenceCells::Quadrilateral;
              patch.data.reinit(names.size(), 4);
              for (unsigned int corner = 0; corner < 4; ++corner)
                {
                  const auto        &column = corner < 2 ? lower : upper;
                  const unsigned int i      = place + corner % 2;
                  patch.vertices[corner] =
                    Point<2>(position(layout.x[i]), time(column[0]));
                  for (unsigned int field = 0; field < names.size(); ++field)
                    patch.data(field, corner) =
                      conversions[field](column[1 + field * n + i]);
                }
              patches.push_back(patch);
            }
        if (patches.size() >= patches_per_piece)
          write_piece();
      }

      void
      finish()
      {
        if (!patches.empty())
          write_piece();
        if (has_pieces)
          DataOutBase::write_vtu_footer(file);
      }

      /** Whether the file has any content. */
      bool has_pieces = false;

    private:
      const SpaceTimeLayout                &layout;
      const std::vector<std::string>        names;
      const Conversion                      position;
      const Conversion                      time;
      Conversions                           conversions; ///< of the fields
      std::ostream                         &file;
      DataOutBase::VtkFlags                 flags;
      std::vector<DataOutBase::Patch<2, 2>> patches;

      void
      write_piece()
      {
        if (!has_pieces)
          DataOutBase::write_vtu_header(file, flags);
        has_pieces = true;
        DataOutBase::write_vtu_main(patches, names, {}, flags, file);
        patches.clear();
      }
    };
  } // namespace



  std::vector<std::string>
  SpaceTimeLayout::field_names() const
  {
    std::vector<std::string> names;
    if (has_temperature)
      names.emplace_back("temperature");
    if (has_displacement)
      names.insert(names.end(), {"displacement", "velocity", "stress"});
    return names;
  }



  std::vector<double>
  SpaceTimeLayout::head() const
  {
    std::vector<double> numbers = {static_cast<double>(x.size()),
                                   static_cast<double>(places_per_cell),
                                   has_temperature ? 1. : 0.,
                                   has_displacement ? 1. : 0.};
    numbers.insert(numbers.end(), x.begin(), x.end());
    return numbers;
  }



  std::string
  write_space_time_vtu(const std::string &columns_path,
                       const std::string &vtu_path,
                       const OutputUnits &units)
  {
    namespace fs = std::filesystem;
    std::ifstream         columns(columns_path, std::ios::binary);
    const SpaceTimeLayout layout = read_layout(columns);
    if (!columns)
      return columns_path + ": cannot be read";

    const std::string part_path = vtu_path + part_suffix;
    std::ofstream     file(part_path);
    PieceWriter       writer(layout, units, file);
    try
      {
        std::vector<double> lower(1 + layout.x.size() *
                                        layout.field_names().size());
        std::vector<double> upper(lower.size());
        for (read(columns, lower); read(columns, upper); lower.swap(upper))
          if (static_cast<float>(lower[0]) < static_cast<float>(upper[0]))
            writer.add_slab(lower, upper);
        writer.finish();
      }
    catch (const dealii::ExceptionBase &) // of a file that is bad
      {
        file.setstate(std::ios::badbit);
      }
    file.close();

    std::error_code error;
    if (file && writer.has_pieces)
      fs::rename(part_path, vtu_path, error);
    if (file && writer.has_pieces && !error)
      return "";
    const bool is_bad = !file || error;
    fs::remove(part_path, error);
    return is_bad ? vtu_path +
                      ": cannot be written\n  remedy:  check free "
                      "space and rights; the data are in " +
                      columns_path :
                    "";
  }
} // namespace ThermoContact
