#include "solver/tents_album.hpp"

#include <algorithm>

namespace cleave::solver {

using namespace discretisation::spacetime;

template <int D>
void TentAlbum<D>::add(const Key& key, const Patch& patch) {
  if (most_ == 0) return;
  const std::lock_guard lock(mutex_);
  if (tents_.size() == most_) {
    if (!(key < tents_.front().key)) return;
    std::pop_heap(tents_.begin(), tents_.end());
    tents_.pop_back();
  }
  tents_.push_back({key, patch.elements});
  std::push_heap(tents_.begin(), tents_.end());
}

template <int D>
CellFields TentAlbum<D>::cells(double speed, std::span<const model::Id> element_of_simplex) const {
  CellFields out;
  if (D == 3) return out;
  out.dimension = D + 1;
  out.fields.push_back({"order", 1, {}});
  std::vector<Tent> sorted = tents_;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t n = 0; n < sorted.size(); ++n)
    for (const PatchElement<D>& element : sorted[n].elements) {
      out.element.push_back(element_of_simplex[static_cast<std::size_t>(element.simplex)]);
      out.part.push_back(element.material);
      for (const Event<D>& y : element.corner) {
        out.cell.push_back(static_cast<model::Index>(out.point.size() / 3));
        for (std::size_t k = 0; k < 3; ++k) out.point.push_back(k < D ? y[k] : k == D ? speed * y[D] : 0.0);
        out.fields[0].value.push_back(static_cast<double>(n + 1));
      }
    }
  return out;
}

template class TentAlbum<1>;
template class TentAlbum<2>;
template class TentAlbum<3>;

}  // namespace cleave::solver
