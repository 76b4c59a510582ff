// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/space/cell_matrices.h>
#include <thermocontact/space/field_matrices.h>
#include <thermocontact/space/massless_contact.h>

#include <deal.II/fe/fe_values.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>

namespace ThermoContact
{
  std::array<Field::Block, 2>
  fields_of(const FieldMatrix::Kind kind)
  {
    switch (kind)
      {
        case FieldMatrix::momentum_mass:
        case FieldMatrix::stiffness:
        case FieldMatrix::viscous_stiffness:
          return {{Field::displacement, Field::displacement}};
        case FieldMatrix::divergence:
          return {{Field::temperature, Field::displacement}};
        case FieldMatrix::thermal_stress:
          return {{Field::displacement, Field::temperature}};
        default:
          return {{Field::temperature, Field::temperature}};
      }
  }



  namespace
  {
    /** Weights of products at a point of a cell. */
    struct ProductWeights
    {
      double     gradients, strains, coupling;
      Elasticity elasticity;
    };

    template <int dim>
    using WeightsAt = std::function<ProductWeights(const Point<dim> &)>;



    /** Integrals of products of the basis functions of a cell. */
    template <int dim>
    void
    integrate_products(const Material              &material,
                       const Discretization<dim>   &discretization,
                       const FEValues<dim>         &fe_values,
                       const WeightsAt<dim>        &weights_at,
                       std::vector<CellBasis<dim>> &basis,
                       FullMatrix<double>          &stiffness,
                       FullMatrix<double>          &coupling)
    {
      stiffness = 0.;
      coupling  = 0.;
      for (const unsigned int q : fe_values.quadrature_point_indices())
        {
          evaluate_basis(discretization, fe_values, q, basis);
          const double weight = discretization.geometry().weight(fe_values, q);
          const ProductWeights at =
            weights_at ? weights_at(fe_values.quadrature_point(q)) :
                         ProductWeights{1., 1., 1., material.elasticity()};
          for (unsigned int i = 0; i < basis.size(); ++i)
            for (unsigned int j = 0; j < basis.size(); ++j)
              {
                const CellBasis<dim> &f = basis[i], &g = basis[j];
                stiffness(i, j) +=
                  (at.gradients * (f.grad_theta * g.grad_theta) +
                   at.strains *
                     elastic_product(at.elasticity, f.strain, g.strain)) *
                  weight;
                coupling(i, j) +=
                  at.coupling *
                  (f.theta * g.strain.trace + f.strain.trace * g.theta) *
                  weight;
              }
        }
    }
  } // namespace



  template <int dim>
  struct FieldMatrices<dim>::Integrals
  {
    Integrals(const SpatialScene        &scene,
              const Discretization<dim> &discretization)
      : n(discretization.finite_element().dofs_per_cell)
      , mass_values(discretization.mapping(),
                    discretization.finite_element(),
                    mass_quadrature<dim>(discretization.degree(),
                                         scene.has_lumped_mass),
                    flags)
      , axial_values(discretization.mapping(),
                     discretization.finite_element(),
                     scene.has_midpoint_mass ?
                       QMidpoint<dim>() :
                       massless_quadrature<dim>(discretization.degree(),
                                                scene.has_lumped_mass),
                     flags)
      , values(discretization.mapping(),
               discretization.finite_element(),
               QGauss<dim>(discretization.degree() + 1),
               flags | update_gradients)
      , mass(n, n)
      , stiffness(n, n)
      , coupling(n, n)
      , viscous(n, n)
      , extended(n, n)
      , scratch(n, n)
      , basis(n)
      , faces(scene, discretization)
    {
      if (scene.has_elastic_contact_nodes)
        extension = extension_to_contact_nodes(discretization);
    }

    const unsigned int n;
    const UpdateFlags  flags =
      update_values | update_quadrature_points | update_JxW_values;
    FEValues<dim>      mass_values, axial_values, values;
    FullMatrix<double> mass, stiffness, coupling, viscous, extended, scratch;
    std::vector<CellBasis<dim>> basis;
    FullMatrix<double>          extension; ///< to contact nodes; may be empty
    HeatExchangeFaces<dim>      faces;
    bool                        had_axial_rule = false;
  };



  template <int dim>
  FieldMatrices<dim>::FieldMatrices(const SpatialScene        &scene,
                                    const Discretization<dim> &discretization)
    : scene(scene)
    , discretization(discretization)
    , integrals(std::make_unique<Integrals>(scene, discretization))
  {
    const FiniteElement<dim> &fe = discretization.finite_element();
    for (unsigned int i = 0; i < fe.dofs_per_cell; ++i)
      places[scene.fields.has_temperature &&
                 fe.system_to_component_index(i).first == 0 ?
               Field::temperature :
               Field::displacement]
        .push_back(i);
    const auto include = [this](const bool                        is_there,
                                const std::initializer_list<Kind> kinds) {
      for (const Kind kind : kinds)
        has_[kind] = is_there;
    };
    include(scene.fields.has_temperature, {heat_mass, conduction});
    include(scene.fields.has_displacement, {momentum_mass, stiffness});
    include(scene.material.has_thermal_stress(), {divergence, thermal_stress});
    include(scene.has_elastic_contact_nodes || scene.left.is_any() ||
              scene.right.is_any() || discretization.has_bodies(),
            {viscous_stiffness});
    include(scene.lateral_exchange > 0., {lateral_exchange});
    if constexpr (dim == 1)
      make_rod();
    else
      assemble();
    integrals.reset();
  }



  template <int dim>
  FieldMatrices<dim>::FieldMatrices(const FieldMatrices &other)
    : scene(other.scene)
    , discretization(other.discretization)
    , has_(other.has_)
    , places(other.places)
  {
    for (unsigned int kind = 0; kind < n_matrices; ++kind)
      if (other.matrices[kind].m() > 0)
        matrices[kind].copy_from(other.matrices[kind]);
  }



  template <int dim>
  std::unique_ptr<const FieldMatrices<dim>>
  FieldMatrices<dim>::with(
    const std::function<void(const AddPart &)> &add_parts) const
  {
    std::unique_ptr<FieldMatrices> result(new FieldMatrices(*this));
    add_parts([&result](const Kind                kind,
                        const Cell               &cell,
                        const FullMatrix<double> &part) {
      result->add(kind, cell, part);
    });
    result->compress();
    return result;
  }



  template <int dim>
  FieldMatrices<dim>::~FieldMatrices() = default;



  template <int dim>
  void
  FieldMatrices<dim>::assemble()
  {
    for (unsigned int kind = 0; kind < n_matrices; ++kind)
      if (has_[kind])
        setup(static_cast<Kind>(kind));
    for (const auto add_part : {&FieldMatrices::add_mass,
                                &FieldMatrices::add_stiffness,
                                &FieldMatrices::add_heat_exchange})
      for (const auto &cell :
           discretization.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned() && !discretization.is_gap(cell))
          (this->*add_part)(cell);
    add_obstacle();
    compress();
  }



  template <int dim>
  void
  FieldMatrices<dim>::compress()
  {
    for (SparseMatrix &matrix : matrices)
      if (matrix.m() > 0)
        matrix.compress(VectorOperation::add);
  }



  template <int dim>
  void
  FieldMatrices<dim>::add_obstacle()
  {
    const double area = discretization.geometry().cross_section();
    if (discretization.obstacle_entry(Field::temperature))
      {
        const auto at = discretization.obstacle_dof(Field::temperature);
        matrices[heat_mass].add(at,
                                at,
                                area * *scene.obstacle_mass->heat_capacity);
      }
    if (!discretization.obstacle_entry(Field::displacement))
      return;
    const auto at = discretization.obstacle_dof(Field::displacement);
    matrices[momentum_mass].add(
      at, at, area * scene.obstacle_mass->mass / scene.material.inertia);
    matrices[stiffness].add(at, at, area * scene.obstacle_mass->spring);
    if (scene.obstacle_mass->dashpot > 0.)
      matrices[viscous_stiffness].add(at,
                                      at,
                                      area * scene.obstacle_mass->dashpot /
                                        scene.material.viscous_factor());
  }



  template <int dim>
  void
  FieldMatrices<dim>::make_rod()
  {
    const RodLayout    layout{discretization.n_active_cells(),
                           discretization.degree()};
    const unsigned int n = layout.nodes_per_cell();
    // The sizes of equal cells differ by the rounding of their vertices.
    const double rounding =
      4. * std::numeric_limits<double>::epsilon() * layout.n_cells;
    std::vector<bool> carries(layout.n_cells, false);
    carries.front() = scene.left.is_any();
    if (scene.right.is_any())
      carries.back() = true;
    for (unsigned int cell = 0; cell < layout.n_cells; ++cell)
      if (scene.row.is_given() && scene.row.cells[cell].is_gap)
        carries[cell] = true;

    // Cells with no part of their own have the same entries if they are as
    // long: most are not integrated.
    auto       cell    = discretization.dof_handler().begin_active();
    double     last    = 0.; // length of the cell whose entries are there
    const auto repeats = [&](const unsigned int number) {
      if (number > 0)
        ++cell;
      const bool   is_plain = !cell->at_boundary() && !scene.row.is_given();
      const double size     = cell->measure();
      if (is_plain && std::abs(size - last) <= 0.5 * rounding * size)
        return true;
      last = is_plain ? size : 0.;
      rod_entries.assign(n_matrices * n * n, 0.);
      if (!discretization.is_gap(cell))
        {
          add_mass(cell);
          add_stiffness(cell);
        }
      add_attached(cell);
      add_gap(cell);
      add_heat_exchange(cell);
      return false;
    };
    rod_ = std::make_unique<const RodMatrices>(
      layout,
      rounding,
      [&](const Kind kind,
          const unsigned int,
          const unsigned int i,
          const unsigned int j) { return rod_entries[(kind * n + j) * n + i]; },
      carries,
      repeats);
    rod_entries = {};
  }



  template <int dim>
  void
  FieldMatrices<dim>::setup(const Kind kind)
  {
    const auto [rows, columns] = fields_of(kind);
    TrilinosWrappers::SparsityPattern pattern(
      discretization.owned_by_block()[rows],
      discretization.owned_by_block()[columns],
      discretization.relevant_by_block()[rows],
      discretization.communicator());
    for (const auto &cell :
         discretization.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const auto column_dofs = dofs(cell, columns);
          for (const types::global_dof_index row : dofs(cell, rows))
            pattern.add_entries(row, column_dofs.begin(), column_dofs.end());
        }
    pattern.compress();
    matrices[kind].reinit(pattern);
  }



  template <int dim>
  std::vector<types::global_dof_index>
  FieldMatrices<dim>::dofs(const Cell &cell, const Field::Block field) const
  {
    std::vector<types::global_dof_index> all(cell->get_fe().dofs_per_cell);
    cell->get_dof_indices(all);
    std::vector<types::global_dof_index> of_field;
    for (const std::size_t place : places[field])
      of_field.push_back(all[place] - discretization.first_dof(field));
    return of_field;
  }



  template <int dim>
  void
  FieldMatrices<dim>::add(const Kind                kind,
                          const Cell               &cell,
                          const FullMatrix<double> &cell_matrix,
                          const double              factor)
  {
    const auto [rows, columns] = fields_of(kind);
    if (!discretization.has_field(rows) || !(has_[kind] || dim == 1))
      return;
    FullMatrix<double> block(places[rows].size(), places[columns].size());
    block.extract_submatrix_from(cell_matrix, places[rows], places[columns]);
    block *= factor;
    if constexpr (dim == 1)
      {
        double *entry = &rod_entries[kind * block.m() * block.m()];
        for (unsigned int j = 0; j < block.n(); ++j)
          for (unsigned int i = 0; i < block.m(); ++i)
            *entry++ += block(i, j);
      }
    else
      matrices[kind].add(dofs(cell, rows), dofs(cell, columns), block);
  }



  template <int dim>
  double
  FieldMatrices<dim>::factor(const Kind kind, const Cell &cell) const
  {
    if (!discretization.has_bodies() || discretization.coefficients_vary(cell))
      return 1.; // within the integrals
    const EquationFactors whole =
      discretization.in_equations(cell, cell->center());
    switch (kind)
      {
        case heat_mass:
          return whole.heat_mass;
        case conduction:
          return whole.conduction;
        case divergence:
        case thermal_stress:
          return whole.coupling;
        case momentum_mass:
          return whole.inertia;
        case stiffness:
          return whole.stiffness;
        case viscous_stiffness:
          return whole.viscosity;
        default:
          return 1.;
      }
  }



  template <int dim>
  void
  FieldMatrices<dim>::add_attached(const Cell &cell)
  {
    if (!scene.fields.has_displacement || !cell->at_boundary())
      return;
    const FiniteElement<dim> &fe  = discretization.finite_element();
    FullMatrix<double>       &one = integrals->scratch;
    for (const unsigned int vertex : {0, 1}) // left, right
      if (cell->at_boundary(vertex))
        {
          const auto        &attached = vertex == 0 ? scene.left : scene.right;
          const unsigned int dof      = fe.component_to_system_index(
            discretization.first_component(Field::displacement), vertex);
          const auto add_part = [&](const Kind kind, const double value) {
            if (value == 0.)
              return;
            one           = 0.;
            one(dof, dof) = value;
            add(kind, cell, one);
          };
          add_part(stiffness, attached.spring);
          add_part(viscous_stiffness,
                   attached.dashpot == 0. ?
                     0. :
                     attached.dashpot / scene.material.viscous_factor());
          add_part(momentum_mass,
                   attached.mass == 0. ?
                     0. :
                     attached.mass / scene.material.inertia);
        }
  }



  template <int dim>
  void
  FieldMatrices<dim>::add_gap(const Cell &cell)
  {
    const FiniteElement<dim> &fe     = discretization.finite_element();
    FullMatrix<double>       &matrix = integrals->scratch;
    const auto place = [&](const Field::Block field, const unsigned int node) {
      return fe.component_to_system_index(discretization.first_component(field),
                                          node);
    };
    const unsigned int right = 1, first_inner = 2; // nodes of a cell
    const unsigned int number = cell->active_cell_index();
    if (!discretization.is_gap(cell))
      return;
    // nodes within a gap stay at rest
    for (const Kind kind :
         {heat_mass, conduction, momentum_mass, stiffness, viscous_stiffness})
      if (const Field::Block field = fields_of(kind)[0];
          discretization.has_field(field))
        {
          matrix = 0.;
          for (unsigned int i = first_inner; i <= fe.degree; ++i)
            matrix(place(field, i), place(field, i)) = 1.;
          add(kind, cell, matrix);
        }
    for (const RowMass &mass : scene.row.masses)
      if (mass.vertex == number + 1)
        for (const Field::Block field : all_fields)
          if (discretization.has_field(field) &&
              (field == Field::temperature || scene.material.has_inertia()))
            {
              matrix               = 0.;
              const std::size_t at = place(field, right);
              matrix(at, at)       = field == Field::temperature ?
                                       mass.heat_capacity :
                                       mass.mass / scene.material.inertia;
              add(field == Field::temperature ? heat_mass : momentum_mass,
                  cell,
                  matrix);
            }
    for (const RowContact &contact : scene.row.contacts)
      if (contact.cell == number &&
          discretization.has_field(Field::temperature))
        {
          matrix = 0.;
          const double k =
            contact.exchange.value_or(scene.exchange_coefficient);
          for (const unsigned int i : {0U, right})
            for (const unsigned int j : {0U, right})
              matrix(place(Field::temperature, i),
                     place(Field::temperature, j)) = i == j ? k : -k;
          add(conduction, cell, matrix);
        }
  }



  template <int dim>
  void
  FieldMatrices<dim>::add_mass(const Cell &cell)
  {
    const FiniteElement<dim> &fe = discretization.finite_element();
    Integrals                &by = *integrals;
    const unsigned int        axial =
      scene.fields.has_displacement ?
               discretization.first_component(Field::displacement) :
               numbers::invalid_unsigned_int;
    const bool varies    = discretization.coefficients_vary(cell);
    const auto integrate = [&](const FEValues<dim> &values,
                               const auto          &is_wanted) {
      std::vector<EquationFactors> at(values.n_quadrature_points);
      for (const unsigned int q : values.quadrature_point_indices())
        if (varies)
          at[q] = discretization.of_material(cell, values.quadrature_point(q));
        else
          at[q].inertia = at[q].heat_mass = 1.;
      for (const unsigned int i : values.dof_indices())
        for (const unsigned int j : values.dof_indices())
          {
            const unsigned int c = fe.system_to_component_index(i).first;
            if (c == fe.system_to_component_index(j).first && is_wanted(c))
              for (const unsigned int q : values.quadrature_point_indices())
                by.mass(i, j) +=
                  (scene.fields.has_temperature && c == 0 ? at[q].heat_mass :
                                                            at[q].inertia) *
                  values.shape_value(i, q) * values.shape_value(j, q) *
                  discretization.geometry().weight(values, q);
          }
    };
    const bool has_axial_rule =
      scene.has_midpoint_mass ||
      (scene.has_massless_nodes && touches_contact_end<dim>(cell));
    by.mass_values.reinit(cell);
    if (varies || !has_last_integrals(discretization, by.mass_values) ||
        has_axial_rule != by.had_axial_rule)
      {
        by.mass = 0.;
        integrate(by.mass_values, [&](const unsigned int c) {
          return !(has_axial_rule && c == axial);
        });
        if (has_axial_rule)
          {
            by.axial_values.reinit(cell);
            integrate(by.axial_values,
                      [&](const unsigned int c) { return c == axial; });
          }
      }
    by.had_axial_rule = has_axial_rule;
    for (const Kind kind : {heat_mass, momentum_mass})
      add(kind, cell, by.mass, factor(kind, cell));
  }



  template <int dim>
  void
  FieldMatrices<dim>::add_stiffness(const Cell &cell)
  {
    Integrals &by          = *integrals;
    const bool varies      = discretization.coefficients_vary(cell);
    const auto material_at = [&](const Point<dim> &place) {
      return discretization.of_material(cell, place);
    };
    WeightsAt<dim> weights; // 1, with factors of the cell
    if (varies)
      weights = [&](const Point<dim> &place) -> ProductWeights {
        const EquationFactors at = material_at(place);
        return {at.conduction,
                at.stiffness,
                at.coupling,
                discretization.elasticity(cell, place)};
      };
    by.values.reinit(cell);
    if (varies || !has_last_integrals(discretization, by.values))
      integrate_products(scene.material,
                         discretization,
                         by.values,
                         weights,
                         by.basis,
                         by.stiffness,
                         by.coupling);
    for (const Kind kind : {conduction, stiffness})
      add(kind, cell, by.stiffness, factor(kind, cell));
    if (scene.material.has_thermal_stress())
      for (const Kind kind : {divergence, thermal_stress})
        add(kind, cell, by.coupling, factor(kind, cell));
    if (scene.material.has_dashpots && !scene.material.has_viscosity())
      return; // they are all that resists velocities
    const FullMatrix<double> *resistance = &by.stiffness;
    if (varies)
      {
        weights = [&](const Point<dim> &place) -> ProductWeights {
          return {0.,
                  material_at(place).viscosity,
                  0.,
                  discretization.elasticity(cell, place)};
        };
        integrate_products(scene.material,
                           discretization,
                           by.values,
                           weights,
                           by.basis,
                           by.viscous,
                           by.scratch);
        resistance = &by.viscous;
      }
    if (scene.has_elastic_contact_nodes && touches_contact_end<dim>(cell))
      {
        by.extended = 0.;
        by.extended.triple_product(*resistance,
                                   by.extension,
                                   by.extension,
                                   true);
        resistance = &by.extended;
      }
    add(viscous_stiffness, cell, *resistance, factor(viscous_stiffness, cell));
  }



  template <int dim>
  void
  FieldMatrices<dim>::add_heat_exchange(const Cell &cell)
  {
    integrals->faces.visit(
      cell, [&](const CellMatrix &exchange, const bool is_lateral) {
        // the end of a gap is that of a mass
        if (is_lateral && discretization.is_gap(cell))
          return;
        FullMatrix<double> &cell_matrix = integrals->scratch;
        cell_matrix                     = 0.;
        exchange.matrix.scatter_matrix_to(exchange.dofs,
                                          exchange.dofs,
                                          cell_matrix);
        for (const Kind kind : {conduction, heat_exchange})
          add(kind, cell, cell_matrix);
        if (is_lateral)
          add(lateral_exchange, cell, cell_matrix);
      });
  }



  template class FieldMatrices<1>;
  template class FieldMatrices<2>;
  template class FieldMatrices<3>;
} // namespace ThermoContact
