#pragma once
/// What the deletion of elements means for the nodes.

#include <span>
#include <unordered_map>
#include <vector>

#include "discretisation/world.hpp"

namespace cleave::solver {

/// Counts the active elements of each node. A node that has lost all of them leaves the calculation with its
/// mass and kinetic energy (point masses stay), as the format's default asks.
class Erosion {
 public:
  Erosion(const discretisation::World& world, const discretisation::State& state);

  double active_count() const { return active_; }  ///< elements
  /// @return true if the masses of nodes changed
  bool remove(std::span<const model::Id> eroded, discretisation::State& state);

 private:
  struct Where {
    std::size_t block, element;
  };
  void find_elements();

  const discretisation::World& world_;
  std::vector<std::int32_t> elements_of_;         // [node], active
  std::unordered_map<model::Id, Where> element_;  // filled when the first element is deleted
  std::vector<double> point_mass_;                // [node], empty if there are none
  double active_ = 0.0;
};

}  // namespace cleave::solver
