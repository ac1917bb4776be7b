#include "discretisation/spacetime/columns.hpp"

#include <algorithm>
#include <utility>

#include "base/threads.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
double SolvedElement<D>::begin() const {
  double t = corner[0][D];
  for (const Event<D>& y : corner) t = std::min(t, y[D]);
  return t;
}

template <int D>
double SolvedElement<D>::end() const {
  double t = corner[0][D];
  for (const Event<D>& y : corner) t = std::max(t, y[D]);
  return t;
}

template <int D>
Columns<D>::Columns(const Body<D>& body, std::span<const double> instants)
    : body_(body),
      instants_(instants),
      columns_(static_cast<std::size_t>(body.mesh.simplex_count())),
      past_(columns_.size()) {}

/// Does it end after the next instant, or is it cut by the one written last? An element between two instants
/// to come is kept for the sake of the sums of the earlier one.
template <int D>
bool Columns<D>::needed(const SolvedElement<D>& element) const {
  const double end = element.end();
  if (written_ < instants_.size() && end > instants_[written_]) return true;
  if (written_ < instants_.size() && element.begin() < instants_[written_] && end >= instants_[written_])
    return true;
  const double last = written_ > 0 ? instants_[written_ - 1] : 0.0;
  return element.begin() < last && end >= last;
}

template <int D>
void Columns<D>::commit(const Patch<D>& patch, std::span<Solution<D>> solution) {
  for (std::size_t e = 0; e < patch.elements.size(); ++e) {
    auto& column = columns_[static_cast<std::size_t>(patch.elements[e].simplex)];
    if (column.empty() || needed(column.back())) {
      column.emplace_back();
    } else {
      past_[static_cast<std::size_t>(patch.elements[e].simplex)] += column.back().exchange;
    }
    SolvedElement<D>& element = column.back();
    element.corner = patch.elements[e].corner;
    for (std::size_t i = 0; i < D; ++i) element.boundary[i] = patch.facets[e * (D + 2) + 2 + i].boundary;
    element.exchange = {};
    element.exchange.volume = patch.elements[e].volume;
    std::swap(element.solution, solution[e]);
  }
}

template <int D>
void Columns<D>::written(std::size_t count) {
  written_ = count;
  base::for_each_range(columns_.size(), 512, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      auto& column = columns_[s];
      std::size_t kept = 0;
      for (std::size_t k = 0; k < column.size(); ++k) {
        if (k + 1 < column.size() && !needed(column[k])) {
          past_[s] += column[k].exchange;
        } else {
          if (kept != k) std::swap(column[kept], column[k]);
          ++kept;
        }
      }
      column.resize(kept);
    }
  });
}

template <int D>
std::size_t Columns<D>::element_count() const {
  std::size_t count = 0;
  for (const auto& column : columns_) count += column.size();
  return count;
}

namespace {

template <int D>
void put(base::Array<double>& out, const Exchange<D>& x) {
  out.insert(out.end(), {x.boundary_work, x.body_work, x.dissipation, x.volume});
  out.insert(out.end(), x.impulse.begin(), x.impulse.end());
}

/// Reads numbers in the order in which they were put; after the end it gives zeros and is not good.
class Numbers {
 public:
  explicit Numbers(std::span<const double> values) : values_(values) {}
  double operator()() { return at_ < values_.size() ? values_[at_++] : (good_ = false, 0.0); }
  std::size_t count(std::size_t most) {
    const double n = (*this)();
    if (n >= 0.0 && n <= static_cast<double>(most)) return static_cast<std::size_t>(n);
    good_ = false;
    return 0;
  }
  bool good() const { return good_; }
  bool finished() const { return good_ && at_ == values_.size(); }
  std::size_t left() const { return values_.size() - at_; }

 private:
  std::span<const double> values_;
  std::size_t at_ = 0;
  bool good_ = true;
};

template <int D>
void take(Numbers& in, Exchange<D>& x) {
  x.boundary_work = in();
  x.body_work = in();
  x.dissipation = in();
  x.volume = in();
  for (double& component : x.impulse) component = in();
}

}  // namespace

template <int D>
void Columns<D>::save(base::Array<double>& values) const {
  values.push_back(static_cast<double>(written_));
  for (std::size_t s = 0; s < columns_.size(); ++s) {
    put(values, past_[s]);
    values.push_back(static_cast<double>(columns_[s].size()));
    for (const SolvedElement<D>& element : columns_[s]) {
      for (const Event<D>& y : element.corner) values.insert(values.end(), y.begin(), y.end());
      values.insert(values.end(), element.boundary.begin(), element.boundary.end());
      put(values, element.exchange);
      const Solution<D>& u = element.solution;
      for (const int n : {static_cast<int>(u.space.space), u.space.degree, u.degree, u.displacement_degree})
        values.push_back(n);
      for (const auto* coefficients : {&u.fields, &u.displacement}) {
        values.push_back(static_cast<double>(coefficients->size()));
        values.insert(values.end(), coefficients->begin(), coefficients->end());
      }
    }
  }
}

template <int D>
bool Columns<D>::load(std::span<const double> values) {
  Numbers in(values);
  written_ = in.count(instants_.size());
  for (std::size_t s = 0; s < columns_.size() && in.good(); ++s) {
    take(in, past_[s]);
    columns_[s].resize(in.count(in.left()));
    for (SolvedElement<D>& element : columns_[s]) {
      for (Event<D>& y : element.corner)
        for (double& component : y) component = in();
      for (std::int32_t& face : element.boundary) face = static_cast<std::int32_t>(in());
      take(in, element.exchange);
      Solution<D>& u = element.solution;
      u.space.space = static_cast<LocalSpace>(in.count(2));
      u.space.degree = static_cast<int>(in());
      u.degree = static_cast<int>(in());
      u.displacement_degree = static_cast<int>(in());
      for (auto* coefficients : {&u.fields, &u.displacement}) {
        coefficients->resize(in.count(in.left()));
        for (double& c : *coefficients) c = in();
      }
      const auto material = static_cast<std::size_t>(body_.mesh.material(static_cast<Simplex>(s)));
      u.material = &body_.problem.materials[material];
      if (!in.good() || !u.map.set(element.corner)) return false;
    }
  }
  return in.finished();
}

#define CLEAVE_INSTANTIATE(D)       \
  template struct SolvedElement<D>; \
  template class Columns<D>;
CLEAVE_INSTANTIATE(1)
CLEAVE_INSTANTIATE(2)
CLEAVE_INSTANTIATE(3)
#undef CLEAVE_INSTANTIATE

}  // namespace cleave::discretisation::spacetime
