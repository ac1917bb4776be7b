#pragma once
/// The 3D view's data: outer faces of some frames, small enough to travel inside the page.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace cleave::results {

/// What the page gets: a description in JSON, and named blocks of bytes it refers to.
struct Scene {
  std::string json;                                         ///< empty when there is nothing to show
  std::vector<std::pair<std::string, std::string>> blocks;  ///< name, bytes
  std::vector<std::string> notes;                           ///< files left out, frames skipped
};

/// Reads result.pvd and its frames and keeps what is seen from outside.
///
/// Positions and values are 16-bit steps of the range over all frames (value 65535: no number): a step is
/// 1.5e-5 of the model's size, below a pixel. Frames are spread evenly in number, the first and the last
/// always among them; fewer than `max_frames` when their bytes would exceed `max_bytes`, but at least two.
/// Faces that stay the same from frame to frame are stored once.
///
///   scene.json: {low, high: [3], fields: [{name, on: "face" | "node", low, high}], topologies: [{block,
///   faces, nodes}], frames: [{time, topology, block}]} topology block: f64 element[faces], u32
///   node[faces][4], u8 edges[faces] frame block:    u16 position[nodes][3], then u16 value[faces or nodes]
///   of each field
Scene build_scene(const std::filesystem::path& run_directory, std::size_t max_frames, std::size_t max_bytes);

}  // namespace cleave::results
