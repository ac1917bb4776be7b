#pragma once
/// Stress intensity factors at the tips of cracks.

#include "discretisation/spacetime/observe.hpp"
#include "solver/solver.hpp"

namespace cleave::solver {

/// Tips of the cracks of a body: in the plane the ends of a crack inside the body, in space the nodes of its
/// rim. Their intensities come from how far the faces behind a tip have come apart.
///
/// With the displacement jump d across the crack at the distance r behind the tip, K_I = sqrt(2 pi/r) E'/8
/// d_n and so on in the limit r = 0 (Williams 1957). At a finite distance what the right-hand side gives is
/// K + B r + C/r: B r is the next term of the series, also of that in r/(c_d t) behind a wave front, and C/r
/// is the mesh, in which a tip acts as if it lay a small part C/K of an element off, since sqrt(r + 2 C/K) =
/// sqrt(r) (1 + (C/K)/r + ...). K is that of least squares.
template <int D>
class CrackTips {
 public:
  /// Tips between parts, or in anisotropic ones, are left out.
  CrackTips(const model::Model& model, const discretisation::spacetime::Body<D>& body);

  void fill(const discretisation::spacetime::Instant<D>& instant);
  std::span<const CrackTip> tips() const { return tips_; }

 private:
  using Simplex = discretisation::spacetime::Simplex;
  using Point = discretisation::spacetime::Point<D>;
  /// A place behind a tip, on both faces.
  struct Sample {
    Point place;
    Simplex above, below;  ///< on the side the normal of the tip points to, and on the other
    double weight;         ///< K is the sum of weight * modulus * jump [1/length^(1/2)]
  };
  struct Tip {
    std::vector<Sample> samples;
    double modulus[3];  ///< of opening, sliding and tearing: E'/8, E'/8, mu/4 [stress]
  };
  std::vector<Tip> tip_;
  std::vector<CrackTip> tips_;
};

}  // namespace cleave::solver
