#pragma once
/// Field files of a run directory, read back for the page: result.pvd and the .vtu files it lists.

#include <filesystem>
#include <string>
#include <vector>

#include "results/surface.hpp"

namespace cleave::results {

/// One line of result.pvd.
struct FrameFile {
  double time = 0.0;
  std::filesystem::path file;
};

/// Lists the frames of a .pvd file in its order; empty when it is missing.
std::vector<FrameFile> read_pvd(const std::filesystem::path& file);

/// The solid cells of one .vtu file.
struct VtuFrame {
  struct Field {
    std::string name;
    int size = 1;
    bool on_cells = false;
    std::vector<float> value;  ///< [point or cell][size]
  };
  struct Group {  ///< cells of one shape
    model::Shape shape = model::Shape::hex8;
    std::vector<model::Index> node;   ///< [element][nodes_of(shape)], points
    std::vector<std::uint32_t> cell;  ///< [element] number of the cell in the file
  };
  std::vector<double> position;  ///< [point][3] [length]
  std::vector<Group> groups;
  std::vector<double> element_id;  ///< [cell]; its number from 1 when the file has no element_id
  std::vector<Field> fields;

  std::vector<SolidCells> cells() const;
};

/// Reads an unstructured grid of one piece with raw appended, uncompressed, little-endian data, as the field
/// files of this program are. @return empty, or what is wrong with the file
std::string read_vtu(const std::filesystem::path& file, VtuFrame& frame);

}  // namespace cleave::results
