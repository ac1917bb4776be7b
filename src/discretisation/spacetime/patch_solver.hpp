#pragma once
/// Assembles and solves one patch.
///
/// The discrete problem of every element is
///   int U^T (A0 U,t + A^j U,j - f) dV + int U^T (F* - A_N U) dS = 0 for all test functions U,
/// with F* the flux of the older element on inflow, of the element itself on outflow, and of the targets on
/// facets that contain the pole. Derivation and sources: docs/spacetime-numerics.md.

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "discretisation/spacetime/patch_operator.hpp"
#include "discretisation/spacetime/quadrature.hpp"
#include "discretisation/spacetime/space.hpp"
#include "discretisation/spacetime/target.hpp"
#include "discretisation/spacetime/vectors.hpp"
#include "discretisation/spacetime/verify.hpp"

namespace cleave::discretisation::spacetime {

/// What was asked for; const while the front advances.
template <int D>
struct Problem {
  std::vector<Elastic<D>> materials;      ///< by PatchElement::material
  std::vector<SpaceChoice> spaces;        ///< by PatchElement::material
  std::vector<const Target<D>*> targets;  ///< by Facet::boundary
  /// State on the initial front; none: at rest.
  std::function<PointState<D>(Simplex, const Event<D>&)> initial;
  VectorField<D> body_force;  ///< acceleration [length/time^2]; none: no body force
};

enum class PatchStatus {
  solved,
  degenerate,        ///< an element without volume
  singular,          ///< a facet lies on the characteristic cone
  tilted_interface,  ///< a facet between two materials is not vertical
  not_converged      ///< a nonlinear target
};

/// One of several patches that are solved together.
template <int D>
struct PatchJob {
  const Patch<D>* patch = nullptr;
  std::span<const Solution<D>* const> older;  ///< as in PatchSolver::solve
  std::span<Solution<D>> out;
  PatchStatus status = PatchStatus::solved;
  int unknowns = 0;
};

template <int D>
class PatchSolver {
 public:
  explicit PatchSolver(const Problem<D>& problem);

  /// @param older   [facets] under each inflow facet, null: the initial state. Other facets are not read
  /// @param choices [elements] local spaces; empty: those of the materials. A Trefftz space under a body
  /// force
  ///                becomes the three-field space of the same degree of velocity and strain
  /// @param out     [elements] overwritten; nothing else changes, so a patch can be dropped
  PatchStatus solve(const Patch<D>& patch, std::span<const Solution<D>* const> older,
                    std::span<Solution<D>> out, std::span<const SpaceChoice> choices = {});

  /// Patches that share no simplex, with the spaces of their materials. Equal ones go through their operator
  /// together, up to a lane of them; each has the same bits as if it were solved alone.
  void solve(std::span<PatchJob<D>> jobs);

  /// Residuals and energies of a patch that was solved, from traces at quadrature points.
  void verify(const Patch<D>& patch, std::span<const Solution<D>* const> older,
              std::span<const Solution<D>> solution, Verify& out);

  /// Matrix of the last patch before elimination, row-major; kept only while `keep_matrix` is set.
  bool keep_matrix = false;
  const std::vector<double>& matrix() const { return matrix_; }

  int unknowns() const { return unknowns_; }      ///< of the last patch
  int iterations() const { return iterations_; }  ///< of the last patch; 1 if it was linear
  double flops() const { return flops_; }         ///< of the elimination of the last patch, counted by blocks
  std::int64_t reused() const { return operators_.found(); }  ///< patches that found their operator
  std::size_t scratch() const { return arena_.capacity(); }   ///< doubles

 private:
  static constexpr int NU = state_count<D>;
  static constexpr int body_points = 2;  ///< points per direction added for a body force that varies
  /// Linear combinations of the state components on a facet: row r of the first `rows` gives one function.
  using Combination = Matrix<NU>;
  /// The functions of an element seen from a facet.
  struct Side {
    int element = -1;
    int opposite = -1;   ///< local number of the facet in the element, -1 if its corners do not match
    int count = 0;       ///< modes, or points
    double scale = 0.0;  ///< of all functions: 1 / sqrt(volume)
    Block modes;         ///< [functions][count] of the functions under the element's span, or of its phi_a
    Block trace;         ///< [NU * count][unknowns]; no data for three fields, which are modes x components
  };
  /// Functionals of an element's unknowns on a facet: written out, or as a combination for three fields.
  struct Functional {
    int rows = 0, count = 0;
    Block full;  ///< [rows * count][unknowns]; no data: combination of the modes
    Combination combination{};
    Block modes;  ///< of the side
  };
  /// One side of an interior facet that contains the pole. The side learns `receive` waves from the other and
  /// sends its own: all that two elements know of each other.
  struct Link {
    int element = -1;
    int wave = -1;       ///< 2 * facet + side: number of what this side sends; wave ^ 1 is what it receives
    Functional lift;     ///< K_element,other x_other = scale lift^T (what the other sends)
    Functional emit;     ///< what this side sends
    double scale = 1.0;  ///< of the lift
  };
  using Open = OpenFacet;
  /// Elements joined to one: waves out = h - S waves in, over the facets that are still open.
  struct Component {
    std::vector<Open> open, shared;  ///< shared: facets closed when its two parts were joined
    Block s;                         ///< [waves out][waves in, h]
    int first = -1, second = -1;     ///< the parts
    Block from_first, from_second;   ///< waves of the shared facets: [waves][waves in, h], h - G waves in
    bool joined = false;
    /// For operators: (1 - S1 S2)^-1 (1, S1) and the parts of S1 and S2.
    Block solve, second_on_first, first_rest_on_second, second_rest_on_first;
  };

  /// Data of an element that its operator is made for: test functional times what is given on a facet.
  struct Given {
    Functional test;
    double scale = 1.0;
  };

  bool is_linear(const Patch<D>& patch) const;
  bool repeats(const Patch<D>& patch) const;
  void make_key(const Patch<D>& patch);
  const PatchOperator<D>* find_operator(const Patch<D>& patch);
  const PatchOperator<D>* new_operator(const Patch<D>& patch);
  void place(const Patch<D>& patch);
  bool make_operator(const Patch<D>& patch, PatchOperator<D>& op);
  void keep_elements(PatchOperator<D>& op);
  void keep_response(int e, Block respond, typename PatchOperator<D>::Element& to);
  void pack(PatchOperator<D>& op);
  void apply(const PatchOperator<D>& op, std::span<PatchJob<D>* const> jobs);
  void gather(const PatchOperator<D>& op, std::size_t e, std::span<PatchJob<D>* const> jobs, int width);
  void join_waves(const PatchOperator<D>& op, std::size_t j, int width);
  void return_waves(const PatchOperator<D>& op, std::size_t j, int width);
  void restore(const PatchOperator<D>& op, std::size_t e, std::span<PatchJob<D>* const> jobs, int width);
  void sum_functions(const typename PatchOperator<D>::Element& element, const double* unknowns, double* x,
                     int width);
  /// Numbers of several vectors, see multiply_vectors().
  double* vectors(int rows, int width) { return arena_.take_raw(vectors_size(rows, width)); }
  bool fits(const PatchOperator<D>& op, const Patch<D>& patch);
  void put_columns(int element, const Functional& f, double scale, const Block& b, int column) const;

  SpaceChoice choice(const PatchElement<D>& element, std::size_t index,
                     std::span<const SpaceChoice> choices) const;
  const TrefftzTable<D>* table(SpaceChoice c, int material);
  const FacetRule& facet_rule(int per_direction) const;
  int points_per_direction(const Facet<D>& facet, const Solution<D>* older = nullptr) const;
  void facet_points(const Facet<D>& facet, const SimplexRule& rule) const;
  void older_states(const Patch<D>& patch, const Facet<D>& facet, const Solution<D>* older) const;
  /// Modes on an inflow facet of a solution next to it, or of the initial state: D rows of u, those of v and
  /// of strain, each padded(count) long, zero beyond count. Only rows from first_row to last_row are filled.
  /// @param degree of what they are tested with, where the state is not a polynomial
  double* older_modes(const Patch<D>& patch, const Facet<D>& facet, const Solution<D>* older, int degree,
                      int count, int first_row, int last_row);
  /// The same; u with `displacement`, else v and strain, energy-scaled.
  double* trace_modes(const Patch<D>& patch, const Facet<D>& facet, const Solution<D>* older, int degree,
                      int count, bool displacement);
  double star_values(const Facet<D>& facet, std::span<const Solution<D>> solution) const;
  bool is_vertical(const Facet<D>& facet) const;
  /// An interior facet may be listed by both its elements; it is worked on once, for the first of them.
  static bool listed_before(const Facet<D>& f) {
    return f.kind == FacetKind::interior && f.neighbour < f.element;
  }
  const Target<D>& target(const Facet<D>& facet) const;
  Interface<D> interface_of(const Facet<D>& facet) const;
  Matrix<NU> scaled_flux(const Facet<D>& facet) const;

  bool begin(const Patch<D>& patch, std::span<const SpaceChoice> choices);
  PatchStatus assemble(const Patch<D>& patch, std::span<const Solution<D>* const> older,
                       std::span<const Solution<D>> now);
  void assemble_volume(int e);
  void assemble_inflow(const Patch<D>& patch, const Facet<D>& facet, const Solution<D>* older);
  void assemble_vertical(const Facet<D>& facet, std::span<const Solution<D>> now);
  PatchStatus assemble_tilted(const Facet<D>& facet);
  Side side(int element, const Facet<D>& facet, const FacetRule& rule, bool at_points);
  void trace(Side& s);
  Functional functional(const Side& s, std::span<const Combination> c, int rows, int count, bool in_full);
  /// K_element += scale a^T b.
  void add(const Side& s, const Functional& a, const Functional& b, double scale);
  /// rhs += scale a^T data. @param data [rows][padded(count)], zero beyond count
  void load(int element, const Functional& a, double scale, const double* data);
  Block written(const Functional& a, int element);
  int new_link(int element);
  void sum_tables(int e);
  bool factorise(const Block& a);
  bool condense(int e);
  void emitted(const Link& link, const Block& b, const Block& out);
  bool join(int first, int second);
  bool condense_and_join();
  bool eliminate();
  void keep();

  void displacements(const Patch<D>& patch, std::span<const Solution<D>* const> older,
                     std::span<Solution<D>> out);
  /// [component, mode][component, polynomial]: the rigid motion that takes away a jump of the displacement on
  /// the inflow facet, both in polynomials of degree one.
  Block rigid_fit(int e, const Facet<D>& inflow);
  void rigid_motion(const Patch<D>& patch, int e, std::span<const Solution<D>* const> older,
                    Solution<D>& out);
  Block displacement_matrix(int e, const Facet<D>& inflow);
  void three_field_displacement(const Patch<D>& patch, const std::vector<int>& group,
                                std::span<const Solution<D>* const> older, std::span<Solution<D>> out);

  const Problem<D>& problem_;
  OperatorStore<D> operators_;
  bool pivoting_ = false;   ///< factors need exchanges of rows
  bool recording_ = false;  ///< an operator is being made: no data, but columns for them
  Event<D> origin_{};       ///< of the coordinates of facets, for targets
  Patch<D> placed_;         ///< a patch as seen from its foot, all of one shape with the same bits
  std::vector<std::vector<Given>> given_;  ///< [element], while recording
  struct Group {
    const PatchOperator<D>* op;
    std::vector<PatchJob<D>*> jobs;
  };
  std::vector<Group> groups_;  ///< of patches to solve together, and some without
  std::size_t group_count_ = 0;
  std::vector<double*> input_, carried_, part_out_, first_sent_, second_sent_;  ///< of apply()
  std::vector<Block*> to_pack_;
  typename OperatorStore<D>::Key key_;
  TargetPtr<D> bonded_;
  std::map<std::pair<int, int>, std::unique_ptr<TrefftzTable<D>>> tables_;  ///< by material and degree
  Arena arena_;
  std::vector<ElementSpace<D>> elements_;
  int count_ = 0;  ///< elements of this patch
  /// A matrix of components times a constant table: terms of a three-field element's own matrix.
  struct Term {
    Matrix<NU> factor;
    Block table;
  };
  std::vector<Block> own_;               ///< [element] K, later factored
  std::vector<char> own_filled_;         ///< [element] with more than the terms
  std::vector<double*> rhs_;             ///< [element] [unknowns], padded
  std::vector<std::vector<Term>> term_;  ///< [element]
  std::vector<Link> links_;
  int link_count_ = 0;
  std::vector<std::vector<int>> links_of_;  ///< [element]
  std::vector<Component> components_;       ///< elements first
  int component_count_ = 0;
  std::vector<Block> response_;  ///< [element] K^-1 (lifts of the waves that come in, rhs)
  std::vector<double*> wave_;    ///< what comes in
  std::vector<int> wave_width_, owner_;
  std::vector<int> pivot_, group_;
  std::vector<double> matrix_;
  int unknowns_ = 0, iterations_ = 0;
  double flops_ = 0.0, star_change_ = 0.0, star_size_ = 0.0;
  std::size_t star_count_ = 0;
  // Scratch at quadrature points, also of const functions.
  mutable std::vector<Event<D>> points_;
  mutable std::vector<PointState<D>> states_, other_states_;
  mutable std::vector<Traces<D>> traces_;
  mutable std::vector<StarMap<D>> maps_;
  mutable std::vector<Star<D>> loads_;
  std::vector<Star<D>> stars_;  ///< of the nonlinear facets in the iterate before
  std::vector<Combination> combination_[2];
};

}  // namespace cleave::discretisation::spacetime
