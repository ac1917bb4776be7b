#pragma once
/// The faces that others may not pass: outer faces of parts, or a set of faces, with what lies behind them.

#include <array>
#include <cmath>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/tensor.hpp"
#include "discretisation/world.hpp"
#include "model/contact.hpp"
#include "solver/field.hpp"

namespace cleave::solver {

using model::Index;
using Vector = base::Vec3<double>;

inline double norm(const Vector& v) {
  return std::sqrt(base::dot(v, v));
}

/// One face and the solid it belongs to.
struct Face {
  std::array<Index, 4> node;  ///< counter-clockwise seen from outside; triangles repeat the third
  model::Id element = 0;      ///< whose face it is
  Index part = -1;
  double stiffness = 0.0;   ///< K A^2 / V [force/length]
  double thickness = 0.0;   ///< V / A of the solid behind it, at the start [length]
  double area = 0.0;        ///< at the start [length^2]
  std::int32_t owner = -1;  ///< element it belongs to, by number
  std::int32_t twin = -1;   ///< face of the element on the other side; -1 none
  bool rigid = false;       ///< of a part that does not deform
  bool shell = false;       ///< a side of a shell: there is another one on the same nodes
  double offset = 0.0;      ///< of the surface from the nodes along the normal: half the shell [length]

  int corners() const { return node[3] == node[2] ? 3 : 4; }
};

/// Normal of a face times its area (half the product of the diagonals, exact for plane faces).
Vector area_normal(const Face& face, std::span<const double> position);

class Surface {
 public:
  /// @param side     parts, or faces
  /// @param inner    also keep faces between elements, which appear when elements are deleted
  /// Errors: faces on no solid; faces that point inward (unless `orient`).
  Surface(const discretisation::World& world, const model::Contact& contact, const model::ContactSide& side,
          bool inner, bool orient, deck::Diagnostics& diagnostics);

  /// Sets which elements are there.
  void start(const discretisation::State& state);
  /// Takes elements away, at the cost of the faces that change. Elements that are gone already do not matter.
  void erode(std::span<const model::Id> eroded);
  /// Grows whenever the active faces change.
  std::int64_t version() const { return version_; }

  const std::vector<Face>& faces() const { return faces_; }            ///< all there may ever be
  const std::vector<std::int32_t>& active() const { return active_; }  ///< those there are, ascending
  const std::vector<Index>& nodes() const { return nodes_; }           ///< of the active faces, ascending
  /// Active faces at a node.
  std::span<const std::int32_t> faces_at(Index node) const;
  /// Largest distance of a surface from its nodes [length].
  double largest_offset() const { return largest_offset_; }
  /// The active face across an edge of an active face; -1 for none or several.
  std::int32_t neighbour(std::int32_t face, int edge) const {
    return neighbour_[4 * static_cast<std::size_t>(face) + static_cast<std::size_t>(edge)];
  }

 private:
  /// One side of a solid.
  struct Side {
    std::array<Index, 4> key;  // corners ascending; a triangle has -1 first
    model::Segment face;
    std::int32_t group, element;  // in the mesh
  };
  template <class Wanted>
  std::vector<Side> sides_of(const Wanted& wanted) const;
  void add_outer(const model::Contact& contact, bool inner, std::span<const Index> parts);
  void add_listed(const model::Contact& contact, const model::ContactSide& side, bool orient,
                  deck::Diagnostics& diagnostics);
  void add_face(const model::Contact& contact, const model::Segment& segment, const Side& owner,
                std::int32_t twin);
  void add_shells(const model::Contact& contact, std::span<const Index> parts);
  void add_shell(const model::Contact& contact, std::size_t group, std::size_t element,
                 const model::Segment& side);
  std::int32_t number(model::Id key);
  void list_owned();
  void connect();
  void enter(Index node, std::int32_t face);
  void leave(Index node, std::int32_t face);
  void find_neighbours(std::int32_t face);

  /// Where the faces at a node are listed; rows that outgrow their room move to the end.
  struct Row {
    std::int32_t first = 0, count = 0, room = 0;
  };

  const discretisation::World& world_;
  double largest_offset_ = 0.0;
  std::vector<Face> faces_;
  std::vector<model::Id> elements_;  // owners of faces, by number; shells have a minus
  std::int64_t version_ = 0;
  std::vector<char> alive_;                        // [element]
  std::vector<char> here_;                         // [face] is it active?
  std::vector<std::int32_t> first_owned_, owned_;  // CSR of faces by element
  std::unordered_map<model::Id, std::int32_t> number_;
  std::vector<std::int32_t> active_, neighbour_;
  std::vector<Index> nodes_;
  std::vector<Row> rows_;           // [node]
  std::vector<std::int32_t> list_;  // active faces, row by row, ascending in each
};

}  // namespace cleave::solver
