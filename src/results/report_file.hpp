#pragma once
/// Whole files into memory.

#include <filesystem>
#include <optional>
#include <string>

namespace cleave::results {

/// All bytes of a file; nothing when it cannot be read.
std::optional<std::string> read_whole(const std::filesystem::path& file);

}  // namespace cleave::results
