#pragma once
/// What writers of .vtu files share: head, numbers, appended arrays.

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "discretisation/state.hpp"
#include "results/files.hpp"
#include "results/text.hpp"

namespace cleave::results {

static_assert(std::endian::native == std::endian::little, "the file head says LittleEndian");

/// Up to the first piece: an unstructured grid with its time and cycle.
inline std::string vtu_head(const discretisation::State& state) {
  std::string xml =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n";
  xml += "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">";
  append_shortest(xml, state.time);
  xml += "</DataArray>\n<DataArray type=\"Int64\" Name=\"cycle\" NumberOfTuples=\"1\" format=\"ascii\">";
  return xml + std::to_string(state.cycle) + "</DataArray>\n</FieldData>\n";
}
inline const char* const vtu_appended = "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
inline const char* const vtu_end = "\n</AppendedData>\n</VTKFile>\n";

/// Real numbers of a file: float64 if `doubles`, else float32.
struct VtuReal {
  bool doubles = false;
  const char* type() const { return doubles ? "Float64" : "Float32"; }
  std::size_t bytes() const { return doubles ? 8 : 4; }
  void write(WholeFile& file, double value) const {
    if (doubles) {
      file.write(&value, 8);
      return;
    }
    // Beyond the range of float32: the largest one, so that colour scales stay finite.
    constexpr double largest = 3.4e38;
    const float narrow =
        static_cast<float>(std::isfinite(value) ? std::clamp(value, -largest, largest) : value);
    file.write(&narrow, 4);
  }
};

/// Collects the arrays of the head while their sizes are added up, then streams the data in the same order.
class Arrays {
 public:
  using Fill = std::function<void(WholeFile&)>;

  void add(std::string& xml, const char* type, const std::string& name, int components, std::uint64_t bytes,
           Fill fill) {
    append_format(xml, "<DataArray type=\"%s\" Name=\"", type);
    for (const char c : name) xml += std::string_view("\"<>&").find(c) == std::string_view::npos ? c : '_';
    append_format(xml, "\" NumberOfComponents=\"%d\" format=\"appended\" offset=\"%llu\"/>\n", components,
                  static_cast<unsigned long long>(offset_));
    offset_ += bytes + sizeof(std::uint64_t);
    parts_.push_back({bytes, std::move(fill)});
  }
  void write(WholeFile& file) const {
    for (const auto& [bytes, fill] : parts_) {
      file.write(&bytes, sizeof bytes);
      fill(file);
    }
  }

 private:
  std::uint64_t offset_ = 0;
  std::vector<std::pair<std::uint64_t, Fill>> parts_;
};

}  // namespace cleave::results
