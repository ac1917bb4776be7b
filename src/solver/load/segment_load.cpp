/// *LOAD_SEGMENT: pressure on the faces where they are now, positive into the body.

#include "base/threads.hpp"
#include "solver/face.hpp"
#include "solver/load/kinds.hpp"

namespace cleave::solver {
namespace {

using model::SegmentLoad;

class FacePressure final : public Load {
 public:
  FacePressure(const model::Model& model, const SegmentLoad& load)
      : model_(model), load_(load), vectors_(load.segments.size()), quadratic_(load.quadratic.size()) {}

  std::vector<Index> nodes() const override {
    std::vector<Index> all;
    for (const model::Segment& face : load_.segments) all.insert(all.end(), face.node, face.node + 4);
    for (const auto& face : load_.quadratic) all.insert(all.end(), face.begin(), face.end());
    return all;
  }

  void add_force(const Moment& now, std::span<double> force) override {
    if (now.time < load_.arrival) return;
    // The curve starts when the pressure arrives.
    const model::Curve& curve = model_.curves[static_cast<std::size_t>(load_.curve)];
    const double pressure = load_.scale * load_value(curve, now.time - load_.arrival, now.step);
    if (pressure == 0.0) return;

    // Geometry in parallel; the sum in the order of the faces, so that its bits never change.
    base::for_each_range(vectors_.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) vectors_[f] = face_vectors(load_.segments[f], now.position);
    });
    base::for_each_range(quadratic_.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        quadratic_[f] = face_vectors(load_.quadratic[f], now.position);
    });
    const auto add = [&](Index node, const model::Vector& area) {
      double* at = &force[3 * static_cast<std::size_t>(node)];
      at[0] -= pressure * area.x;
      at[1] -= pressure * area.y;
      at[2] -= pressure * area.z;
    };
    for (std::size_t f = 0; f < vectors_.size(); ++f)
      for (std::size_t a = 0; a < 4; ++a) add(load_.segments[f].node[a], vectors_[f][a]);
    for (std::size_t f = 0; f < quadratic_.size(); ++f)
      for (std::size_t a = 0; a < 6; ++a) add(load_.quadratic[f][a], quadratic_[f][a]);
  }

 private:
  const model::Model& model_;
  const SegmentLoad& load_;
  std::vector<std::array<model::Vector, 4>> vectors_;    // [face], scratch
  std::vector<std::array<model::Vector, 6>> quadratic_;  // [face], scratch
};

}  // namespace

void add_segment_loads(const model::Model& model, LoadList& list) {
  for (const SegmentLoad& load : model.segment_loads)
    list.push_back(std::make_unique<FacePressure>(model, load));
}

}  // namespace cleave::solver
