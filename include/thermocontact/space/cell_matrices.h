// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_cell_matrices_h
#define thermocontact_space_cell_matrices_h

#include <thermocontact/base/types.h>
#include <thermocontact/scene/spatial_scene.h>
#include <thermocontact/space/discretization.h>

#include <deal.II/fe/fe_values.h>

#include <functional>
#include <vector>

namespace ThermoContact
{
  /** A matrix between some degrees of freedom of one component in a cell. */
  struct CellMatrix
  {
    std::vector<std::size_t> dofs; ///< in the numbering of the finite element
    FullMatrix<double>       matrix;
  };



  /** A basis function of a cell at a point, for products. */
  template <int dim>
  struct CellBasis
  {
    double         theta = 0.;
    Tensor<1, dim> grad_theta;
    Strain         strain;
  };

  /** All basis functions of a cell at a point; absent fields have none. */
  template <int dim>
  void
  evaluate_basis(const Discretization<dim>   &discretization,
                 const FEValues<dim>         &fe_values,
                 const unsigned int           q,
                 std::vector<CellBasis<dim>> &basis);



  /**
   * True if the integrals over this cell are those over the one before: in a
   * body, whose products are many, not in a rod, which joins equal cells.
   */
  template <int dim>
  bool
  has_last_integrals(const Discretization<dim> &discretization,
                     const FEValues<dim>       &fe_values)
  {
    return dim > 1 && discretization.geometry().has_uniform_weight() &&
           fe_values.get_cell_similarity() ==
             dealii::CellSimilarity::translation;
  }



  template <int dim>
  using CoefficientAt = std::function<double(const Point<dim> &)>;



  /** $\int c\,\varphi_i\varphi_j$ by the points of @p values. */
  template <int dim>
  CellMatrix
  mass_between(const Discretization<dim>      &discretization,
               const std::vector<std::size_t> &dofs,
               const FEValuesBase<dim>        &values,
               const CoefficientAt<dim>       &coefficient);



  /**
   * Where heat exchange with a constant coefficient acts: at the contact end
   * with $k$, (M1.3), at the end $x=0$ with $k_A$ where it has no given
   * temperature, and with the surroundings, doc/model.md (M5.5), (D1.5):
   * in all cells of a rod, whose sides are not on the mesh, with $m$, of a row
   * with $mA$, (M10.1), and on
   * the lateral faces of a body, those at its axis of symmetry excepted, with
   * $m|A|/|\partial A|$, whose cross-section has one temperature then.
   */
  template <int dim>
  class HeatExchangeFaces
  {
  public:
    /** @param discretization borrowed */
    HeatExchangeFaces(const SpatialScene        &scene,
                      const Discretization<dim> &discretization);

    using Visit =
      std::function<void(const CellMatrix &exchange, const bool is_lateral)>;

    /** Calls @p visit with $kB$ or $L$ of each place of a cell. */
    void
    visit(const typename DoFHandler<dim>::active_cell_iterator &cell,
          const Visit                                          &visit);

  private:
    const Discretization<dim> &discretization;
    const double               left_coefficient;
    const double               end_coefficient;
    const double               lateral_coefficient;
    FEValues<dim>              cell_values;
    FEFaceValues<dim>          face_values;

    /** $k$, $k_A$, $m|A|/|\partial A|$ or 0. */
    double
    coefficient(const typename DoFHandler<dim>::face_iterator &face) const;
  };
} // namespace ThermoContact

#endif
