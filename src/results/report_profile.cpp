#include "results/report_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "results/report_encode.hpp"
#include "results/report_vtu.hpp"

namespace cleave::results {
namespace {

bool on_a_line(const VtuFrame& frame) {
  if (frame.position.size() < 6 || !frame.groups.empty()) return false;
  for (std::size_t i = 3; i < frame.position.size(); ++i)
    if (i % 3 != 0 && frame.position[i] != frame.position[i % 3]) return false;
  return true;
}

}  // namespace

Scene build_profiles(const std::filesystem::path& run_directory, std::size_t max_bytes) {
  Scene out;
  const std::vector<FrameFile> files = read_pvd(run_directory / "result.pvd");
  VtuFrame first;
  if (files.size() < 2 || !read_vtu(files.front().file, first).empty() || !on_a_line(first)) return out;
  const std::size_t points = first.position.size() / 3;
  std::vector<std::size_t> order(points);  // along x; where elements meet there are two, the left one first
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return first.position[3 * a] < first.position[3 * b];
  });
  std::erase_if(first.fields, [](const VtuFrame::Field& field) { return field.on_cells; });

  const std::size_t each = std::max<std::size_t>(1, 4 * points * first.fields.size());
  const std::size_t wanted = std::clamp<std::size_t>(max_bytes / each, 2, files.size());
  if (wanted < files.size())
    out.notes.push_back("The profiles show " + std::to_string(wanted) + " of " +
                        std::to_string(files.size()) + " frames, evenly spread.");
  std::vector<std::vector<float>> values(first.fields.size());
  std::string times;
  for (std::size_t i = 0; i < wanted; ++i) {
    const FrameFile& from = files[i * (files.size() - 1) / std::max<std::size_t>(wanted - 1, 1)];
    VtuFrame frame;
    std::string wrong = read_vtu(from.file, frame);
    if (wrong.empty() && frame.position.size() != first.position.size()) wrong = "it has other points";
    if (!wrong.empty()) {
      out.notes.push_back("The frame " + from.file.filename().string() + " is left out: " + wrong + ".");
      continue;
    }
    times += (times.empty() ? "" : ",") + json_number(from.time);
    for (std::size_t f = 0; f < values.size(); ++f) {
      const auto same = std::find_if(frame.fields.begin(), frame.fields.end(), [&](const auto& field) {
        return field.name == first.fields[f].name && !field.on_cells;
      });
      for (const std::size_t p : order)
        values[f].push_back(
            same == frame.fields.end() ? NAN : same->value[p * static_cast<std::size_t>(same->size)]);
    }
  }

  std::vector<float> x;
  x.reserve(points);
  for (const std::size_t p : order) x.push_back(static_cast<float>(first.position[3 * p]));
  std::string bytes;
  append_bytes(bytes, x);
  out.blocks.emplace_back("profile-x", std::move(bytes));
  std::string fields;
  for (std::size_t f = 0; f < values.size(); ++f) {
    float low = INFINITY, high = -INFINITY;
    for (const float v : values[f])
      if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
    fields += (f ? "," : "") + ("{\"name\":" + json_text(first.fields[f].name)) +
              ",\"low\":" + json_number(low) + ",\"high\":" + json_number(high) + "}";
    std::string block;
    append_bytes(block, values[f]);
    out.blocks.emplace_back("profile-" + first.fields[f].name, std::move(block));
  }
  out.json =
      "{\"points\":" + std::to_string(points) + ",\"times\":[" + times + "],\"fields\":[" + fields + "]}";
  return out;
}

}  // namespace cleave::results
