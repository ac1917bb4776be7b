#include "results/report_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "results/picture_colour.hpp"
#include "results/report_encode.hpp"
#include "results/report_vtu.hpp"
#include "results/surface_cells.hpp"

namespace cleave::results {
namespace {

constexpr std::uint16_t no_number = 65535;
constexpr double steps = 65534.0;
constexpr std::size_t max_fields = 8;

/// The surface of one frame with its own nodes only.
struct Skin {
  double time = 0.0;
  std::vector<double> element;      // [face] id
  std::vector<std::uint32_t> node;  // [face][4], nodes of the skin
  std::vector<std::uint8_t> edges;  // [face]
  std::vector<double> position;     // [node][3]
  struct Field {
    std::string name;
    bool on_faces = false;
    std::vector<float> value;
  };
  std::vector<Field> fields;

  bool same_faces(const Skin& other) const {
    return element == other.element && node == other.node && edges == other.edges;
  }
};

bool is_id(const VtuFrame::Field& field) {
  return field.name == "part_id" || field.name == "node_id";
}

/// Plain scalars, and lengths of vectors of points; ids are no fields.
bool is_shown(const VtuFrame::Field& field) {
  if (field.size == 1) return !is_id(field);
  return !field.on_cells && field.size == 3 && (field.name == "displacement" || field.name == "velocity");
}

/// The more telling field comes first in the menu.
int rank(const std::string& name) {
  static constexpr const char* order[] = {
      "effective_plastic_strain", "max_shear_stress", "von_mises", "pressure", "displacement", "velocity"};
  const auto* at = std::find(std::begin(order), std::end(order), name);
  return static_cast<int>(at - std::begin(order));
}

Skin skin_of(const VtuFrame& frame, double time) {
  const std::vector<SolidCells> cells = frame.cells();
  // Points without a node's number belong to their cell alone.
  const bool own_points = std::none_of(frame.fields.begin(), frame.fields.end(),
                                       [](const auto& field) { return field.name == "node_id"; });
  Surface surface = own_points ? outer_faces_by_place(cells, frame.position)
                               : outer_faces(cells, frame.position.size() / 3);
  orient_outwards(surface, cells, frame.position);

  Skin skin;
  skin.time = time;
  skin.edges = surface.edges;
  std::vector<std::uint32_t> cell(surface.count());
  for (std::size_t f = 0; f < surface.count(); ++f) {
    cell[f] = frame.groups[surface.block[f]].cell[surface.element[f]];
    skin.element.push_back(frame.element_id[cell[f]]);
  }
  constexpr std::uint32_t unseen = 0xffffffffu;
  std::vector<std::uint32_t> seen_as(frame.position.size() / 3, unseen), point;
  for (const model::Index n : surface.node) {
    std::uint32_t& as = seen_as[static_cast<std::size_t>(n)];
    if (as == unseen) {
      as = static_cast<std::uint32_t>(point.size());
      point.push_back(static_cast<std::uint32_t>(n));
      for (std::size_t i = 0; i < 3; ++i)
        skin.position.push_back(frame.position[3 * static_cast<std::size_t>(n) + i]);
    }
    skin.node.push_back(as);
  }
  for (const VtuFrame::Field& field : frame.fields) {
    if (!is_shown(field)) continue;
    Skin::Field shown{field.name, field.on_cells, {}};
    if (field.on_cells)
      for (const std::uint32_t c : cell) shown.value.push_back(field.value[c]);
    else
      for (const std::uint32_t p : point)
        shown.value.push_back(
            field.size == 1 ? field.value[p]
                            : std::hypot(field.value[3 * p], field.value[3 * p + 1], field.value[3 * p + 2]));
    skin.fields.push_back(std::move(shown));
  }
  std::stable_sort(skin.fields.begin(), skin.fields.end(),
                   [](const auto& a, const auto& b) { return rank(a.name) < rank(b.name); });
  if (skin.fields.size() > max_fields) skin.fields.resize(max_fields);
  return skin;
}

std::size_t bytes_of(const Skin& skin) {
  std::size_t bytes = 2 * skin.position.size();
  for (const Skin::Field& field : skin.fields) bytes += 2 * field.value.size();
  return bytes;
}

/// `wanted` numbers out of 0 .. count-1, evenly spread, first and last among them.
std::vector<std::size_t> spread(std::size_t count, std::size_t wanted) {
  std::vector<std::size_t> chosen;
  wanted = std::min(count, std::max<std::size_t>(wanted, 2));
  for (std::size_t i = 0; i < wanted; ++i) chosen.push_back(wanted > 1 ? i * (count - 1) / (wanted - 1) : 0);
  return chosen;
}

std::uint16_t quantum(double value, const Range& range) {
  if (!std::isfinite(value)) return no_number;
  return static_cast<std::uint16_t>(std::lround(steps * std::clamp(range.part(value), 0.0, 1.0)));
}

/// Reads the frames to show; the size of the last one decides how many fit.
std::vector<Skin> read_skins(const std::filesystem::path& directory, std::size_t max_frames,
                             std::size_t max_bytes, std::vector<std::string>& notes) {
  const std::vector<FrameFile> files = read_pvd(directory / "result.pvd");
  std::vector<Skin> skins;
  if (files.empty()) {
    notes.push_back("There is no 3D view: result.pvd is missing or lists no frame.");
    return skins;
  }
  const auto read = [&](const FrameFile& from) {
    VtuFrame frame;
    const std::string wrong = read_vtu(from.file, frame);
    if (wrong.empty()) return skin_of(frame, from.time);
    notes.push_back("The frame " + from.file.filename().string() + " is left out: " + wrong + ".");
    return Skin{};
  };
  Skin last = read(files.back());
  const std::size_t each = std::max<std::size_t>(bytes_of(last), 1);
  const std::vector<std::size_t> chosen = spread(files.size(), std::min(max_frames, max_bytes / each));
  if (chosen.size() < files.size())
    notes.push_back("The 3D view shows " + std::to_string(chosen.size()) + " of " +
                    std::to_string(files.size()) + " frames, evenly spread.");
  for (const std::size_t number : chosen) {
    Skin skin;
    if (number + 1 == files.size())
      std::swap(skin, last);  // read already
    else
      skin = read(files[number]);
    if (!skin.edges.empty()) skins.push_back(std::move(skin));
  }
  return skins;
}

struct Ranges {
  Range axis[3];
  std::vector<Range> field;
};

/// Over all frames. Fields are those of the last frame; one that a frame lacks has no numbers there.
Ranges ranges_of(const std::vector<Skin>& skins) {
  Ranges ranges;
  for (std::size_t i = 0; i < 3; ++i) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Skin& skin : skins)
      for (std::size_t p = i; p < skin.position.size(); p += 3) {
        if (!std::isfinite(skin.position[p])) continue;
        low = std::min(low, skin.position[p]);
        high = std::max(high, skin.position[p]);
      }
    ranges.axis[i] = low < high ? Range{low, high} : Range{low, low + 1.0};
  }
  for (std::size_t f = 0; f < skins.back().fields.size(); ++f) {
    std::vector<float> ends;
    for (const Skin& skin : skins)
      if (f < skin.fields.size())
        for (const float value : skin.fields[f].value)
          if (std::isfinite(value)) ends.push_back(value);
    ranges.field.push_back(range_of(ends));
  }
  return ranges;
}

std::string frame_bytes(const Skin& skin, const Ranges& ranges, const std::vector<Skin::Field>& fields) {
  std::vector<std::uint16_t> numbers;
  for (std::size_t p = 0; p < skin.position.size(); ++p)
    numbers.push_back(quantum(skin.position[p], ranges.axis[p % 3]));
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const std::size_t count = fields[f].on_faces ? skin.edges.size() : skin.position.size() / 3;
    const bool known = f < skin.fields.size() && skin.fields[f].name == fields[f].name;
    for (std::size_t i = 0; i < count; ++i)
      numbers.push_back(known ? quantum(skin.fields[f].value[i], ranges.field[f]) : no_number);
  }
  std::string bytes;
  append_bytes(bytes, numbers);
  return bytes;
}

}  // namespace

Scene build_scene(const std::filesystem::path& run_directory, std::size_t max_frames, std::size_t max_bytes) {
  Scene scene;
  const std::vector<Skin> skins = read_skins(run_directory, max_frames, max_bytes, scene.notes);
  if (skins.empty()) return scene;
  const Ranges ranges = ranges_of(skins);

  std::string topologies, frames, fields;
  std::size_t topology_count = 0;
  for (std::size_t i = 0; i < skins.size(); ++i) {
    const Skin& skin = skins[i];
    if (i == 0 || !skin.same_faces(skins[i - 1])) {
      const std::string name = "topology-" + std::to_string(topology_count++);
      std::string bytes;
      append_bytes(bytes, skin.element);
      append_bytes(bytes, skin.node);
      append_bytes(bytes, skin.edges);
      scene.blocks.emplace_back(name, std::move(bytes));
      topologies += (topologies.empty() ? "" : ",") + ("{\"block\":\"" + name) +
                    "\",\"faces\":" + std::to_string(skin.edges.size()) +
                    ",\"nodes\":" + std::to_string(skin.position.size() / 3) + "}";
    }
    const std::string name = "frame-" + std::to_string(i);
    scene.blocks.emplace_back(name, frame_bytes(skin, ranges, skins.back().fields));
    frames += (frames.empty() ? "" : ",") + ("{\"time\":" + json_number(skin.time)) +
              ",\"topology\":" + std::to_string(topology_count - 1) + ",\"block\":\"" + name + "\"}";
  }
  for (std::size_t f = 0; f < ranges.field.size(); ++f) {
    const Skin::Field& field = skins.back().fields[f];
    fields += (fields.empty() ? "" : ",") + ("{\"name\":" + json_text(field.name)) + ",\"on\":\"" +
              (field.on_faces ? "face" : "node") + "\",\"low\":" + json_number(ranges.field[f].low) +
              ",\"high\":" + json_number(ranges.field[f].high) + "}";
  }
  const auto corner = [&](auto member) {
    std::string text = "[";
    for (int i = 0; i < 3; ++i) text += (i ? "," : "") + json_number(ranges.axis[i].*member);
    return text + "]";
  };
  scene.json = "{\"low\":" + corner(&Range::low) + ",\"high\":" + corner(&Range::high) + ",\"fields\":[" +
               fields + "],\"topologies\":[" + topologies + "],\"frames\":[" + frames + "]}";
  return scene;
}

}  // namespace cleave::results
