#pragma once
/// How high the next tent at a vertex is, and where its top stands.

#include <limits>
#include <string>

#include "discretisation/spacetime/front.hpp"
#include "discretisation/spacetime/progress.hpp"
#include "discretisation/spacetime/star_shapes.hpp"

namespace cleave::discretisation::spacetime {

struct PitchOptions {
  double chi = 0.95;  ///< fraction of the characteristic slope, (0, 1]; facets at 1 make solvers singular [-]
  Progress progress = Progress::subsimplex;
  double eps = 0.1;                                             ///< of the progress constraint, (0, 1/2] [-]
  double height_factor = 1.0;                                   ///< of the allowed height, (0, 1] [-]
  double height_cap = std::numeric_limits<double>::infinity();  ///< of any tent [time]
  double smoothing = 0.0;  ///< fraction of the way to the mean of its neighbours a vertex moves per tent [-]
  /// Where most stars of the mesh are alike, tops stand on a lattice of times, up to a few
  /// tenths below what is allowed: then tents are alike too, and their patches share what geometry decides.
  bool repeat = false;
  double quality_floor = 0.1;  ///< moved simplices worse than this, and than before, are refused [-]
};

/// What is wrong with the options in D dimensions; empty when nothing is.
template <int D>
std::string complaint(const PitchOptions& options);

/// A tent pole.
template <int D>
struct Pole {
  Vertex vertex = -1;
  Event<D> foot, top;
  bool inclined = false;
  const StarShape<D>* shape = nullptr;  ///< of a vertical pole, where tents repeat
  double height() const { return top[D] - foot[D]; }
};

/// Const and without scratch: any number of threads may pitch vertices that are not neighbours.
template <int D>
class Pitcher {
 public:
  /// Options must pass complaint(); asserts otherwise. The mesh must outlive the pitcher.
  Pitcher(const SpaceMesh<D>& mesh, const PitchOptions& options);

  const SpaceMesh<D>& mesh() const { return mesh_; }
  const PitchOptions& options() const { return options_; }

  /// A level front over the undeformed mesh. [time]
  Front<D> level_front(double time) const;
  /// Do tents repeat?
  bool repeats() const { return kept_ < 1.0; }

  Key key(const Front<D>& front, Vertex v) const {
    return {front.time[static_cast<std::size_t>(v)], mesh_.rank(v)};
  }
  /// Is the key of v less than those of all its neighbours?
  bool lowest(const Front<D>& front, Vertex v) const;

  /// The tent at v, which must be lowest among its neighbours and earlier than end_time. Its top is end_time
  /// exactly, or far enough from it to leave room for another tent of fair height. The pole is inclined if
  /// options().smoothing asks for it and all checks pass, at full or at 1/2 .. 1/16 of the displacement; else
  /// vertical. A result with height() 0 is a stall, which the progress constraints exclude.
  Pole<D> pitch(const Front<D>& front, Vertex v, double end_time) const;
  /// As above with the wanted displacement of the pole's top given [length].
  Pole<D> pitch_towards(const Front<D>& front, Vertex v, double end_time, Point<D> displacement) const;

  /// Moves the front to the top of the pole.
  void commit(Front<D>& front, const Pole<D>& pole) const;

  /// What v is sure to gain once it is lowest, on the present geometry [time].
  double sure_gain(const Front<D>& front, Vertex v) const;
  /// Largest ratio of a slope of the front over simplex s to its bound; at most 1 but for rounding.
  double strain_on_bounds(const Front<D>& front, Simplex s) const;

 private:
  Cell<D> cell(const Front<D>& front, Simplex s) const;
  std::size_t corner_of(Simplex s, Vertex v) const;
  double limit(const Front<D>& front, Vertex v) const;
  double top_time(double foot, double limit, double end_time) const;
  bool incline(const Front<D>& front, double end_time, double vertical_height, const Point<D>& displacement,
               Pole<D>& pole) const;

  const SpaceMesh<D>& mesh_;
  PitchOptions options_;
  StarShapes<D> shapes_;
  double kept_ = 1.0;     ///< least part of the allowed height that a top on the lattice keeps; 1: no lattice
  double lattice_ = 0.0;  ///< its unit; steps are this times powers of two [time]
};

}  // namespace cleave::discretisation::spacetime
