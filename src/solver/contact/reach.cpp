#include "solver/contact/reach.hpp"

#include <atomic>

#include "base/threads.hpp"
#include "solver/ordered_sum.hpp"

namespace cleave::solver {
namespace {

constexpr std::size_t grain = 2048;
constexpr double longest = 50.0;  // steps that boxes look ahead

struct Sum {
  Vector v{0, 0, 0};
  Sum& operator+=(const Sum& other) {
    v = v + other.v;
    return *this;
  }
};
struct Largest {
  double value = 0.0;
  Largest& operator+=(const Largest& other) {
    value = std::max(value, other.value);
    return *this;
  }
};

}  // namespace

void Reach::renew(const Moment& now, std::span<const Index> nodes, double margin, double sweep) {
  nodes_.assign(nodes.begin(), nodes.end());
  boxes_.resize(now.mass.size());
  time_ = now.time;
  const std::size_t count = nodes_.size();
  drift_ = {0, 0, 0};
  if (count == 0) return;
  const Sum sum = ordered_sum<Sum>(count, grain, [&](std::size_t begin, std::size_t end) {
    Sum part;
    for (std::size_t i = begin; i < end; ++i) part.v = part.v + vector_at(now.velocity, nodes_[i]);
    return part;
  });
  drift_ = (1.0 / static_cast<double>(count)) * sum.v;
  const double fastest = ordered_sum<Largest>(count, grain, [&](std::size_t begin, std::size_t end) {
                           Largest part;
                           for (std::size_t i = begin; i < end; ++i)
                             part.value =
                                 std::max(part.value, norm(vector_at(now.velocity, nodes_[i]) - drift_));
                           return part;
                         }).value;
  const double step = std::max(now.step, now.step_before);
  double ahead = longest * step;
  if (fastest * ahead > sweep) ahead = std::max(sweep / fastest, step);
  base::for_each_range(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector x = vector_at(now.position, nodes_[i]), v = vector_at(now.velocity, nodes_[i]) - drift_;
      const Vector old = x - now.step_before * v, later = x + ahead * v;
      Bounds& box = boxes_[static_cast<std::size_t>(nodes_[i])];
      const double at[3][3] = {{x.x, old.x, later.x}, {x.y, old.y, later.y}, {x.z, old.z, later.z}};
      for (int k = 0; k < 3; ++k) {
        box.low[k] = std::min({at[k][0], at[k][1], at[k][2]}) - margin;
        box.high[k] = std::max({at[k][0], at[k][1], at[k][2]}) + margin;
      }
    }
  });
}

bool Reach::holds(const Moment& now) const {
  if (nodes_.empty()) return false;
  std::atomic<bool> all{true};
  const Vector shift = (now.time - time_) * drift_;
  base::for_each_range(nodes_.size(), grain, [&](std::size_t begin, std::size_t end) {
    bool mine = true;
    for (std::size_t i = begin; i < end; ++i) {
      const Vector x = vector_at(now.position, nodes_[i]) - shift;
      const Bounds& box = boxes_[static_cast<std::size_t>(nodes_[i])];
      mine = mine && x.x >= box.low[0] && x.x <= box.high[0] && x.y >= box.low[1] && x.y <= box.high[1] &&
             x.z >= box.low[2] && x.z <= box.high[2];
    }
    if (!mine) all.store(false, std::memory_order_relaxed);
  });
  return all.load();
}

}  // namespace cleave::solver
