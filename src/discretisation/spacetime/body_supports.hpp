#pragma once
/// Which directions of a face are held or moved: from supports and motions of nodes to faces.
///
/// A face is held along a direction when all its nodes are. The velocity there is that of the condition all
/// of them share; where they share none, it is linear between those of the nodes, as on the side of a finite
/// element.

#include <map>
#include <vector>

#include "discretisation/spacetime/body_motion.hpp"
#include "discretisation/spacetime/body_steps.hpp"

namespace cleave::discretisation::spacetime {

/// Sum of coefficients times histories: a velocity. [length/time]
template <int D>
using VelocityTerms = std::map<int, Vector<D>>;

template <int D>
struct HeldFace {
  Matrix<D> projector{};                       ///< on the held directions
  int held = 0;                                ///< their number
  bool uniform = true;                         ///< all vertices move alike
  std::array<VelocityTerms<D>, D> velocity{};  ///< by vertex of the face, as asked for
  bool moves() const;
};

template <int D>
class Supports {
 public:
  Supports(const model::Model& model, const std::vector<Vertex>& vertex_of_node, std::size_t vertex_count,
           deck::Diagnostics& diagnostics);

  /// Conditions of a boundary face; errors where two of them contradict each other.
  /// @param vertex of the mesh before cracks were opened
  HeldFace<D> of_face(const std::array<Vertex, D>& vertex);
  /// What makes faces alike: numbers of the conditions of their vertices.
  std::vector<int> key(const std::array<Vertex, D>& vertex) const;
  /// Errors for conditions at nodes that hold no face. Call when all faces have been asked for.
  void report_unused(const std::vector<char>& on_boundary, const std::vector<std::int64_t>& vertex_id);

  const std::vector<History>& histories() const { return histories_; }

 private:
  /// "The velocity along d is that of history h", or zero.
  struct Row {
    Vector<D> direction{};
    int history = -1;
    int condition = 0;  ///< index into conditions_
  };
  struct Condition {
    std::string keyword;
    deck::Place place;
  };
  /// Orthonormal directions with the velocity along each, as a sum over histories.
  struct Span {
    std::array<Vector<D>, D> axis{};
    std::array<std::map<int, double>, D> value{};
    int count = 0;
    /// False if the row depends on those before but asks for another velocity.
    bool add(const Row& row);
    Matrix<D> projector() const;
    VelocityTerms<D> velocity() const;
  };

  void add(const std::vector<model::Index>& nodes, const model::Vector& direction, int history,
           int condition);
  void add_motion(const model::Model& model, const model::PrescribedMotion& motion);
  void add_fixed(const model::FixedNodes& fixed);
  const std::vector<int>& rows_at(Vertex v) const { return rows_of_[static_cast<std::size_t>(v)]; }
  const Row& row(int r) const { return rows_[static_cast<std::size_t>(r)]; }

  const std::vector<Vertex>& vertex_of_node_;
  double end_time_;
  deck::Diagnostics& diagnostics_;
  std::vector<Condition> conditions_;
  std::vector<Row> rows_;
  std::vector<History> histories_;
  std::vector<std::vector<int>> rows_of_;  ///< [vertex], in order of precedence
  std::vector<std::vector<char>> used_;    ///< the same shape: did the row help to hold a face?
};

}  // namespace cleave::discretisation::spacetime
