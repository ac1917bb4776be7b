#include "results/picture.hpp"

#include <cairo.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>

#include "picture_meshes.hpp"

namespace cleave::results {
namespace {

/// The outer faces of a mesh with everything a drawing needs, all of one value.
struct Scene {
  explicit Scene(const test::TestMesh& from) : mesh(from) {
    const SolidCells cells[] = {mesh.cells()};
    surface = outer_faces(cells, mesh.node_count());
    normals = corner_normals(surface, mesh.position);
    value.assign(4 * surface.count(), 0.5f);
  }
  Drawing drawing() const { return {&surface, mesh.position, normals, value, {0, 1}, true, true}; }

  test::TestMesh mesh;
  Surface surface;
  std::vector<float> normals, value;
};

double covered(const Raster& raster) {
  return std::accumulate(raster.alpha.begin(), raster.alpha.end(), 0.0);
}

TEST(Raster, SquareCoversItsPixelsExactly) {
  const Scene scene(test::cubes(3, 3, 3));
  const View from_above{.eye = {0, 0, 1}, .up = {0, 1, 0}};
  // Margin 1/8 on each side of 80 pixels leaves a square of 60; its sides lie on pixel boundaries.
  const Camera camera(from_above, scene.mesh.position, 80, 80, 0.125);
  const Raster raster = draw(scene.drawing(), camera, 80, 80);
  EXPECT_DOUBLE_EQ(covered(raster), 60.0 * 60.0);
  EXPECT_EQ(raster.alpha[9 * 80 + 40], 0.0f);
  EXPECT_EQ(raster.alpha[10 * 80 + 40], 1.0f);
}

TEST(Raster, NeighboursLeaveNoGap) {
  // One sheet of squares, so that a gap shows the background; sizes whose sides meet samples inexactly.
  Scene scene(test::cubes(40, 24, 1));
  const Surface all = scene.surface;
  Surface sheet;
  for (std::size_t f = 0; f < all.count(); ++f) {
    const model::Index* n = &all.node[4 * f];
    if (!std::all_of(n, n + 4,
                     [&](auto k) { return scene.mesh.position[3 * static_cast<std::size_t>(k) + 2] == 1.0; }))
      continue;
    sheet.node.insert(sheet.node.end(), n, n + 4);
    sheet.edges.push_back(all.edges[f]);
    sheet.block.push_back(0);
    sheet.element.push_back(all.element[f]);
  }
  ASSERT_EQ(sheet.count(), 960u);
  scene.surface = sheet;
  scene.normals = corner_normals(sheet, scene.mesh.position);
  for (int width = 200; width < 260; width += 7) {
    const int height = width * 3 / 5;
    const View view{.eye = {0, 0, 1}, .up = {0, 1, 0}};
    const Raster raster =
        draw(scene.drawing(), Camera(view, scene.mesh.position, width, height, 0.06), width, height);
    const int border = width / 8;
    for (int row = border; row < height - border; ++row)
      for (int column = border; column < width - border; ++column)
        ASSERT_EQ(raster.alpha[static_cast<std::size_t>(row) * width + column], 1.0f)
            << width << ' ' << row << ' ' << column;
  }
}

TEST(Raster, HexagonOfTheCubeSeenAlongItsDiagonal) {
  const Scene scene(test::cubes(1, 1, 1));
  const View diagonal{.eye = {1, 1, 1}};
  const Camera camera(diagonal, scene.mesh.position, 400, 400, 0.05);
  // The silhouette is a regular hexagon, corners up and down: 360 pixels tall, side 180.
  const double area = 1.5 * std::numbers::sqrt3 * 180.0 * 180.0;
  EXPECT_NEAR(covered(draw(scene.drawing(), camera, 400, 400)), area, 2e-3 * area);
}

TEST(Raster, SphereCoversItsDisc) {
  const Scene scene(test::ball(24));
  for (const double opening : {0.0, 30.0}) {
    const View view{.eye = {0.3, -1.0, 0.5}, .opening = opening};
    const Camera camera(view, scene.mesh.position, 400, 400, 0.1);
    const double area = std::numbers::pi * 160.0 * 160.0;
    EXPECT_NEAR(covered(draw(scene.drawing(), camera, 400, 400)), area, 5e-3 * area) << opening;
  }
}

TEST(Raster, PerspectiveShrinksWhatIsFar) {
  const auto mesh = test::cubes(1, 1, 1);
  const Camera camera({.eye = {0, -1, 0}, .opening = 40.0}, mesh.position, 100, 100);
  const auto width_at = [&](double y) {
    const double left[3] = {0.0, y, 0.5}, right[3] = {1.0, y, 0.5};
    return camera.project(right).x - camera.project(left).x;
  };
  // The eye stands where the ball around the cube, with a margin of 5 %, fills the opening.
  const double eye = 1.05 * 0.5 * std::numbers::sqrt3 / std::sin(20.0 * std::numbers::pi / 180.0);
  EXPECT_NEAR(width_at(0.0) / width_at(1.0), (eye + 0.5) / (eye - 0.5), 1e-12);
}

TEST(Raster, NearerFaceHidesTheFarther) {
  Scene scene(test::cubes(1, 1, 1));
  for (std::size_t f = 0; f < scene.surface.count(); ++f) {
    double z = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
      z += scene.mesh.position[3 * static_cast<std::size_t>(scene.surface.node[4 * f + k]) + 2] / 4.0;
    for (std::size_t k = 0; k < 4; ++k) scene.value[4 * f + k] = z == 1.0 ? 1.0f : 0.0f;
  }
  Drawing drawing = scene.drawing();
  drawing.edges = drawing.outlines = false;
  for (const double side : {1.0, -1.0}) {
    const View view{.eye = {0, 0, side}, .up = {0, 1, 0}};
    const Raster raster = draw(drawing, Camera(view, scene.mesh.position, 20, 20), 20, 20);
    const std::size_t middle = 10 * 20 + 10;
    // viridis is yellow at its upper end, violet at its lower.
    EXPECT_EQ(raster.red[middle] > raster.blue[middle], side > 0.0);
  }
}

TEST(Raster, MeshLinesFadeWhenElementsAreAsSmallAsPixels) {
  const auto darkest = [](int n) {
    const Scene scene(test::cubes(n, n, 1));
    Drawing drawing = scene.drawing();
    drawing.outlines = false;
    const View view{.eye = {0, 0, 1}, .up = {0, 1, 0}};
    const Raster r = draw(drawing, Camera(view, scene.mesh.position, 100, 100), 100, 100);
    float least = 1.0f;
    for (std::size_t p = 0; p < r.alpha.size(); ++p)
      if (r.alpha[p] == 1.0f) least = std::min(least, r.green[p]);
    return least;
  };
  EXPECT_LT(darkest(4), 0.7f * darkest(90));
}

TEST(Colours, LightnessGrowsEvenly) {
  // CIE 1976 lightness from sRGB.
  const auto lightness = [](double t) {
    const Colour c = colour_at(t);
    const auto linear = [](double v) {
      return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    const double y = 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
    return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
  };
  const double mean = (lightness(1.0) - lightness(0.0)) / 64.0;
  EXPECT_GT(mean, 1.0);
  for (int i = 0; i < 64; ++i) {
    const double step = lightness((i + 1) / 64.0) - lightness(i / 64.0);
    EXPECT_GT(step, 0.6 * mean) << i;
    EXPECT_LT(step, 1.4 * mean) << i;
  }
  EXPECT_EQ(colour_at(-3.0).red, colour_at(0.0).red);
  EXPECT_EQ(colour_at(7.0).red, colour_at(1.0).red);
  const Colour none = colour_at(std::nan(""));
  EXPECT_EQ(none.red, none.green);
}

TEST(Colours, RangeAndTicksAreRound) {
  const float values[] = {1.0f, std::nanf(""), -2.0f, 4.0f, INFINITY};
  EXPECT_EQ(range_of(values).low, -2.0);
  EXPECT_EQ(range_of(values).high, 4.0);
  const float zeros[] = {0.0f, 0.0f};
  EXPECT_EQ(range_of(zeros).low, 0.0);
  EXPECT_LT(range_of(zeros).low, range_of(zeros).high);
  EXPECT_LT(range_of({}).low, range_of({}).high);

  EXPECT_EQ(round_ticks({0.0, 1.0}, 5), (std::vector<double>{0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0}));
  for (const Range range : {Range{-3e-7, 8e-7}, Range{1e9, 1.7e9}, Range{0.013, 2.91}}) {
    const auto ticks = round_ticks(range, 8);
    EXPECT_GE(ticks.size(), 4u);
    EXPECT_LE(ticks.size(), 10u);
    EXPECT_GE(ticks.front(), range.low);
    EXPECT_LE(ticks.back(), range.high * (1 + 1e-12));
  }
}

class PictureFile : public testing::Test {
 protected:
  PictureFile()
      : directory(std::filesystem::temp_directory_path() / ("cleave_picture_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(directory);
  }
  ~PictureFile() override { std::filesystem::remove_all(directory); }
  std::filesystem::path directory;
};

TEST_F(PictureFile, IsReadBackWithTheColoursOfTheField) {
  const auto mesh = test::mushroom(8, 40, 1.0, 10.0, 0.9);
  const SolidCells cells[] = {mesh.cells()};
  PictureModel model{.cells = cells, .position = mesh.position};
  model.element_value.emplace_back(mesh.node.size() / 8);
  for (std::size_t e = 0; e < mesh.node.size() / 8; ++e)
    model.element_value[0][e] = static_cast<float>(2.7 * std::exp(-static_cast<double>(e / 64) / 9.0));
  PictureOptions options;
  options.title = "A bar";
  const auto file = directory / "picture.png";
  ASSERT_EQ(write_picture(model, options, file), "");

  cairo_surface_t* image = cairo_image_surface_create_from_png(file.c_str());
  ASSERT_EQ(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
  ASSERT_EQ(cairo_image_surface_get_width(image), options.width);
  ASSERT_EQ(cairo_image_surface_get_height(image), options.height);
  const unsigned char* data = cairo_image_surface_get_data(image);
  int white = 0, coloured = 0;
  for (int p = 0; p < options.width * options.height; ++p) {
    const unsigned char* bgr = data + 4 * p;
    const auto [low, high] = std::minmax({bgr[0], bgr[1], bgr[2]});
    white += low == 255;
    coloured += high - low > 40;
  }
  cairo_surface_destroy(image);
  EXPECT_GT(white, options.width * options.height / 3);
  EXPECT_GT(coloured, options.width * options.height / 20);
  EXPECT_FALSE(std::filesystem::exists(directory / "picture.png.part"));
}

TEST_F(PictureFile, FailureSaysWhy) {
  const PictureModel nothing{};
  PictureOptions small;
  small.width = 320;
  small.height = 200;
  EXPECT_NE(write_picture(nothing, small, directory / "a.png").find("no active solid"), std::string::npos);

  auto mesh = test::cubes(1, 1, 1);
  const SolidCells cells[] = {mesh.cells()};
  PictureModel model{.cells = cells, .position = mesh.position};
  model.element_value = {{1.0f}};
  EXPECT_NE(write_picture(model, small, directory / "none" / "a.png").find("cannot write"),
            std::string::npos);
  mesh.position[0] = NAN;
  EXPECT_NE(write_picture(model, small, directory / "a.png").find("infinity"), std::string::npos);
}

}  // namespace
}  // namespace cleave::results
