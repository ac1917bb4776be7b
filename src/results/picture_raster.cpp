#include "results/picture_raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace cleave::results {
namespace {

constexpr int fine = 2;  // samples per pixel in each direction
constexpr std::uint32_t nobody = 0xffffffffu;

/// Light from beside the eye: enough shape to read, colours stay near those of the colour bar.
/// Normals may point either way. @param n  normal in the picture's axes
double brightness(const double* n) {
  const double facing = std::abs(n[2]);
  const double side = (n[2] < 0.0 ? -1.0 : 1.0) * (0.55 * n[1] - 0.45 * n[0]);
  return std::clamp(0.54 + 0.40 * facing + 0.24 * side, 0.32, 1.08);
}

/// A corner of a face as the rasteriser uses it, in samples.
struct Corner {
  double x, y, depth, w;
  double value, light;
};

struct Canvas {
  int width, height;
  std::vector<float> depth;
  std::vector<std::uint32_t> face;  // which face is seen, nobody where there is none
  std::vector<Colour> colour;

  Canvas(int wide, int tall)
      : width(wide),
        height(tall),
        depth(static_cast<std::size_t>(wide) * tall, std::numeric_limits<float>::infinity()),
        face(depth.size(), nobody),
        colour(depth.size(), Colour{1, 1, 1}) {}
};

/// How dark the lines of a face are: they fade as its sides come near the size of a sample.
double line_strength(const std::array<Corner, 4>& c) {
  const double area =
      0.5 * std::abs((c[2].x - c[0].x) * (c[3].y - c[1].y) - (c[3].x - c[1].x) * (c[2].y - c[0].y));
  const double size = std::sqrt(area) / fine;
  return 0.55 * std::clamp((size - 2.5) / 14.0, 0.0, 1.0);
}

/// Darkness of the mesh lines at a sample: 1 on a side of the element, falling to 0 within a pixel.
double line_cover(const std::array<Corner, 4>& c, unsigned edges, bool triangle, double x, double y) {
  double cover = 0.0;
  const int sides = triangle ? 3 : 4;
  for (int k = 0; k < sides; ++k) {
    if (!((edges >> k) & 1u)) continue;
    const Corner &a = c[k], &b = c[(k + 1) % sides];
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    if (length == 0.0) continue;
    const double distance = std::abs((x - a.x) * dy - (y - a.y) * dx) / length;
    cover = std::max(cover, std::clamp(1.35 - distance / fine * 1.6, 0.0, 1.0));
  }
  return cover;
}

/// Fills one triangle (corners i j k of a face).
void fill(Canvas& canvas, const Drawing& drawing, std::uint32_t face, const std::array<Corner, 4>& c, int i,
          int j, int k, double strength, bool triangle) {
  const Corner* corner[3] = {&c[i], &c[j], &c[k]};
  const double twice_area = (corner[1]->x - corner[0]->x) * (corner[2]->y - corner[0]->y) -
                            (corner[2]->x - corner[0]->x) * (corner[1]->y - corner[0]->y);
  if (twice_area == 0.0 || !std::isfinite(twice_area)) return;
  if (twice_area < 0.0) std::swap(corner[1], corner[2]);
  const auto clip = [](double v, int size) { return static_cast<int>(std::clamp<double>(v, 0.0, size)); };
  const auto [x_low, x_high] = std::minmax({corner[0]->x, corner[1]->x, corner[2]->x});
  const auto [y_low, y_high] = std::minmax({corner[0]->y, corner[1]->y, corner[2]->y});
  const int left = clip(std::ceil(x_low - 0.5), canvas.width),
            right = clip(std::floor(x_high + 0.5), canvas.width);
  const int top = clip(std::ceil(y_low - 0.5), canvas.height),
            bottom = clip(std::floor(y_high + 0.5), canvas.height);

  // Area coordinates, each from the side opposite a corner; a sample on a side belongs to one neighbour only.
  double step_x[3], step_y[3], constant[3];
  bool keeps_side[3];
  for (int s = 0; s < 3; ++s) {
    const Corner &a = *corner[(s + 1) % 3], &b = *corner[(s + 2) % 3];
    step_x[s] = -(b.y - a.y);
    step_y[s] = b.x - a.x;
    // From the same end for both triangles beside it, so that theirs differ in sign only and leave no gap.
    const Corner& end = std::tie(a.x, a.y) < std::tie(b.x, b.y) ? a : b;
    constant[s] = -(step_x[s] * end.x + step_y[s] * end.y);
    keeps_side[s] = step_x[s] > 0.0 || (step_x[s] == 0.0 && step_y[s] > 0.0);
  }
  for (int row = top; row < bottom; ++row) {
    for (int column = left; column < right; ++column) {
      const double x = column + 0.5, y = row + 0.5;
      double part[3];
      bool inside = true;
      for (int s = 0; s < 3; ++s) {
        part[s] = constant[s] + step_x[s] * x + step_y[s] * y;
        inside = inside && (part[s] > 0.0 || (part[s] == 0.0 && keeps_side[s]));
      }
      if (!inside) continue;
      double depth = 0.0, value = 0.0, light = 0.0, weight = 0.0;
      for (int s = 0; s < 3; ++s) {
        const double share = part[s] / corner[s]->w;  // right in perspective too
        depth += share * corner[s]->depth;
        value += share * corner[s]->value;
        light += share * corner[s]->light;
        weight += share;
      }
      const std::size_t pixel = static_cast<std::size_t>(row) * canvas.width + column;
      depth /= weight;
      if (!(static_cast<float>(depth) < canvas.depth[pixel])) continue;
      canvas.depth[pixel] = static_cast<float>(depth);
      canvas.face[pixel] = face;
      Colour colour = colour_at(drawing.range.part(value / weight));
      double shade = light / weight;
      if (strength > 0.0)
        shade *= 1.0 - strength * line_cover(c, drawing.surface->edges[face], triangle, x, y);
      const auto lit = [shade](float v) { return static_cast<float>(std::min(1.0, v * shade)); };
      canvas.colour[pixel] = {lit(colour.red), lit(colour.green), lit(colour.blue)};
    }
  }
}

/// Darkens samples where the body ends or where one part of it hides another: lines a pixel wide.
void draw_outlines(Canvas& canvas, double fold) {
  const auto at = [&](int row, int column) { return static_cast<std::size_t>(row) * canvas.width + column; };
  std::vector<std::uint8_t> line(canvas.depth.size(), 0);
  for (int row = 0; row < canvas.height; ++row) {
    for (int column = 0; column < canvas.width; ++column) {
      const std::size_t here = at(row, column);
      if (canvas.face[here] == nobody) continue;
      constexpr int beside[8][2] = {{0, 1}, {0, -1}, {1, 0}, {-1, 0}, {0, 2}, {0, -2}, {2, 0}, {-2, 0}};
      for (const auto& [down, along] : beside) {
        const int r = row + down, c = column + along;
        const bool off = r < 0 || c < 0 || r >= canvas.height || c >= canvas.width;
        // The nearer side of a fold carries the line.
        if (off || canvas.face[at(r, c)] == nobody || canvas.depth[at(r, c)] > canvas.depth[here] + fold)
          line[here] = 1;
      }
    }
  }
  for (std::size_t p = 0; p < line.size(); ++p) {
    if (!line[p]) continue;
    Colour& c = canvas.colour[p];
    c = {c.red * 0.35f, c.green * 0.35f, c.blue * 0.38f};
  }
}

/// Each pixel is the mean of its samples.
Raster average(const Canvas& canvas) {
  Raster raster;
  raster.width = canvas.width / fine;
  raster.height = canvas.height / fine;
  const std::size_t count = static_cast<std::size_t>(raster.width) * raster.height;
  for (auto* plane : {&raster.red, &raster.green, &raster.blue, &raster.alpha}) plane->assign(count, 0.0f);
  for (int row = 0; row < raster.height; ++row) {
    for (int column = 0; column < raster.width; ++column) {
      Colour sum;
      int covered = 0;
      for (int s = 0; s < fine * fine; ++s) {
        const std::size_t sample =
            static_cast<std::size_t>(fine * row + s / fine) * canvas.width + fine * column + s % fine;
        if (canvas.face[sample] == nobody) continue;
        ++covered;
        sum.red += canvas.colour[sample].red;
        sum.green += canvas.colour[sample].green;
        sum.blue += canvas.colour[sample].blue;
      }
      if (covered == 0) continue;
      const std::size_t pixel = static_cast<std::size_t>(row) * raster.width + column;
      const float n = static_cast<float>(covered);
      raster.red[pixel] = sum.red / n;
      raster.green[pixel] = sum.green / n;
      raster.blue[pixel] = sum.blue / n;
      raster.alpha[pixel] = n / (fine * fine);
    }
  }
  return raster;
}

}  // namespace

Raster draw(const Drawing& drawing, const Camera& camera, int width, int height) {
  Canvas canvas(fine * width, fine * height);
  const Surface& surface = *drawing.surface;
  double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
  for (std::uint32_t f = 0; f < surface.count(); ++f) {
    std::array<Corner, 4> corner;
    for (int k = 0; k < 4; ++k) {
      const std::size_t at = 4 * static_cast<std::size_t>(f) + k;
      const Camera::Pixel p =
          camera.project(&drawing.position[3 * static_cast<std::size_t>(surface.node[at])]);
      const float* n = &drawing.normals[3 * at];
      const double normal[3] = {n[0], n[1], n[2]};
      double seen[3];
      camera.turn(normal, seen);
      corner[k] = {fine * p.x, fine * p.y, p.depth, p.w, drawing.value[at], brightness(seen)};
      if (std::isfinite(p.depth)) {
        nearest = std::min(nearest, p.depth);
        farthest = std::max(farthest, p.depth);
      }
    }
    const bool triangle = surface.node[4 * static_cast<std::size_t>(f) + 3] ==
                          surface.node[4 * static_cast<std::size_t>(f) + 2];
    const double strength = drawing.edges ? line_strength(corner) : 0.0;
    fill(canvas, drawing, f, corner, 0, 1, 2, strength, triangle);
    if (!triangle) fill(canvas, drawing, f, corner, 0, 2, 3, strength, triangle);
  }
  if (drawing.outlines && nearest < farthest) draw_outlines(canvas, 0.04 * (farthest - nearest));
  return average(canvas);
}

}  // namespace cleave::results
