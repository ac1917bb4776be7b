#pragma once
/// One self-contained HTML page of a run directory: opens from disk, needs no network.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace cleave::results {

struct ReportOptions {
  std::size_t max_frames = 20;                ///< states of the 3D view, first and last always among them
  std::size_t max_scene_bytes = 24u << 20;    ///< of the 3D view before encoding; fewer frames to keep it
  std::size_t max_history_bytes = 24u << 20;  ///< of the histories before encoding; rows thinned to keep it
};

struct ReportOutcome {
  bool ok = false;
  std::filesystem::path page;  ///< RUN/report.html
  std::string message;         ///< why there is no page, and what to do
  std::vector<std::string>
      notes;  ///< what the page does not show, or shows thinned; they are on the page too
};

/// Writes RUN/report.html from what the run directory holds: summary.json, the histories as CSV, the fields
/// (result.pvd with its .vtu files) and the pictures. A file that is missing or cannot be read leaves its
/// section out and gives a note. Fails when the directory holds no run at all or the page cannot be written.
ReportOutcome write_report(const std::filesystem::path& run_directory, const ReportOptions& options = {});

}  // namespace cleave::results
