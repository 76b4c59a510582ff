// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_space_discretization_h
#define thermocontact_space_discretization_h

#include <thermocontact/base/types.h>
#include <thermocontact/scene/spatial_scene.h>
#include <thermocontact/space/contact_end.h>
#include <thermocontact/space/geometry.h>
#include <thermocontact/space/state.h>

#include <deal.II/base/index_set.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values_extractors.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace ThermoContact
{
  /** The value of a component of a field at a node. */
  template <int dim>
  struct NodalValue
  {
    unsigned int component;
    Point<dim>   node;
  };



  /**
   * Mesh, finite element space and constraints of the body
   * $(0,1)\times(0,\text{width})^{dim-1}$.
   *
   * One DoFHandler for the FESystem of temperature and displacement, numbered
   * by field, the temperature first. A field
   * that the scene does not have is absent from the FESystem, and its block is
   * empty. The constraints are those of rates: homogeneous, temperature and
   * displacement (its axial component, if the end slides) at the fixed end,
   * normal displacement at lateral faces that the geometry holds.
   */
  template <int dim>
  class Discretization
  {
  public:
    /** @param all the ranks, of which communicator() shares the mesh */
    Discretization(const SpatialScene &scene, const MPI_Comm all);

    const Geometry<dim> &
    geometry() const
    {
      return geometry_;
    }

    /** Of the ranks that share the mesh: of a rod, this rank alone. */
    MPI_Comm
    communicator() const
    {
      return communicator_;
    }

    const DoFHandler<dim> &
    dof_handler() const
    {
      return dof_handler_;
    }

    const FiniteElement<dim> &
    finite_element() const
    {
      return finite_element_;
    }

    const Mapping<dim> &
    mapping() const
    {
      return mapping_;
    }

    /** False if the scene does not have it; its block is empty then. */
    bool
    has_field(const Field::Block field) const
    {
      return owned_by_block_[field].size() > 0;
    }

    /** Number of components of the FESystem. */
    unsigned int
    n_components() const
    {
      return finite_element_.n_components();
    }

    /** First component of a field that the scene has. */
    unsigned int
    first_component(const Field::Block field) const
    {
      return field == Field::displacement && has_field(Field::temperature) ? 1 :
                                                                             0;
    }

    /** First degree of freedom of a field in the whole system. */
    types::global_dof_index
    first_dof(const Field::Block field) const
    {
      return field == Field::displacement ? n_temperature_dofs() : 0;
    }

    FEValuesExtractors::Scalar
    temperature_extractor() const
    {
      return FEValuesExtractors::Scalar(first_component(Field::temperature));
    }

    FEValuesExtractors::Vector
    displacement_extractor() const
    {
      return FEValuesExtractors::Vector(first_component(Field::displacement));
    }

    unsigned int
    degree() const
    {
      return finite_element_.degree;
    }

    /** Constraints of rates in the numbering of the whole system. */
    const AffineConstraints<double> &
    constraints() const
    {
      return constraints_;
    }

    /**
     * The constraints of a clamped end with a given temperature, which leave no
     * rigid motion.
     */
    AffineConstraints<double>
    clamped_constraints() const
    {
      return make_constraints(ComponentMask(n_components(), true), false, true);
    }

    /** Locally owned indices of the whole system. */
    const IndexSet &
    owned() const
    {
      return owned_;
    }

    /** Locally relevant indices of the whole system. */
    const IndexSet &
    relevant() const
    {
      return relevant_;
    }

    /** Locally owned and locally relevant indices within each block. */
    const std::vector<IndexSet> &
    owned_by_block() const
    {
      return owned_by_block_;
    }

    const std::vector<IndexSet> &
    relevant_by_block() const
    {
      return relevant_by_block_;
    }

    types::global_dof_index
    n_temperature_dofs() const
    {
      return owned_by_block_[Field::temperature].size();
    }

    types::global_dof_index
    n_displacement_dofs() const
    {
      return owned_by_block_[Field::displacement].size();
    }

    unsigned int
    n_active_cells() const
    {
      return triangulation->n_global_active_cells();
    }

    /** The cells of a row of bodies; empty: the mesh is of one body. */
    const BodyRow &
    row() const
    {
      return row_;
    }

    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    /** Section Bodies is given: terms have factors, (M10.1). */
    bool
    has_bodies() const
    {
      return row_.is_given() || profile;
    }

    /** The factors of the terms of the equations at a place of a cell. */
    EquationFactors
    in_equations(const Cell       &cell,
                 const Point<dim> &place,
                 const double      theta = 0.) const;

    /** The same of the material there, where the cell of a rod has means,
     * (M10.7). */
    EquationFactors
    of_material(const Cell       &cell,
                const Point<dim> &place,
                const double      theta = 0.) const;

    /** The material of a body in several dimensions; null: it has none. */
    const BodyProfile *
    material() const
    {
      return profile ? &*profile : nullptr;
    }

    /** x, y and z of a place, right within its cell: jumps are on faces. */
    std::array<double, 3>
    inside(const Cell &cell, const Point<dim> &place) const;

    /** Lame coefficients there, of unit P-wave modulus. */
    Elasticity
    elasticity(const Cell &cell, const Point<dim> &place) const;

    /** False: in_equations() are the same in all of the cell. */
    bool
    coefficients_vary(const Cell &cell) const;

    /** $k$ of the contact end if it is a number, else 0. */
    double
    exchange_coefficient() const
    {
      return exchange_coefficient_;
    }

    /** True for a cell that is no part of a body: between two bodies of a row,
     * or of an obstacle that has a mass. */
    bool
    is_gap(const Cell &cell) const
    {
      return row_.is_given() ? row_.cells[cell->active_cell_index()].is_gap :
                               cell->material_id() == obstacle_material;
    }

    /** Whether a node is a part of the body, not of such an obstacle. */
    bool
    is_in_body(const Point<dim> &node) const
    {
      return of_obstacle.size() == 0 || node[0] < 1.5 * geometry_.corner()[0];
    }

    /** The place or the temperature of an obstacle that has a mass, within the
     * field; invalid: there is none. */
    types::global_dof_index
    obstacle_dof(const Field::Block field) const
    {
      return obstacle_dof_[field];
    }

    /** The same in the local part of a vector, of the rank that owns it. */
    std::optional<unsigned int>
    obstacle_entry(const Field::Block field) const;

    /** Its value in a vector of the field, on all ranks. */
    double
    obstacle_value(const Field::Block field, const Vector &vector) const;

    /** The place in a vector of a field of the node at the right end of a rod.
     */
    unsigned int
    entry_of_right_end(const Field::Block field) const
    {
      return owned_by_block_[field].n_elements() - degree();
    }

    /** Inner nodes of gaps, and all of an obstacle that has a mass, become
     * zero.
     */
    void
    set_zero_in_gaps(State &state) const;

    /** The same of a vector of one field. */
    void
    set_zero_in_gaps(const Field::Block field, Vector &vector) const;

    /** Its end at the obstacle, or where the bodies of a row can meet. */
    const ContactEnd<dim> &
    contact_end() const
    {
      return *contact_end_;
    }

    /** Locally owned degrees of freedom of a field whose rate vanishes. */
    const IndexSet &
    constrained(const Field::Block field) const
    {
      return constrained_[field];
    }

    /** Their positions within the locally owned part of the block. */
    const std::vector<unsigned int> &
    constrained_entries(const Field::Block field) const
    {
      return constrained_entries_[field];
    }

    /** True for a constrained entry of the right end of a rod. */
    bool
    is_right_end(const unsigned int entry) const
    {
      return dim == 1 && entry > 0;
    }

    /** Whether the left and the right end of a rod hold a field. */
    std::array<bool, 2>
    are_ends_held(const Field::Block field) const
    {
      return {{is_held_left_[field], is_held_right_[field]}};
    }

    bool
    has_right_temperature() const
    {
      return is_held_right_[Field::temperature];
    }

    /** Largest difference of a field to @p value where it is constrained, to
     * @p at_right at the right end of a rod; collective. */
    double
    largest_constrained(const Field::Block field,
                        const Vector      &vector,
                        const double       value,
                        const double       at_right = 0.) const;

    /** Component and position of the entries of a local vector of a field. */
    const std::vector<NodalValue<dim>> &
    nodal_values(const Field::Block field) const
    {
      return nodal_values_[field];
    }

    /**
     * A vector of zeros for one field or for the whole system. Vectors of a
     * field share one partitioner: their assignment is a copy. In scenes
     * without matrices they have the ghosts that products by cells need.
     */
    Vector
    make_vector(const Field::Block field) const
    {
      return prototypes[field];
    }

    SystemVector
    make_system_vector() const
    {
      return system_prototype;
    }

    /**
     * A vector of zeros of the fields that the scene has, with the ghosts that
     * cells need: several ranks cannot exchange those of an empty block.
     */
    BlockVector
    make_ghosted_vector() const;

    /** Both fields in one such vector; collective.
     *
     * @param temperature,displacement empty: zeros */
    BlockVector
    with_ghosts(const Vector &temperature, const Vector &displacement) const;

    /**
     * A block for each field, of the layout of make_vector(). For reinit(), not
     * to be assigned: an empty block, of a field that there is not, would keep
     * the communicator of one rank, and its sums be those of the first block.
     */
    BlockVector
    make_block_vector() const;

    /** The block of a field that the scene has in a ghosted vector. */
    unsigned int
    ghosted_block(const Field::Block field) const
    {
      return has_field(Field::temperature) ? static_cast<unsigned int>(field) :
                                             0;
    }

    /** A state of zeros; Body::make_state() has the gaps of the scene. */
    State
    make_state() const;

    /**
     * Concatenates both blocks into one vector of the whole system; local copy
     * without communication.
     */
    void
    join(const Vector &temperature,
         const Vector &displacement,
         SystemVector &system) const;

    /** The reverse of join(). */
    void
    split(const SystemVector &system,
          Vector             &temperature,
          Vector             &displacement) const;

  private:
    const MPI_Comm                            communicator_;
    const Geometry<dim>                       geometry_;
    const std::unique_ptr<Triangulation<dim>> triangulation;
    const FESystem<dim>                       finite_element_;
    const MappingQ<dim>                       mapping_;
    DoFHandler<dim>                           dof_handler_;
    AffineConstraints<double>                 constraints_;
    IndexSet                                  owned_;
    IndexSet                                  relevant_;
    std::vector<IndexSet>                     owned_by_block_;
    std::vector<IndexSet>                     relevant_by_block_;
    std::vector<Vector>                       prototypes;
    SystemVector                              system_prototype;
    std::unique_ptr<const ContactEnd<dim>>    contact_end_;

    std::vector<IndexSet>                  constrained_;
    std::vector<std::vector<unsigned int>> constrained_entries_;

    std::array<std::vector<NodalValue<dim>>, 2> nodal_values_;

    const std::array<bool, 2> is_held_left_, is_held_right_; ///< of a rod

    const BodyRow                    row_;
    const std::optional<BodyProfile> profile;
    const Elasticity                 elasticity_; ///< of a body without one

    /** Of the cell of an obstacle that has a mass, and its faces; those of
     * boxes are small numbers. */
    static constexpr types::material_id obstacle_material = 100;
    static constexpr types::boundary_id obstacle_boundary = 100;

    /** Of the fields. */
    std::array<types::global_dof_index, 2> obstacle_dof_{
      {numbers::invalid_dof_index, numbers::invalid_dof_index}};

    IndexSet     of_obstacle; ///< all indices of its cell; empty: there is none
    const double exchange_coefficient_;

    void
    make_grid(const SpatialScene &scene);

    /** The nodes of an obstacle that has a mass, one of which is its place. */
    void
    find_obstacle();

    void
    distribute_dofs(const SceneFields &fields);

    /** Gives vectors of the fields what products by cells need. */
    void
    add_ghosts_of_cells();

    /** The components whose rates vanish at the end $x=0$. */
    ComponentMask
    held_components(const SpatialScene &scene) const;

    /** @param held components of the end $x=0$ */
    AffineConstraints<double>
    make_constraints(const ComponentMask &held,
                     const bool           has_pins,
                     const bool           holds_obstacle) const;

    /** Holds across the axis what is left of a body that nothing holds. */
    void
    add_pins(AffineConstraints<double> &constraints) const;

    /** Finds the constrained degrees of freedom of each field. */
    void
    collect_constrained();

    void
    collect_nodal_values();
  };
} // namespace ThermoContact

#endif
