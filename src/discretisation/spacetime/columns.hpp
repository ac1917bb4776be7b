#pragma once
/// The solution under the front: above each simplex of the space mesh the spacetime elements that later tents
/// or outputs still need, oldest first.
///
/// Outputs cut the solution at constant time, so an element is kept as long as the cut of an instant that is
/// not written yet may run through it, and for the instant written last.

#include <span>
#include <vector>

#include "base/array.hpp"
#include "discretisation/spacetime/body.hpp"

namespace cleave::discretisation::spacetime {

/// What passed into the body through the boundary, or was lost, in a piece of spacetime. Per unit of the
/// body's thickness.
template <int D>
struct Exchange {
  double boundary_work = 0.0;  ///< done on the body by what its boundary is held or loaded with [energy]
  double body_work = 0.0;      ///< done by the body force [energy]
  double dissipation = 0.0;    ///< numerical; known only where patches are verified [energy]
  Vector<D> impulse{};         ///< of the boundary and of the body force [momentum]
  double volume = 0.0;         ///< of spacetime [length^D time]

  Exchange& operator+=(const Exchange& other) {
    boundary_work += other.boundary_work;
    body_work += other.body_work;
    dissipation += other.dissipation;
    volume += other.volume;
    for (std::size_t i = 0; i < D; ++i) impulse[i] += other.impulse[i];
    return *this;
  }
};

/// A spacetime element whose patch has been solved.
template <int D>
struct SolvedElement {
  std::array<Event<D>, D + 2> corner{};    ///< as in PatchElement
  std::array<std::int32_t, D> boundary{};  ///< boundary face under facet 2 + i of the element; -1 inside
  Solution<D> solution;
  Exchange<D> exchange;  ///< over the whole element

  double begin() const;  ///< earliest time of its corners [time]
  double end() const;    ///< latest [time]
};

template <int D>
class Columns {
 public:
  /// @param instants  at which the solution is cut, ascending; must outlive the columns [time]
  Columns(const Body<D>& body, std::span<const double> instants);

  /// The solution under the front at a simplex; null before its first element.
  const Solution<D>* under(Simplex s) const {
    const auto& column = columns_[static_cast<std::size_t>(s)];
    return column.empty() ? nullptr : &column.back().solution;
  }
  /// Puts the elements of a solved patch above their simplices, with nothing exchanged but their volume. The
  /// memory of `solution` is swapped, not copied. Any thread; patches in flight share no simplex.
  void commit(const Patch<D>& patch, std::span<Solution<D>> solution);
  SolvedElement<D>& last(Simplex s) { return columns_[static_cast<std::size_t>(s)].back(); }

  std::span<const SolvedElement<D>> column(Simplex s) const { return columns_[static_cast<std::size_t>(s)]; }
  /// Of elements that are no longer kept [simplex].
  const std::vector<Exchange<D>>& past() const { return past_; }

  /// How many instants have been written; elements only these need are dropped.
  void written(std::size_t count);

  /// Everything as plain numbers, and back. Only columns of the same body can be read.
  void save(base::Array<double>& values) const;
  /// @return false if the numbers do not belong to this body
  bool load(std::span<const double> values);

  std::size_t element_count() const;

 private:
  bool needed(const SolvedElement<D>& element) const;

  const Body<D>& body_;
  std::span<const double> instants_;
  std::size_t written_ = 0;
  std::vector<std::vector<SolvedElement<D>>> columns_;
  std::vector<Exchange<D>> past_;
};

}  // namespace cleave::discretisation::spacetime
