// SPDX-License-Identifier: LGPL-2.1-or-later

#include <thermocontact/base/special_numbers.h>
#include <thermocontact/base/tolerances.h>
#include <thermocontact/time/contact_port.h>

#include <algorithm>

namespace ThermoContact
{
  template <int dim>
  ContactPort<dim>::ContactPort(const Body<dim>   &body,
                                LinearSystem<dim> &system)
    : body(body)
    , system(&system)
    , rest(body.discretization.make_vector(Field::displacement))
  {}



  template <int dim>
  ContactPort<dim>::ContactPort(const Body<dim> &body)
    : body(body)
    , system(nullptr)
  {}



  template <int dim>
  void
  ContactPort<dim>::solve_system(const bool is_last)
  {
    system->solve(*y,
                  *forces,
                  is_last ? Tolerances::rounding_of_solution :
                            Tolerances::loose_residual);
  }



  template <int dim>
  const Vector &
  ContactPort<dim>::left()
  {
    system->residual(rest, *y, *forces);
    return rest;
  }



  template <int dim>
  const Vector &
  ContactPort<dim>::diagonal() const
  {
    return system->row_diagonal();
  }



  template <int dim>
  void
  ContactPort<dim>::set_springs(const std::vector<double> &springs,
                                const std::vector<double> &relaxed)
  {
    system->set_springs(springs, relaxed);
  }



  template <int dim>
  double
  ContactPort<dim>::rounding() const
  {
    return 10. * system->tolerance();
  }



  template <int dim>
  const FullMatrix<double> &
  ContactPort<dim>::response()
  {
    if (response_.m() > 0)
      return response_;
    const ContactEnd<dim> &end = body.contact_end();
    Vector                 load(rest), unit_response(rest);
    response_ = end.response_matrix([&](const unsigned int node) -> Vector & {
      end.set_load_of_node(Field::displacement, node, 1., load);
      system->solve(unit_response, load);
      return unit_response;
    });
    return response_;
  }



  template <int dim>
  void
  ContactPort<dim>::start(const Vector              &new_forces,
                          const std::vector<double> &new_position,
                          const double               new_factor,
                          Vector                    &new_y)
  {
    forces   = &new_forces;
    position = &new_position;
    factor   = new_factor;
    y        = &new_y;
  }



  template <int dim>
  void
  ContactPort<dim>::solve_with(const std::vector<double> &pressure)
  {
    rest = *forces;
    body.contact_end().subtract_load(Field::displacement, pressure, 1., rest);
    system->solve(*y, rest);
  }



  template <int dim>
  std::vector<double>
  ContactPort<dim>::receptances() const
  {
    const ContactEnd<dim> &end = body.contact_end();
    std::vector<double>    receptance(end.n_nodes(), 1.);
    if (!body.scene.fields.has_displacement)
      return receptance; // nothing pushes
    end.get_values(Field::displacement, diagonal(), receptance);
    for (unsigned int i = 0; i < receptance.size(); ++i)
      receptance[i] = factor * scale * end.nodes()[i].weight / receptance[i];
    return receptance;
  }



  template <int dim>
  void
  ContactPort<dim>::set_tangents(const std::vector<AffineLaw> &laws,
                                 const std::vector<double>    &position,
                                 const double                  factor)
  {
    springs.resize(laws.size());
    touching.resize(laws.size());
    for (unsigned int i = 0; i < laws.size(); ++i)
      {
        springs[i]  = laws[i].compliance == 0. ?
                        infinity :
                        factor * scale * body.contact_end().nodes()[i].weight /
                         laws[i].compliance;
        touching[i] = (laws[i].offset - position[i]) / factor;
      }
    set_springs(springs, touching);
  }



  template <int dim>
  void
  ContactPort<dim>::solve(const std::vector<AffineLaw> &laws,
                          const bool                    is_last,
                          std::vector<double>          &new_position,
                          std::vector<double>          &pressure)
  {
    const ContactEnd<dim> &end = body.contact_end();
    tangents                   = laws;
    set_tangents(laws, *position, factor);
    solve_system(is_last);

    end.get_values(Field::displacement, *y, new_position);
    for (unsigned int i = 0; i < laws.size(); ++i)
      new_position[i] = laws[i].compliance == 0. ?
                          laws[i].offset :
                          (*position)[i] + factor * new_position[i];
    pressure.assign(laws.size(), 0.);
    if (std::all_of(laws.begin(), laws.end(), [](const AffineLaw &law) {
          return law.is_open();
        }))
      return;
    Vector        force(left());
    const Vector &of_rows = diagonal();
    for (const auto &[node, entry] : end.entries(Field::displacement))
      // Both agree where the system is solved: the one that errors of the
      // solution change less, which for springs softer than the body is theirs
      if (springs[node] < of_rows.local_element(entry))
        force.local_element(entry) =
          springs[node] * (y->local_element(entry) - touching[node]);
    end.get_values(Field::displacement, force, pressure);
    for (unsigned int i = 0; i < pressure.size(); ++i)
      pressure[i] =
        laws[i].is_open() ? 0. : pressure[i] / (scale * end.nodes()[i].weight);
  }



  template <int dim>
  unsigned int
  ContactPort<dim>::solve_contact(const Vector               &forces,
                                  const std::vector<NodeLaw> &laws,
                                  const std::vector<double>  &position,
                                  const double                factor,
                                  Vector                     &y,
                                  std::vector<double>        &pressure)
  {
    start(forces, position, factor, y);
    const bool has_factors = system != nullptr && system->has_factors();
    if (has_factors)
      system->solve(y, forces);
    std::vector<double> &x = positions_;
    body.contact_end().get_values(Field::displacement, y, x);
    for (unsigned int i = 0; i < x.size(); ++i)
      x[i] = position[i] + factor * x[i];
    if (!has_factors)
      return solve_by_tangents(
        *this, laws, receptances(), rounding(), x, pressure);

    FullMatrix<double> receptance(response());
    receptance *= factor;
    problem.solve(receptance, laws, x, pressure);
    tangents = problem.tangents();
    solve_with(pressure);
    return 0;
  }



  template <int dim>
  void
  ContactPort<dim>::solve_rates(const Vector                    &forces,
                                const std::vector<double>       &rate,
                                const std::vector<NodeLaw>      &laws,
                                const std::vector<unsigned int> &closing,
                                Vector                          &y)
  {
    start(forces, rate, 1., y);
    std::vector<AffineLaw> lines(tangents);
    for (const unsigned int i : closing)
      lines[i] = NodeLaw(laws[i].local()).tangent_of_pressure(0.);
    for (AffineLaw &line : lines)
      line.offset = 0.;
    if (!system->has_factors())
      {
        std::vector<double> pressures;
        solve(lines, true, positions_, pressures);
        return;
      }
    system->solve(y, forces);
    std::vector<double> free, slope;
    body.contact_end().get_values(Field::displacement, y, free);
    for (unsigned int i = 0; i < free.size(); ++i)
      {
        free[i] += rate[i];
        slope.push_back(lines[i].slope(response()(i, i)));
      }
    solve_with(change_of_pressure(response(), slope, free));
  }



  template class ContactPort<1>;
  template class ContactPort<2>;
  template class ContactPort<3>;
} // namespace ThermoContact
