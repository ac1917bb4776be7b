#include "model/solid_shape.hpp"

#include <algorithm>
#include <vector>

namespace cleave::model {
namespace {

using Turn = std::array<int, 8>;

/// The 24 rotations of a hexahedron onto itself, as permutations of its nodes; the identity first.
const std::vector<Turn>& turns() {
  static const std::vector<Turn> all = [] {
    constexpr Turn about_z{1, 2, 3, 0, 5, 6, 7, 4}, about_x{3, 2, 6, 7, 0, 1, 5, 4};
    std::vector<Turn> found{{0, 1, 2, 3, 4, 5, 6, 7}};
    for (std::size_t i = 0; i < found.size(); ++i)
      for (const Turn& generator : {about_z, about_x}) {
        Turn next;
        for (int a = 0; a < 8; ++a) next[a] = found[i][generator[a]];
        if (std::find(found.begin(), found.end(), next) == found.end()) found.push_back(next);
      }
    return found;
  }();
  return all;
}

constexpr std::array<int, 4> hex_faces[] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                            {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
constexpr std::array<int, 4> penta_faces[] = {
    {0, 2, 1, 1}, {3, 4, 5, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
constexpr std::array<int, 4> tet_faces[] = {{0, 2, 1, 1}, {0, 1, 3, 3}, {1, 2, 3, 3}, {2, 0, 3, 3}};

bool on_one_face(int a, int b) {
  for (const auto& f : hex_faces)
    if (std::find(f.begin(), f.end(), a) != f.end() && std::find(f.begin(), f.end(), b) != f.end())
      return true;
  return false;
}

Classified made(Shape shape, std::initializer_list<Id> nodes) {
  Classified c{.ok = true, .shape = shape, .node_count = static_cast<int>(nodes.size())};
  std::copy(nodes.begin(), nodes.end(), c.node.begin());
  return c;
}

int distinct_count(std::array<Id, 10> n, int count) {
  std::sort(n.begin(), n.begin() + count);
  return static_cast<int>(std::unique(n.begin(), n.begin() + count) - n.begin());
}

}  // namespace

std::span<const std::array<int, 4>> faces_of(Shape shape) {
  switch (shape) {
    case Shape::hex8:
      return hex_faces;
    case Shape::penta6:
      return penta_faces;
    case Shape::tet4:
    case Shape::tet10:
      return tet_faces;
    case Shape::tri3:
    case Shape::quad4:
    case Shape::line2:
      break;  // no solids
  }
  return {};
}

Classified classify(std::span<const Id, 10> node) {
  std::array<Id, 10> n;
  std::copy(node.begin(), node.end(), n.begin());
  if (n[8] != 0 || n[9] != 0) {
    Classified c{.ok = false, .shape = Shape::tet10, .node_count = 10, .node = n};
    c.ok = std::find(n.begin(), n.end(), 0) == n.end() && distinct_count(n, 10) == 10;
    return c;
  }

  // Blank trailing columns repeat the last node given.
  for (int a = 1; a < 8; ++a)
    if (n[a] == 0) n[a] = n[a - 1];
  if (n[0] == 0) return {};
  bool repeats = false;
  for (int a = 1; a < 8 && !repeats; ++a)
    repeats = std::find(n.begin(), n.begin() + a, n[a]) != n.begin() + a;
  Classified hex{.ok = true, .shape = Shape::hex8, .node_count = 8, .node = n};
  if (!repeats) return hex;

  switch (distinct_count(n, 8)) {
    case 4:
      for (const Turn& t : turns()) {
        const auto at = [&](int a) { return n[t[a]]; };
        if (at(4) == at(5) && at(5) == at(6) && at(6) == at(7)) {
          if (at(3) == at(4) || at(3) == at(2)) return made(Shape::tet4, {at(0), at(1), at(2), at(4)});
        }
      }
      return {};
    case 6:
      for (const Turn& t : turns()) {
        const auto at = [&](int a) { return n[t[a]]; };
        if (at(4) == at(5) && at(6) == at(7))
          return made(Shape::penta6, {at(0), at(4), at(1), at(3), at(6), at(2)});
      }
      return {};
    case 5:
    case 7:
      for (int a = 0; a < 8; ++a)
        for (int b = 0; b < a; ++b)
          if (n[a] == n[b] && !on_one_face(a, b)) return {};
      return hex;
    default:
      return {};
  }
}

}  // namespace cleave::model
