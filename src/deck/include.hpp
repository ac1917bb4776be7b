#pragma once
/// Where included files are looked for, and the transforms laid on them.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "deck/deck.hpp"

namespace cleave::deck {

/// The folders of one file, in the order in which they are tried.
struct SearchPath {
  std::filesystem::path main_folder;
  std::vector<std::filesystem::path>
      paths;  ///< *INCLUDE_PATH, *INCLUDE_PATH_RELATIVE, those of the parent first
};

/// Finds a file named in a deck: main folder, search paths, folder of the including file; then again with
/// `\` taken as `/`. Empty if it is nowhere; `tried` lists the folders.
std::filesystem::path find_include(std::string_view name, const SearchPath& search,
                                   const std::filesystem::path& including_folder,
                                   std::vector<std::string>& tried);

/// What *INCLUDE_TRANSFORM says, combined with the transform `outer` of the file that holds it: offsets add,
/// factors multiply. Reports fields that are not honoured.
IncludeTransform read_transform(const Card& card, const IncludeTransform& outer, int outer_index,
                                Diagnostics& diagnostics);

}  // namespace cleave::deck
