#include "results/picture.hpp"

#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <system_error>

#include "results/files.hpp"

namespace cleave::results {
namespace {

struct Rectangle {
  double x, y, width, height;
};

/// The paper: cairo behind a few words.
class Paper {
 public:
  Paper(int width, int height)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height), cairo_surface_destroy),
        cairo_(cairo_create(surface_.get()), cairo_destroy) {
    cairo_set_source_rgb(cairo_.get(), 1, 1, 1);
    cairo_paint(cairo_.get());
    cairo_font_options_t* font = cairo_font_options_create();
    cairo_font_options_set_antialias(font, CAIRO_ANTIALIAS_GRAY);  // the same pixels on every screen
    cairo_font_options_set_hint_style(font, CAIRO_HINT_STYLE_NONE);
    cairo_set_font_options(cairo_.get(), font);
    cairo_font_options_destroy(font);
  }

  void text(double x, double y, const std::string& words, double size, double grey, bool bold = false,
            double align = 0.0) {
    cairo_select_font_face(cairo_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_.get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_.get(), words.c_str(), &extents);
    cairo_set_source_rgb(cairo_.get(), grey, grey, grey + 0.01);
    cairo_move_to(cairo_.get(), x - align * extents.x_advance, y);
    cairo_show_text(cairo_.get(), words.c_str());
  }

  void line(double x0, double y0, double x1, double y1, double width, Colour c) {
    cairo_set_source_rgb(cairo_.get(), c.red, c.green, c.blue);
    cairo_set_line_width(cairo_.get(), width);
    cairo_move_to(cairo_.get(), x0, y0);
    cairo_line_to(cairo_.get(), x1, y1);
    cairo_stroke(cairo_.get());
  }

  void fill(const Rectangle& box, Colour c) {
    cairo_set_source_rgb(cairo_.get(), c.red, c.green, c.blue);
    cairo_rectangle(cairo_.get(), box.x, box.y, box.width, box.height);
    cairo_fill(cairo_.get());
  }

  void image(const Raster& raster, double x, double y) {
    const auto picture = own(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, raster.width, raster.height));
    unsigned char* data = cairo_image_surface_get_data(picture.get());
    const int stride = cairo_image_surface_get_stride(picture.get());
    for (int row = 0; row < raster.height; ++row) {
      auto* out = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(row) * stride);
      for (int column = 0; column < raster.width; ++column) {
        const std::size_t p = static_cast<std::size_t>(row) * raster.width + column;
        const float a = raster.alpha[p];
        const auto byte = [](float v) { return static_cast<std::uint32_t>(std::lround(255.0f * v)); };
        out[column] = byte(a) << 24 | byte(a * raster.red[p]) << 16 | byte(a * raster.green[p]) << 8 |
                      byte(a * raster.blue[p]);
      }
    }
    cairo_surface_mark_dirty(picture.get());
    cairo_set_source_surface(cairo_.get(), picture.get(), x, y);
    cairo_paint(cairo_.get());
  }

  /// @return empty or cairo's words
  std::string write(const std::filesystem::path& file) {
    const cairo_status_t status = cairo_surface_write_to_png(surface_.get(), file.c_str());
    return status == CAIRO_STATUS_SUCCESS ? "" : cairo_status_to_string(status);
  }

 private:
  using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
  static Surface own(cairo_surface_t* surface) { return {surface, cairo_surface_destroy}; }

  Surface surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo_;
};

/// The colour bar with round numbers, and the range's own ends where they are not round.
void draw_colour_bar(Paper& paper, const Rectangle& bar, const Range& range, double unit) {
  const int steps = static_cast<int>(bar.height);
  for (int i = 0; i < steps; ++i)
    paper.fill({bar.x, bar.y + bar.height - i - 1.0, bar.width, 1.0}, colour_at((i + 0.5) / steps));
  const auto height_of = [&](double value) { return bar.y + bar.height * (1.0 - range.part(value)); };
  const auto mark = [&](double value, double grey) {
    const double y = height_of(value);
    const auto g = static_cast<float>(grey);
    paper.line(bar.x + bar.width, y, bar.x + bar.width + 0.35 * unit, y, 0.07 * unit, {g, g, g});
    paper.text(bar.x + bar.width + 0.65 * unit, y + 0.36 * unit, number_text(value), unit, grey);
  };
  mark(range.low, 0.10);
  mark(range.high, 0.10);
  for (const double tick : round_ticks(range, 8)) {
    const double room = 1.5 * unit;  // not over the numbers at the ends
    if (std::abs(height_of(tick) - height_of(range.low)) > room &&
        std::abs(height_of(tick) - height_of(range.high)) > room)
      mark(tick, 0.40);
  }
}

/// Small axes in the corner of a view; the one that points at the reader is drawn first, short.
void draw_axes(Paper& paper, const Camera& camera, const char* const (&names)[3], double x, double y,
               double length) {
  struct Axis {
    double end[3];
    const char* name;
    Colour colour;
  };
  std::array<Axis, 3> axes{{{{}, names[0], {0.78f, 0.24f, 0.22f}},
                            {{}, names[1], {0.22f, 0.55f, 0.25f}},
                            {{}, names[2], {0.20f, 0.38f, 0.75f}}}};
  for (int i = 0; i < 3; ++i) {
    const double unit[3] = {i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
    camera.turn(unit, axes[static_cast<std::size_t>(i)].end);
  }
  std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.end[2] < b.end[2]; });
  for (const Axis& axis : axes) {
    const double dx = axis.end[0] * length, dy = -axis.end[1] * length;
    if (std::hypot(dx, dy) < 0.15 * length) continue;
    paper.line(x, y, x + dx, y + dy, 0.06 * length, axis.colour);
    const double beyond = 1.0 + 0.3 * length / std::hypot(dx, dy);
    paper.text(x + dx * beyond, y + dy * beyond + 0.13 * length, axis.name, 0.38 * length, 0.25, false, 0.5);
  }
}

/// Where the views go: one large; two side by side; more in a column at the right of the first.
std::vector<Rectangle> place_views(std::size_t count, const Rectangle& area) {
  if (count == 1) return {area};
  if (count == 2) {
    const double half = 0.5 * area.width;
    return {{area.x, area.y, half, area.height}, {area.x + half, area.y, half, area.height}};
  }
  const double wide = std::floor(area.width * 0.66),
               tall = std::floor(area.height / (static_cast<double>(count) - 1.0));
  std::vector<Rectangle> places{{area.x, area.y, wide, area.height}};
  for (std::size_t i = 1; i < count; ++i)
    places.push_back(
        {area.x + wide, area.y + tall * (static_cast<double>(i) - 1.0), area.width - wide, tall});
  return places;
}

/// Points of the surface's faces, for the camera to fit.
std::vector<double> seen_points(const Surface& surface, std::span<const double> position) {
  std::vector<double> points;
  points.reserve(3 * surface.node.size());
  for (const model::Index node : surface.node)
    for (std::size_t i = 0; i < 3; ++i) points.push_back(position[3 * static_cast<std::size_t>(node) + i]);
  return points;
}

std::vector<View> automatic_views(std::span<const double> points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  for (std::size_t p = 0; p < points.size(); ++p) {
    low[p % 3] = std::min(low[p % 3], points[p]);
    high[p % 3] = std::max(high[p % 3], points[p]);
  }
  View side{.eye = {0, -1, 0}};
  if (high[2] - low[2] < 0.25 * (high[1] - low[1]))
    side = {.eye = {0, 0, 1}, .up = {0, 1, 0}};  // flat: from above
  return {three_quarter_view(low, high), side};
}

/// Values at the corners of faces, from elements or from nodes. [face][4]
std::vector<float> corner_values(const PictureModel& model, const Surface& surface, bool smooth) {
  std::vector<float> corners(4 * surface.count());
  if (!model.node_value.empty()) {
    for (std::size_t c = 0; c < corners.size(); ++c)
      corners[c] = model.node_value[static_cast<std::size_t>(surface.node[c])];
    return corners;
  }
  std::vector<float> face(surface.count());
  for (std::size_t f = 0; f < face.size(); ++f)
    face[f] = model.element_value[surface.block[f]][surface.element[f]];
  if (smooth) return corner_averages(surface, face, model.position.size() / 3);
  for (std::size_t c = 0; c < corners.size(); ++c) corners[c] = face[c / 4];
  return corners;
}

/// The body with those walls that show the eye their front, so that none hides what it holds back.
struct Scenery {
  Surface surface;
  std::vector<double> position;
  std::vector<float> normals, values;

  void add(const WallQuad& quad) {
    const model::Vector area = base::cross(quad[2] - quad[0], quad[3] - quad[1]);
    const double size = std::sqrt(base::dot(area, area));
    if (!(size > 0.0)) return;
    for (const model::Vector& corner : quad) {
      surface.node.push_back(static_cast<model::Index>(position.size() / 3));
      position.insert(position.end(), {corner.x, corner.y, corner.z});
      for (const double n : {area.x, area.y, area.z}) normals.push_back(static_cast<float>(n / size));
      values.push_back(std::numeric_limits<float>::quiet_NaN());  // grey
    }
    surface.edges.push_back(0);
    surface.block.push_back(0);
    surface.element.push_back(0);
  }
};

/// Faces of all walls near the body.
std::vector<WallQuad> quads_of(const std::vector<StandingWall>& walls) {
  std::vector<WallQuad> quads;
  for (const StandingWall& wall : walls) {
    const auto more = wall_quads(wall);
    quads.insert(quads.end(), more.begin(), more.end());
  }
  return quads;
}

}  // namespace

std::string write_picture(const PictureModel& model, const PictureOptions& options,
                          const std::filesystem::path& file) {
  Surface surface = model.surface ? *model.surface : outer_faces(model.cells, model.position.size() / 3);
  if (surface.count() == 0) return "no picture: the model has no active solid elements";
  if (!model.surface) orient_outwards(surface, model.cells, model.position);
  const std::vector<float> normals = corner_normals(surface, model.position);
  const std::vector<float> values = corner_values(model, surface, options.smooth);
  const std::vector<double> points = seen_points(surface, model.position);
  for (const double x : points)
    if (!std::isfinite(x)) return "no picture: a node has left for infinity";

  Drawing drawing{&surface, model.position, normals, values, options.range, options.edges, true};
  if (!(drawing.range.low < drawing.range.high)) {
    drawing.range = range_of(values);
    if (drawing.range.low > 0.0 && drawing.range.low < 0.1 * drawing.range.high) drawing.range.low = 0.0;
  }

  // All lengths of the layout are multiples of the text size.
  const double unit = std::max(9.0, std::min(options.width / 84.0, options.height / 50.0));
  Paper paper(options.width, options.height);
  paper.text(2.2 * unit, 3.3 * unit, options.title, 1.55 * unit, 0.08, true);
  paper.text(2.2 * unit, 5.5 * unit, options.field, 1.15 * unit, 0.30);
  paper.text(options.width - 2.2 * unit, 3.3 * unit, options.moment, 1.15 * unit, 0.30, false, 1.0);

  const double bar_width = 9.5 * unit, head = 7.0 * unit, foot = 1.5 * unit;
  const Rectangle area{1.0 * unit, head, options.width - bar_width - 2.0 * unit,
                       options.height - head - foot};
  const std::vector<View> views = options.views.empty() ? automatic_views(points) : options.views;
  const std::vector<Rectangle> places = place_views(views.size(), area);
  const std::vector<WallQuad> quads = quads_of(model.walls);
  std::vector<double> fitted = points;
  for (const WallQuad& quad : quads)
    for (const model::Vector& corner : quad) fitted.insert(fitted.end(), {corner.x, corner.y, corner.z});
  for (std::size_t v = 0; v < views.size(); ++v) {
    const int width = static_cast<int>(places[v].width), height = static_cast<int>(places[v].height);
    const Camera camera(views[v], fitted, width, height);
    Drawing seen = drawing;
    Scenery scenery;
    if (!quads.empty()) {
      scenery = {surface, {model.position.begin(), model.position.end()}, normals, values};
      const model::Vector eye{views[v].eye[0], views[v].eye[1], views[v].eye[2]};
      for (const WallQuad& quad : quads)
        if (base::dot(base::cross(quad[2] - quad[0], quad[3] - quad[1]), eye) > 0.0) scenery.add(quad);
      seen.surface = &scenery.surface;
      seen.position = scenery.position;
      seen.normals = scenery.normals;
      seen.value = scenery.values;
    }
    paper.image(draw(seen, camera, width, height), std::floor(places[v].x), std::floor(places[v].y));
    const double axis = std::min(2.6 * unit, 0.1 * std::min(width, height));
    draw_axes(paper, camera, options.axes, places[v].x + 1.3 * axis,
              places[v].y + places[v].height - 1.3 * axis, axis);
  }
  const double bar_height = std::min(0.72 * area.height, 36.0 * unit);
  draw_colour_bar(
      paper, {options.width - bar_width, area.y + 0.5 * (area.height - bar_height), 1.5 * unit, bar_height},
      drawing.range, unit);

  const std::filesystem::path partial = file.string() + std::string(unfinished_suffix);
  std::string problem = paper.write(partial);
  std::error_code error;
  if (problem.empty()) {
    std::filesystem::rename(partial, file, error);
    if (error) problem = error.message();
  }
  if (problem.empty()) return {};
  std::filesystem::remove(partial, error);  // a full disk leaves no half picture
  return "cannot write " + file.string() + ": " + problem;
}

}  // namespace cleave::results
