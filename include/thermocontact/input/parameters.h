// SPDX-License-Identifier: LGPL-2.1-or-later

#ifndef thermocontact_input_parameters_h
#define thermocontact_input_parameters_h

#include <thermocontact/base/multiples.h>
#include <thermocontact/base/special_numbers.h>
#include <thermocontact/contact/contact_law.h>
#include <thermocontact/input/body_parameters.h>
#include <thermocontact/input/declared_entries.h>
#include <thermocontact/input/expression.h>
#include <thermocontact/input/own_law.h>
#include <thermocontact/method/body_geometry.h>
#include <thermocontact/method/scheme.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace ThermoContact
{
  using dealii::ParameterHandler;

  /** Kind of quantity of coefficients that section Rod decides. */
  inline const std::string kind_of_coefficients = "coefficient";



  /** Section Model: coefficients of doc/model.md (M1.1), (M1.2), (M1.6). */
  struct ModelParameters
  {
    std::string fields        = "temperature and displacement";
    double      inertia       = 1.;    ///< $b\ge0$; 0 is quasi-static
    double      viscosity     = 0.2;   ///< $\zeta\ge0$
    double      coupling      = 0.017; ///< $a$
    bool        heating       = true;  ///< the term $-a\,\mathrm{div}\,u_t$
    double      poisson_ratio = 0.;    ///< $\nu$, dim > 1

    void
    add_parameters(ParameterHandler &prm);
  };



  /** Section Boundary: doc/model.md (M1.3), by the names of its parts. */
  struct BoundaryParameters
  {
    /** Spring, dashpot and mass on an end of a rod, per cross-section. */
    struct Attached
    {
      double spring  = 0.; ///< $s\ge0$, to the ground
      double dashpot = 0.; ///< $d\ge0$, to the ground
      double mass    = 0.; ///< $m\ge0$

      bool
      is_any() const
      {
        return spring > 0. || dashpot > 0. || mass > 0.;
      }

      /** All members, to compare: a binding that leaves one out does not
       * compile. */
      auto
      members() const
      {
        const auto &[a, b, c] = *this;
        return std::tie(a, b, c);
      }
    };

    /** The end x = 0. */
    struct Left : Attached
    {
      std::string support      = "clamped";
      std::string displacement = "0";     ///< $u_A$, in t
      std::string traction     = "0";     ///< $t_A$
      double      temperature  = 10.;     ///< $\theta_A$, a number,
      std::string temperature_expression; ///< or else in t, or none
      double      heat_exchange = 0.;     ///< $k_A\ge0$
      double      surroundings  = 0.;     ///< $\theta_{sA}$
      std::string heat_flux     = "0";    ///< $h_A$

      /** A temperature is given there; else heat may flow. */
      bool
      has_temperature() const
      {
        return temperature_expression != "none";
      }

      bool
      is_free() const
      {
        return support == "free";
      }
    };

    /** The contact end x = 1. */
    struct Right : Attached
    {
      std::string           support = "contact";
      std::optional<double> temperature;         ///< $\theta_B$; none: the next
      double                heat_exchange = 1.;  ///< $k\ge0$ if it is a number,
      std::string           exchange_expression; ///< or else in gap, pressure
      double                surroundings = 0.;   ///< $\theta_{obs}$, a number,
      std::string           surroundings_expression; ///< or else in y, z, t
      std::string           traction  = "0";         ///< $t$
      std::string           heat_flux = "0";         ///< $h$

      bool
      is_clamped() const
      {
        return support == "clamped";
      }

      /** An obstacle of section Contact stands before the end. */
      bool
      meets_obstacle() const
      {
        return support == "contact";
      }
    };

    /** The lateral faces. */
    struct Sides
    {
      std::string support       = "rollers";
      double      heat_exchange = 0.; ///< $m\ge0$
      double      surroundings  = 0.; ///< $\theta_\infty$
    };

    Left  left;
    Right right;
    Sides sides;

    void
    add_parameters(ParameterHandler &prm);
  };



  /** Section Contact: doc/model.md (M1.4), (M1.5). */
  struct ContactParameters
  {
    std::string           condition = contact_laws().front().name;
    ContactLawParameters  law       = default_law_parameters();
    double                gap       = 0.1; ///< $g$ if it is a number,
    std::string           gap_expression;  ///< or else in y, z, t
    std::optional<double> rear_gap; ///< $g_2$; none: there is no rear stop

    OwnLaw own_rear_law{"Contact", "Rear", "as in front", {}, {}};

    std::optional<double> stiffness;   ///< N/m^m, in SI units; in compliance
    std::optional<double> restitution; ///< $e$ of rigid contacts of masses
    std::string           massless_nodes = "automatic";

    /** True if there is a rear stop with an entry of its own. */
    bool
    has_own_rear_law() const
    {
      return rear_gap && own_rear_law.is_given();
    }

    void
    add_parameters(ParameterHandler &prm);
  };



  /** Section Initial values: expressions in x (y, z). */
  struct InitialValuesParameters
  {
    std::string temperature  = "theta_A*(cos(2*pi*x)-sin(pi*x/2))";
    std::string displacement = "0";
    std::string velocity     = "20*x*(x-1)^2";

    void
    add_parameters(ParameterHandler &prm);
  };



  /** Section Sources: expressions in x (y, z), t. */
  struct SourceParameters
  {
    std::string heat_source = "0"; ///< $q$
    std::string body_force  = "0"; ///< $f$

    void
    add_parameters(ParameterHandler &prm);
  };



  /** Section Mesh. */
  struct MeshParameters
  {
    /** Of a mesh whose cells and degree are automatic. */
    static constexpr unsigned int cells_by_default = 8, degree_by_default = 4;

    unsigned int cells          = 0; ///< 0: automatic, until a Scene has it
    unsigned int degree         = 0; ///< likewise
    unsigned int refinements    = 0;
    double       grading        = 1.;
    std::string  mass_matrix    = "consistent";
    std::string  geometry       = geometries().front().name;
    double       width          = 0.1;
    unsigned int cells_across   = 4; ///< 0: by the width, n_cells_across()
    double       grading_across = 1.;

    /** Where cells have to end, along and across the body, before its end;
     * those of a Scene, where its materials jump. */
    std::array<std::vector<double>, 2> planes;

    /** All members, to compare: a binding that leaves one out does not
     * compile. */
    auto
    members() const
    {
      const auto &[a, b, c, d, e, f, g, h, i, j] = *this;
      return std::tie(a, b, c, d, e, f, g, h, i, j);
    }

    void
    add_parameters(ParameterHandler &prm);

    /** The body for which the mesh stands, of this dimension. */
    std::unique_ptr<const BodyGeometry>
    make_geometry(const unsigned int dim) const
    {
      return ThermoContact::geometry(geometry).make(dim, width);
    }

    /** All cells are as large. */
    bool
    has_equal_cells() const
    {
      return grading == 1. && grading_across == 1. && planes[0].empty() &&
             planes[1].empty();
    }

    /**
     * How often the cells of a body in 2-D or 3-D can be joined by two in every
     * direction; 0 if they are graded.
     */
    unsigned int
    n_halvings() const;

    /** Cells across before the refinements: for cubes, if none are given. */
    unsigned int
    n_cells_across() const;

    /** Number of cells along the body. */
    double
    n_cells_along() const
    {
      return std::ldexp(cells, refinements);
    }

    /** Number of cells at the contact end. */
    double
    n_contact_cells(const unsigned int dim) const
    {
      return std::pow(std::ldexp(n_cells_across(), refinements), dim - 1.);
    }

    /** Number of cells of a body of this dimension. */
    double
    n_cells(const unsigned int dim) const
    {
      return n_cells_along() * n_contact_cells(dim);
    }

    /** The longest side over the shortest of the flattest cell; dim > 1. */
    double
    cell_aspect() const;

    /** Number of nodes of a field in a body of this dimension. */
    double
    n_nodes(const unsigned int dim) const;

    /** The nodes of the contact end. */
    double
    n_contact_nodes(const unsigned int dim) const;

    /**
     * Lengths of the cells along the rod before the refinements, in geometric
     * progression, or between planes, which have to be fewer than cells, nearly
     * the same.
     */
    std::vector<double>
    cell_sizes() const;

    /** The same across the body. */
    std::vector<double>
    cell_sizes_across() const;

    /** Mean distance of nodes along the body, also of a mesh whose cells and
     * degree are automatic. */
    double
    spacing() const;

    /** Mean distance of nodes in the cells of the contact end. */
    double
    contact_spacing() const;

    /**
     * Length of the body whose mass a node of the contact end has in the rule
     * of the nodes, $h/(p(p+1))$; nondimensional.
     */
    double
    contact_node_length() const;

    /** Makes half as many cells in each direction; false if there are no fewer.
     */
    bool
    halve(const unsigned int dim);

    /** Whether a place is in the body; coordinates that it lacks are 0. */
    bool
    contains(const std::array<double, 3> &place) const
    {
      const auto [x, y, z] = place;
      return x >= 0. && x <= 1. && y >= 0. && y <= width && z >= 0. &&
             z <= width;
    }

    /**
     * The range of the coordinates of places in the body, for messages.
     *
     * @param in_unit says a coordinate
     */
    std::string
    limits_of_places(
      const unsigned int                                dim,
      const std::function<std::string(const double x)> &in_unit) const;
  };



  /** The Time/Scheme that choose_scheme() decides. */
  inline const std::string automatic_scheme = "automatic";



  /** Section Time. */
  struct TimeParameters
  {
    std::string           scheme   = automatic_scheme;
    std::string           start    = "automatic";
    double                end_time = 10.;
    std::optional<double> step_size;        ///< none: error-controlled
    double                tolerance = 1e-5; ///< of error-controlled steps
    std::optional<double> first_step_size;  ///< none: from the tolerance
    double                minimum_step_size     = 0.;
    double                maximum_step_size     = infinity;
    std::string           locate_contact_events = "automatic";
    std::vector<double>   break_points; ///< where steps end

    void
    add_parameters(ParameterHandler &prm);

    bool
    has_error_control() const
    {
      return !step_size.has_value();
    }

    /** True if steps end where contact begins or ends. */
    bool
    locates_contact_events() const
    {
      return locate_contact_events == "true" ||
             (locate_contact_events == "automatic" && has_error_control());
    }

    /**
     * Number of fixed steps, without those that events or output times add:
     * the smallest $N$ with $N\Delta t\ge T$.
     */
    unsigned int
    n_steps() const
    {
      return static_cast<unsigned int>(
        intervals_until(step_size.value(), end_time));
    }
  };



  /** Section Solver. */
  struct SolverParameters
  {
    std::string  step_solver            = "monolithic";
    double       fixed_point_tolerance  = 1e-12;
    unsigned int fixed_point_iterations = 100;
    std::string  linear_solver          = "automatic";

    /** Relative residual of a stage; none: automatic. */
    std::optional<double> linear_tolerance;

    void
    add_parameters(ParameterHandler &prm);
  };



  /** Section Output. */
  struct OutputParameters
  {
    std::string directory;
    double      fields_interval  = 0.1;
    std::string fields_cells     = "linear";
    double      contact_interval = 0.;
    bool        boundaries       = false;
    std::string probes;               ///< read by probe_positions()
    std::string unit_of_probes = "m"; ///< of messages, in a file in SI units
    double      space_time_interval = 0.;
    double      period              = 0.;    ///< of poincare.csv
    bool        land_on_times       = false; ///< steps end on output times
    double      checkpoint_interval = 0.;    ///< seconds of wall-clock time
    bool        is_si               = true;  ///< if there are scales
    bool        has_error_bars      = false;

    /** Steps end on multiples of each of these. */
    std::vector<double>
    landing_intervals() const;

    void
    add_parameters(ParameterHandler &prm);
  };



  /**
   * Section Scales: one unit of the scene in SI units; for output alone.
   */
  struct ScalesParameters
  {
    std::optional<double> length;                ///< m, of positions
    std::optional<double> time;                  ///< s
    std::optional<double> displacement;          ///< m; none: as of positions
    std::optional<double> stress;                ///< Pa
    std::optional<double> area;                  ///< m^2, cross-section
    std::optional<double> temperature;           ///< K, above the reference
    std::optional<double> reference_temperature; ///< K
    std::string           time_unit        = "s";
    std::string           temperature_unit = "K";

    /** One of them. */
    struct Scale
    {
      const char           *name;
      std::optional<double> ScalesParameters::*value;
      bool                                     is_thermal, is_needed;
      const char                              *text;
    };

    static const std::vector<Scale> &
    all();

    void
    add_parameters(ParameterHandler &prm);

    /** True if there is any scale. */
    bool
    is_given() const;
  };



  /**
   * Section Rod: the body in SI units, doc/units.md. A file that has it is read
   * in SI units; SiScene, which makes a scene of it, asks for its entries by
   * their names.
   */
  struct RodParameters
  {
    double      length         = 0.; ///< m; 0: there is no such section
    double      density        = 0.; ///< kg/m^3
    double      youngs_modulus = 0.; ///< Pa
    std::string small_terms = "automatic", lateral_sides = "free";

    /** True if the file is in SI units. */
    bool
    is_given() const
    {
      return length > 0.;
    }

    void
    add_parameters(ParameterHandler &prm);
  };



  /** Section Study: runs the scene many times. */
  struct StudyParameters
  {
    std::string  vary;
    std::string  reference    = "none";
    unsigned int repetitions  = 1;
    double       target_error = 0.;
    bool         keep_files   = false;

    void
    add_parameters(ParameterHandler &prm);

    bool
    is_active() const
    {
      return !vary.empty();
    }
  };



  /**
   * Everything that a parameter file can set. The defaults are the scene of
   * the paper's first experiment; each default and each text stands once, in
   * the struct of its section.
   */
  struct Parameters
  {
    std::string  title;
    unsigned int dimension = 1;

    /** Section Constants; every expression and every number may name them. */
    std::map<std::string, double> constants;

    std::string folder; ///< of the parameter file, for its tables

    ModelParameters         model;
    RowParameters           row;
    BoundaryParameters      boundary;
    ContactParameters       contact;
    InitialValuesParameters initial_values;
    SourceParameters        sources;
    MeshParameters          mesh;
    TimeParameters          time;
    SolverParameters        solver;
    OutputParameters        output;
    ScalesParameters        scales;
    RodParameters           rod;
    StudyParameters         study;

    /** Section Bodies has a row of bodies: in one dimension. */
    bool
    has_row() const
    {
      return dimension == 1 && row.is_given();
    }

    /** Nothing is elastic but contacts. */
    bool
    has_masses_alone() const
    {
      return has_row() && !row.has_rods();
    }

    /** Section Bodies has the material of the body: in several dimensions. */
    bool
    has_material() const
    {
      return dimension > 1 && row.is_given();
    }

    /** The mass that is the obstacle of such a body; null: there is none. */
    const BodyParameters *
    obstacle_mass() const
    {
      return has_material() && row.bodies.size() > 1 ? &row.bodies[1] : nullptr;
    }

    /** A law that is not that of section Contact. */
    struct OwnLawOfKind
    {
      const OwnLaw         *own;
      const ContactLawKind *kind;
    };

    /** The laws with numbers or a kind of their own that the scene has. */
    std::vector<OwnLawOfKind>
    own_laws() const;

    /** False if no contact of the scene has the law of section Contact. */
    bool
    uses_general_law() const
    {
      return boundary.right.meets_obstacle() || !row.have_own_kinds();
    }

    /** All laws of the scene, that of section Contact first. */
    std::vector<std::unique_ptr<const ContactLaw>>
    make_contact_laws() const;

    /**
     * The names that an expression of the entry @p path may have; theta_A is
     * none of the variables. It is evaluated with gap and pressure, or else
     * with x, y, z and t, whichever it may name.
     */
    ExpressionNames
    names(const std::string &path) const;

    /** A coordinate of a probe in messages, in the unit of Output/Probes. */
    std::string
    text_of_coordinate(const double x) const;

    /**
     * Reads Output/Probes: positions separated by ';', the coordinates of each
     * by
     * ',', e.g. "0.25; 0.5; 1" or, in two dimensions, "0.5, 0.05; 1, 0.1".
     *
     * @return the coordinates of each position, 0 beyond the dimension
     * @throw InputError if a position is malformed or not in the body
     */
    std::vector<std::array<double, 3>>
    probe_positions() const;

    /**
     * Binds every member to an entry of @p prm. Parsing or `prm.set` then
     * writes into this object, which must outlive @p prm.
     */
    void
    add_parameters(ParameterHandler &prm);
  };



  /** All entries that there are, with their defaults. */
  const std::vector<DeclaredEntry> &
  entries_of_program();

  /**
   * The one of that path, or null; of a body or a pair the one that is declared
   * for all names.
   */
  const DeclaredEntry *
  find_entry(const std::string &path);

  /** The one of that path, which exists. */
  const DeclaredEntry &
  entry_of_program(const std::string &path);
} // namespace ThermoContact

#endif
