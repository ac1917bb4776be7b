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

#include "discretisation/spacetime/quadrature.hpp"
#include "discretisation/spacetime/space.hpp"
#include "discretisation/spacetime/target.hpp"
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

  /// Residuals and energies of the patch just solved, from traces at quadrature points.
  void verify(const Patch<D>& patch, std::span<const Solution<D>* const> older,
              std::span<const Solution<D>> solution, Verify& out) const;

  /// Matrix of the last patch before elimination, row-major; kept only while `keep_matrix` is set.
  bool keep_matrix = false;
  const std::vector<double>& matrix() const { return matrix_; }

  int unknowns() const { return unknowns_; }      ///< of the last patch
  int iterations() const { return iterations_; }  ///< of the last patch; 1 if it was linear
  double flops() const { return flops_; }         ///< of the elimination of the last patch, counted by blocks
  std::size_t scratch() const { return arena_.capacity(); }  ///< doubles

 private:
  static constexpr int NU = state_count<D>;
  static constexpr int body_points = 2;  ///< points per direction added for a body force that varies
  /// One side of a facet: functionals on the element's unknowns, `components` times `modes` of them.
  struct Side {
    int element = -1, components = 0;
    Block modes;              ///< [mode][polynomials]: coefficients of the facet functions of each phi_a
    Matrix<NU> projection{};  ///< [component][state component]
    Block trace;              ///< [components * modes][unknowns]; no data while the Kronecker form serves
  };
  struct FacetRule {
    const SimplexRule* rule = nullptr;
    Block weighted;  ///< [point][facet polynomials], times the weight
  };

  SpaceChoice choice(const PatchElement<D>& element, std::size_t index,
                     std::span<const SpaceChoice> choices) const;
  const TrefftzTable<D>* table(SpaceChoice c, int material);
  const FacetRule& facet_rule(int per_direction) const;
  int points_per_direction(const Facet<D>& facet, const Solution<D>* older = nullptr) const;
  void facet_points(const Facet<D>& facet, const SimplexRule& rule) const;
  void older_states(const Patch<D>& patch, const Facet<D>& facet, const Solution<D>* older) const;
  double star_values(const Facet<D>& facet, std::span<const Solution<D>> solution) const;
  bool is_vertical(const Facet<D>& facet) const;
  /// An interior facet may be listed by both its elements; it is worked on once, for the first of them.
  static bool listed_before(const Facet<D>& f) {
    return f.kind == FacetKind::interior && f.neighbour < f.element;
  }
  const Target<D>& target(const Facet<D>& facet) const;
  Interface<D> interface_of(const Facet<D>& facet) const;
  Matrix<NU> scaled_flux(const Facet<D>& facet) const;

  Block& block(int row, int column);
  void assemble_volume(int e);
  void assemble_inflow(const Patch<D>& patch, const Facet<D>& facet, const Solution<D>* older);
  void assemble_vertical(const Facet<D>& facet, std::span<const Solution<D>> now);
  PatchStatus assemble_tilted(const Facet<D>& facet);
  Side side(int element, const FacetRule& rule, bool at_points);
  void project_traces(Side& s, const Vector<D>& n) const;
  void expand(Side& s);
  void couple(const Side& row, const Side& column, std::span<const Matrix<NU>> factor);
  void load(const Side& row, const double* coefficients);
  bool eliminate();

  void displacements(const Patch<D>& patch, std::span<const Solution<D>* const> older,
                     std::span<Solution<D>> out);
  void rigid_motion(const Patch<D>& patch, int e, std::span<const Solution<D>* const> older,
                    Solution<D>& out);
  void three_field_displacement(const Patch<D>& patch, const std::vector<int>& group,
                                std::span<const Solution<D>* const> older, std::span<Solution<D>> out);

  const Problem<D>& problem_;
  TargetPtr<D> bonded_;
  std::map<std::pair<int, int>, std::unique_ptr<TrefftzTable<D>>> tables_;  ///< by material and degree
  Arena arena_;
  std::vector<ElementSpace<D>> elements_;
  int count_ = 0;              ///< elements of this patch
  std::vector<Block> blocks_;  ///< [row][column] of elements; no data where the matrix is zero
  std::vector<Block> rhs_;
  std::vector<int> pivot_, order_, group_;
  std::vector<char> done_;
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
  std::vector<Matrix<NU>> factors_;
};

}  // namespace cleave::discretisation::spacetime
