#pragma once
/// Faces of solids that no second element shares.

#include <span>

#include "model/mesh.hpp"

namespace cleave::model {

/// Outer faces of the given parts taken together (empty: all parts), in order of element group, element and
/// face; counter-clockwise seen from outside, triangles repeat the third node. A triangle on a quadrilateral
/// is outer.
std::vector<Segment> outer_faces(const Mesh& mesh, std::span<const Index> parts);

}  // namespace cleave::model
