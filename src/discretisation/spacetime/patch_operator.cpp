#include "discretisation/spacetime/patch_operator.hpp"

namespace cleave::discretisation::spacetime {

template <int D>
std::size_t OperatorStore<D>::Hash::operator()(const Key& key) const {
  std::uint64_t h = key.size();
  for (const std::uint64_t word : key) {
    h = (h ^ word) * 0x9e3779b97f4a7c15u;  // 2^64 over the golden ratio
    h ^= h >> 29;
  }
  return static_cast<std::size_t>(h);
}

template <int D>
auto OperatorStore<D>::find(const Key& key) -> List* {
  if (const auto at = young_.find(key); at != young_.end()) return &at->second;
  const auto at = old_.find(key);
  if (at == old_.end()) return nullptr;
  List list = std::move(at->second);
  old_.erase(at);
  for (const auto& op : list) size_ += op->memory.capacity();
  return &(young_[key] = std::move(list));
}

template <int D>
const PatchOperator<D>* OperatorStore<D>::add(const Key& key, std::unique_ptr<PatchOperator<D>> op,
                                              std::size_t limit) {
  if (size_ + op->memory.capacity() > limit / 2) {
    old_ = std::move(young_);
    young_.clear();
    size_ = 0;
  }
  size_ += op->memory.capacity();
  List& list = young_[key];
  list.push_back(std::move(op));
  return list.back().get();
}

template class OperatorStore<1>;
template class OperatorStore<2>;
template class OperatorStore<3>;

}  // namespace cleave::discretisation::spacetime
