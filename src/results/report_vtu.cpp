#include "results/report_vtu.hpp"

#include <charconv>
#include <cstring>
#include <optional>
#include <string_view>

#include "results/report_file.hpp"

namespace cleave::results {
namespace {

using model::Index;
using model::Shape;

/// Value of NAME="..." in a tag; empty when absent.
std::string_view attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    const std::size_t open = at + name.size();
    if (at == 0 || tag[at - 1] > ' ' || tag.substr(open, 2) != "=\"") continue;
    const std::size_t close = tag.find('"', open + 2);
    return close == std::string_view::npos ? "" : tag.substr(open + 2, close - open - 2);
  }
  return {};
}

template <class Number>
Number number(std::string_view text, Number otherwise) {
  Number value = otherwise;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Reads numbers of any stored type as another.
template <class To, class From>
void convert(const char* data, std::size_t count, std::vector<To>& out) {
  out.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    From value;
    std::memcpy(&value, data + i * sizeof(From), sizeof(From));
    out[i] = static_cast<To>(value);
  }
}

struct ArrayTag {
  std::string section, name, type;
  int components = 1;
  std::size_t offset = 0;
};

class Reader {
 public:
  explicit Reader(std::string bytes) : bytes_(std::move(bytes)) {}

  std::string read(VtuFrame& frame) {
    if (std::string wrong = read_head(); !wrong.empty()) return wrong;
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    for (const ArrayTag& tag : arrays_) {
      const bool points = tag.section == "Points", cells = tag.section == "Cells";
      std::string wrong;
      if (points)
        wrong = read_array(tag, frame.position);
      else if (cells && tag.name == "connectivity")
        wrong = read_array(tag, connectivity);
      else if (cells && tag.name == "offsets")
        wrong = read_array(tag, offsets);
      else if (cells && tag.name == "types")
        wrong = read_array(tag, types);
      else if (tag.name == "element_id")
        wrong = read_array(tag, frame.element_id);
      else if (tag.section == "PointData" || tag.section == "CellData")
        wrong = read_field(tag, frame);
      if (!wrong.empty()) return wrong;
    }
    if (frame.position.size() != 3 * points_ || types.size() != cells_ || offsets.size() != cells_)
      return "the numbers of points or cells disagree";
    if (frame.element_id.size() != cells_) {
      frame.element_id.resize(cells_);
      for (std::size_t c = 0; c < cells_; ++c) frame.element_id[c] = static_cast<double>(c + 1);
    }
    return group(connectivity, offsets, types, frame);
  }

 private:
  /// Finds the arrays and where the raw data begin.
  std::string read_head() {
    const std::string_view text = bytes_;
    const std::size_t appended = text.find("<AppendedData");
    if (appended == std::string_view::npos) return "it has no appended data";
    const std::string_view head = text.substr(0, appended);
    const std::size_t underscore = text.find('_', text.find('>', appended));
    if (underscore == std::string_view::npos || attribute(text.substr(appended, 80), "encoding") != "raw")
      return "its appended data are not raw";
    data_ = underscore + 1;
    std::string section;
    for (std::size_t at = head.find('<'); at != std::string_view::npos; at = head.find('<', at + 1)) {
      const std::string_view tag = head.substr(at + 1, head.find('>', at) - at - 1);
      const std::string_view name = tag.substr(0, tag.find_first_of(" \n\t/"));
      if (name == "VTKFile") {
        if (attribute(tag, "byte_order") == "BigEndian" || !attribute(tag, "compressor").empty())
          return "it is compressed or has big-endian numbers";
        long_sizes_ = attribute(tag, "header_type") == "UInt64";
      } else if (name == "Piece") {
        if (cells_ > 0) return "it has more than one piece";
        points_ = number<std::size_t>(attribute(tag, "NumberOfPoints"), 0);
        cells_ = number<std::size_t>(attribute(tag, "NumberOfCells"), 0);
      } else if (name == "PointData" || name == "CellData" || name == "Points" || name == "Cells") {
        section = name;
      } else if (name == "DataArray" && attribute(tag, "format") == "appended") {
        arrays_.push_back({section, std::string(attribute(tag, "Name")), std::string(attribute(tag, "type")),
                           number(attribute(tag, "NumberOfComponents"), 1),
                           number<std::size_t>(attribute(tag, "offset"), 0)});
      }
    }
    return "";
  }

  template <class To>
  std::string read_array(const ArrayTag& tag, std::vector<To>& out) const {
    const std::size_t word = long_sizes_ ? 8 : 4, begin = data_ + tag.offset;
    const auto cut = [&] { return "its array " + tag.name + " is cut short"; };
    if (begin + word > bytes_.size()) return cut();
    std::uint64_t size = 0;
    std::memcpy(&size, &bytes_[begin], word);
    if (size > bytes_.size() - begin - word) return cut();
    const char* data = bytes_.data() + begin + word;
    if (tag.type == "Float64") return convert<To, double>(data, size / 8, out), "";
    if (tag.type == "Float32") return convert<To, float>(data, size / 4, out), "";
    if (tag.type == "Int64" || tag.type == "UInt64")
      return convert<To, std::int64_t>(data, size / 8, out), "";
    if (tag.type == "Int32" || tag.type == "UInt32")
      return convert<To, std::int32_t>(data, size / 4, out), "";
    if (tag.type == "UInt8") return convert<To, std::uint8_t>(data, size, out), "";
    return "its array " + tag.name + " has numbers of type " + tag.type;
  }

  std::string read_field(const ArrayTag& tag, VtuFrame& frame) const {
    VtuFrame::Field field{tag.name, tag.components, tag.section == "CellData", {}};
    std::string wrong = read_array(tag, field.value);
    if (wrong.empty() &&
        field.value.size() != (field.on_cells ? cells_ : points_) * static_cast<std::size_t>(field.size))
      wrong = "its array " + tag.name + " has another length than the grid";
    frame.fields.push_back(std::move(field));
    return wrong;
  }

  /// Sorts the cells by shape and turns VTK's order of nodes into ours.
  std::string group(const std::vector<std::int64_t>& connectivity, const std::vector<std::int64_t>& offsets,
                    const std::vector<std::uint8_t>& types, VtuFrame& frame) const {
    struct Order {
      int type;  // vtkCellType.h
      Shape shape;
      int count;
      int node[10];
    };
    static constexpr Order orders[] = {
        {12, Shape::hex8, 8, {0, 1, 2, 3, 4, 5, 6, 7}},
        {14, Shape::hex8, 5, {0, 1, 2, 3, 4, 4, 4, 4}},  // a pyramid: its tip four times
        {13, Shape::penta6, 6, {0, 2, 1, 3, 5, 4}},      // VTK's first triangle points out, ours in
        {10, Shape::tet4, 4, {0, 1, 2, 3}},
        {24, Shape::tet10, 10, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}},
        {5, Shape::tri3, 3, {0, 1, 2}},
        {9, Shape::quad4, 4, {0, 1, 2, 3}}};
    for (const Shape shape :
         {Shape::hex8, Shape::penta6, Shape::tet4, Shape::tet10, Shape::tri3, Shape::quad4}) {
      VtuFrame::Group group{shape, {}, {}};
      for (std::size_t c = 0; c < types.size(); ++c) {
        for (const Order& order : orders) {
          if (order.type != types[c] || order.shape != shape) continue;
          const std::int64_t end = offsets[c], begin = end - order.count;
          if (begin < 0 || static_cast<std::size_t>(end) > connectivity.size())
            return "its connectivity is cut short";
          for (int a = 0; a < model::nodes_of(shape); ++a) {
            const std::int64_t node = connectivity[static_cast<std::size_t>(begin + order.node[a])];
            if (node < 0 || static_cast<std::size_t>(node) >= points_)
              return "a cell has a node that is not there";
            group.node.push_back(static_cast<Index>(node));
          }
          group.cell.push_back(static_cast<std::uint32_t>(c));
        }
      }
      if (!group.cell.empty()) frame.groups.push_back(std::move(group));
    }
    return "";
  }

  std::string bytes_;
  std::size_t data_ = 0, points_ = 0, cells_ = 0;
  bool long_sizes_ = false;
  std::vector<ArrayTag> arrays_;
};

}  // namespace

std::vector<SolidCells> VtuFrame::cells() const {
  std::vector<SolidCells> all;
  for (const Group& group : groups) all.push_back({group.shape, group.node, {}});
  return all;
}

std::vector<FrameFile> read_pvd(const std::filesystem::path& file) {
  std::vector<FrameFile> frames;
  const std::optional<std::string> text = read_whole(file);
  if (!text) return frames;
  const std::string_view all = *text;
  for (std::size_t at = all.find("<DataSet"); at != std::string_view::npos;
       at = all.find("<DataSet", at + 1)) {
    const std::string_view tag = all.substr(at, all.find('>', at) - at);
    frames.push_back({number(attribute(tag, "timestep"), 0.0), file.parent_path() / attribute(tag, "file")});
  }
  return frames;
}

std::string read_vtu(const std::filesystem::path& file, VtuFrame& frame) {
  std::optional<std::string> bytes = read_whole(file);
  if (!bytes) return "it cannot be read";
  frame = {};
  return Reader(std::move(*bytes)).read(frame);
}

}  // namespace cleave::results
