#pragma once
/// Pictures of the deformed model as PNG files, drawn without a display or a graphics card.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "results/picture_raster.hpp"
#include "results/surface.hpp"
#include "results/wall_quads.hpp"

namespace cleave::results {

/// A mesh and one field on it. Give values per element or per node; the other is empty.
struct PictureModel {
  std::span<const SolidCells> cells;
  std::span<const double> position;                 ///< [node][3] [length]
  std::vector<std::vector<float>> element_value{};  ///< [block][element]
  std::vector<float> node_value{};                  ///< [node]
  const Surface* surface = nullptr;                 ///< shown in place of the outer faces of `cells`
  std::vector<StandingWall> walls{};                ///< drawn grey, from the side they stop bodies on
};

struct PictureOptions {
  int width = 1600, height = 1000;  ///< [pixels]
  std::string title;                ///< of the model
  std::string field;                ///< what the colours show, e.g. "effective plastic strain"
  std::string moment;               ///< e.g. "t = 8.0e-05, cycle 2413"
  std::vector<View> views;          ///< the first is drawn largest; empty: three-quarter view and side view
  Range range{0.0, 0.0};  ///< of the colours; low = high: that of the values, from 0 if it nearly does
  bool smooth = true;     ///< element values averaged at nodes, else one colour per face
  bool edges = true;
  const char* axes[3] = {"x", "y", "z"};  ///< their names
};

/// Draws the outer faces of a mesh with colour bar, text and axes, and writes them to a PNG file (to a
/// temporary name first, then renamed).
/// @return empty, or what went wrong: nothing to draw, or the file cannot be written
std::string write_picture(const PictureModel& model, const PictureOptions& options,
                          const std::filesystem::path& file);

}  // namespace cleave::results
