#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/assert.hpp"
#include "results/picture_raster.hpp"

namespace cleave::results {
namespace {

double dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
void cross(const double* a, const double* b, double* out) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}
void make_unit(double* a) {
  const double length = std::sqrt(dot(a, a));
  CLEAVE_ASSERT(length > 0.0, "a view needs a direction, and up must not be along it");
  for (int i = 0; i < 3; ++i) a[i] /= length;
}

}  // namespace

View three_quarter_view(std::span<const double, 3> low, std::span<const double, 3> high) {
  const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
  const double flatness = z / std::max({x, y, 1e-300});
  const double elevation = flatness < 0.25 ? 42.0 : 24.0;
  const double azimuth = x >= y ? -62.0 : -28.0;
  const double degree = std::numbers::pi / 180.0;
  return {.eye = {std::cos(elevation * degree) * std::cos(azimuth * degree),
                  std::cos(elevation * degree) * std::sin(azimuth * degree), std::sin(elevation * degree)}};
}

Camera::Camera(const View& view, std::span<const double> points, int width, int height, double margin) {
  CLEAVE_ASSERT(!points.empty(), "nothing to look at");
  double* right = axis_[0];
  double* up = axis_[1];
  double* towards = axis_[2];
  std::copy_n(view.eye, 3, towards);
  make_unit(towards);
  cross(view.up, towards, right);
  make_unit(right);
  cross(towards, right, up);

  // The middle and the radius of the points, then a first projection that is scaled to fit.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low[3] = {infinity, infinity, infinity}, high[3] = {-infinity, -infinity, -infinity};
  for (std::size_t p = 0; p < points.size(); ++p) {
    low[p % 3] = std::min(low[p % 3], points[p]);
    high[p % 3] = std::max(high[p % 3], points[p]);
  }
  double radius = 0.0;
  for (int i = 0; i < 3; ++i) {
    centre_[i] = 0.5 * (low[i] + high[i]);
    radius += 0.25 * (high[i] - low[i]) * (high[i] - low[i]);
  }
  radius = std::sqrt(radius);
  if (view.opening > 0.0 && radius > 0.0)
    distance_ = 1.05 * radius / std::sin(0.5 * view.opening * std::numbers::pi / 180.0);

  double left = infinity, rightmost = -infinity, top = infinity, bottom = -infinity;
  for (std::size_t p = 0; p < points.size(); p += 3) {
    const Pixel pixel = project(&points[p]);
    left = std::min(left, pixel.x);
    rightmost = std::max(rightmost, pixel.x);
    top = std::min(top, pixel.y);
    bottom = std::max(bottom, pixel.y);
  }
  const double room = 1.0 - 2.0 * margin;
  const double wide = rightmost - left, tall = bottom - top;
  if (wide > 0.0 || tall > 0.0)
    scale_ = room * std::min(wide > 0.0 ? width / wide : infinity, tall > 0.0 ? height / tall : infinity);
  offset_[0] = 0.5 * width - scale_ * 0.5 * (left + rightmost);
  offset_[1] = 0.5 * height - scale_ * 0.5 * (top + bottom);
}

Camera::Pixel Camera::project(const double* point) const {
  const double from_centre[3] = {point[0] - centre_[0], point[1] - centre_[1], point[2] - centre_[2]};
  const double height = dot(axis_[2], from_centre);
  const double w = distance_ > 0.0 ? 1.0 - height / distance_ : 1.0;
  return {offset_[0] + scale_ * dot(axis_[0], from_centre) / w,
          offset_[1] - scale_ * dot(axis_[1], from_centre) / w, -height, w};
}

void Camera::turn(const double* direction, double* out) const {
  for (int i = 0; i < 3; ++i) out[i] = dot(axis_[i], direction);
}

}  // namespace cleave::results
