#pragma once
/// Fields along a line, instant by instant: what the page draws of bodies in one dimension.

#include <cstddef>
#include <filesystem>

#include "results/report_scene.hpp"

namespace cleave::results {

/// Reads result.pvd and the frames whose points all lie on one line along x.
///
/// Frames are spread evenly in number, the first and the last always among them, so that their bytes stay
/// within `max_bytes`; a note says when some were left out. Vectors are given by their component along x. The
/// json is empty when the run has no such frame.
///
///   json: {points, times: [], fields: [{name, low, high}]}
///   block profile-x: f32 x[points], ascending; block profile-NAME: f32 value[frame][points]
Scene build_profiles(const std::filesystem::path& run_directory, std::size_t max_bytes);

}  // namespace cleave::results
