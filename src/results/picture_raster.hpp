#pragma once
/// Triangles to pixels without a graphics card: camera, z-buffer, shading, mesh lines, outlines.

#include <cstdint>
#include <span>
#include <vector>

#include "results/picture_colour.hpp"
#include "results/surface.hpp"

namespace cleave::results {

/// From where the body is seen.
struct View {
  double eye[3] = {0.5, -0.8, 0.4};  ///< direction from the body to the eye, any length [-]
  double up[3] = {0, 0, 1};          ///< points up in the picture [-]
  double opening = 0.0;              ///< full angle of view [degrees]; 0: parallel projection
};

/// Three-quarter view for a body of these extents: z up, the larger side towards the eye, flat bodies from
/// higher up.
View three_quarter_view(std::span<const double, 3> low, std::span<const double, 3> high);

/// Points of the body to pixels: x to the right, y down, depth grows away from the eye.
class Camera {
 public:
  /// Looks at points [n][3] so that all of them are inside the picture, with a margin (part of its size).
  Camera(const View& view, std::span<const double> points, int width, int height, double margin = 0.05);

  struct Pixel {
    double x, y, depth;  ///< [pixels], [pixels], [length]
    double w;            ///< distance from the eye; 1 in parallel projection
  };
  Pixel project(const double* point) const;
  /// A direction of the body in the picture's axes: right, up, towards the eye.
  void turn(const double* direction, double* out) const;

 private:
  double axis_[3][3];  ///< right, up, towards the eye
  double centre_[3];
  double distance_ = 0.0;  ///< eye to centre; 0: parallel
  double scale_ = 1.0;     ///< pixels per length in the plane through the centre
  double offset_[2] = {0.0, 0.0};
};

/// What one picture shows: a surface and its colours.
struct Drawing {
  const Surface* surface = nullptr;
  std::span<const double> position;  ///< [node][3] [length]
  std::span<const float> normals;    ///< [face][4][3], of corner_normals
  std::span<const float> value;      ///< [face][4] at corners
  Range range;
  bool edges = true;     ///< lines of the mesh; they fade where elements come near the size of a pixel
  bool outlines = true;  ///< lines where the body ends or folds over itself
};

/// Pixels, [row][column]; colour is not multiplied by alpha, which is the covered part of the pixel.
struct Raster {
  int width = 0, height = 0;
  std::vector<float> red, green, blue, alpha;
};

/// Draws into width x height pixels, each the mean of 2 x 2 samples.
/// Sample centres lie at half pixels; a sample belongs to the triangle whose interior or top-left side holds
/// it, so neighbours leave no gap. Deterministic: faces are drawn in order, the nearer wins, the earlier at
/// equal depth.
Raster draw(const Drawing& drawing, const Camera& camera, int width, int height);

}  // namespace cleave::results
