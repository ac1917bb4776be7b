#pragma once
/// Histories of a run directory, read back from their CSV files for the page.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cleave::results {

/// One history file: rows over time of the whole model, or of each of several entities.
struct HistoryTable {
  struct Entity {
    long long id = 0;                         ///< 0 for the whole model
    std::vector<std::vector<double>> column;  ///< [column][row]; column 0 is the time, then in file order
  };
  std::string name;                  ///< "glstat"
  std::vector<std::string> columns;  ///< "time", "cycle", ... ; "id" is not among them
  std::vector<Entity> entities;      ///< in order of first appearance
  std::size_t broken_rows = 0;       ///< rows with another number of cells than the header; left out

  std::size_t rows() const;  ///< of all entities
};

/// Reads NAME.csv: first line the header, then `time,cycle[,id],...`. A cell that is no number becomes NaN.
/// @return nothing when there is no such file or it has no rows
std::optional<HistoryTable> read_history(const std::filesystem::path& file);

/// Keeps every n-th row of each entity, and its last, so that the table has about `wanted` rows in all.
/// @return n; 1 when nothing was left out
std::size_t thin(HistoryTable& table, std::size_t wanted);

}  // namespace cleave::results
