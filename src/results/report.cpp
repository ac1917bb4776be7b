#include "results/report.hpp"

#include <optional>
#include <string_view>
#include <system_error>

#include "results/files.hpp"
#include "results/picture_colour.hpp"
#include "results/report_encode.hpp"
#include "results/report_file.hpp"
#include "results/report_history.hpp"
#include "results/report_page.hpp"
#include "results/report_profile.hpp"
#include "results/report_scene.hpp"

namespace cleave::results {
namespace {

namespace fs = std::filesystem;

constexpr const char* history_names[] = {"glstat", "matsum", "nodout", "crack",  "crack_tip",
                                         "elout",  "rwforc", "rbdout", "spcforc"};
constexpr const char* picture_names[] = {"initial", "picture"};

/// `<` occurs in JSON only inside strings, where the escape means the same and cannot end a script element.
std::string harmless(std::string_view json) {
  std::string out;
  for (const char c : json) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

std::string script(std::string_view id, std::string_view type, std::string_view content) {
  return "<script id=\"" + std::string(id) + "\" type=\"" + std::string(type) + "\">" + std::string(content) +
         "</script>\n";
}

/// The page's data, element by element: JSON for words, base64 for blocks of numbers.
class Data {
 public:
  void json(std::string_view id, std::string_view text) {
    text_ += script("data-" + std::string(id), "application/json", text);
  }
  void block(std::string_view id, std::string_view bytes) {
    text_ += script("data-" + std::string(id), "text/plain", base64(bytes));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Histories: `histories` lists tables; block `history-NAME` holds for each entity its times as f64 [row] and
/// then the other columns as f32 [column][row], each entity padded to eight bytes.
void add_histories(Data& data, const fs::path& directory, std::size_t max_bytes,
                   std::vector<std::string>& notes) {
  std::vector<HistoryTable> tables;
  std::size_t values = 0;
  for (const char* name : history_names) {
    std::optional<HistoryTable> table = read_history(directory / (std::string(name) + ".csv"));
    if (!table) continue;
    if (table->broken_rows > 0)
      notes.push_back(std::to_string(table->broken_rows) + " incomplete rows of " + table->name +
                      ".csv are left out.");
    values += table->rows() * table->columns.size();
    tables.push_back(std::move(*table));
  }
  if (tables.empty()) notes.push_back("There are no histories: the run directory has none of the CSV files.");

  const double share = static_cast<double>(max_bytes) / (4.0 * static_cast<double>(values) + 1.0);
  std::string list;
  for (HistoryTable& table : tables) {
    if (share < 1.0) {
      const std::size_t stride =
          thin(table, static_cast<std::size_t>(share * static_cast<double>(table.rows())));
      if (stride > 1)
        notes.push_back("Plots of " + table.name + " show every " + std::to_string(stride) + "th row.");
    }
    std::string bytes, entities, columns;
    for (const HistoryTable::Entity& entity : table.entities) {
      entities += (entities.empty() ? "" : ",") + ("{\"id\":" + std::to_string(entity.id)) +
                  ",\"rows\":" + std::to_string(entity.column.front().size()) + "}";
      append_bytes(bytes, entity.column.front());
      for (std::size_t c = 1; c < entity.column.size(); ++c)
        append_bytes(bytes, std::vector<float>(entity.column[c].begin(), entity.column[c].end()));
      bytes.resize((bytes.size() + 7) / 8 * 8);
    }
    for (const std::string& name : table.columns) columns += (columns.empty() ? "" : ",") + json_text(name);
    list += (list.empty() ? "" : ",") + ("{\"name\":" + json_text(table.name)) + ",\"columns\":[" + columns +
            "],\"entities\":[" + entities + "]}";
    data.block("history-" + table.name, bytes);
  }
  data.json("histories", "[" + list + "]");
}

void add_pictures(Data& data, const fs::path& directory) {
  std::string list;
  for (const char* name : picture_names) {
    const std::optional<std::string> bytes = read_whole(directory / (std::string(name) + ".png"));
    if (!bytes) continue;
    data.block("image-" + std::string(name), *bytes);
    list += (list.empty() ? "" : ",") + json_text(name);
  }
  data.json("pictures", "[" + list + "]");
}

void add_colours(Data& data) {
  std::string list;
  for (const std::uint32_t colour : colour_table())
    list += (list.empty() ? "" : ",") + std::to_string(colour);
  data.json("colours", "[" + list + "]");
}

/// Fills in each mark once, from the left; the filling is not searched again.
std::string fill(std::string_view form,
                 std::initializer_list<std::pair<std::string_view, std::string_view>> fillings) {
  std::string out;
  for (const auto& [name, text] : fillings) {
    const std::size_t at = form.find(name);
    (out += form.substr(0, at)) += text;
    form.remove_prefix(at + name.size());
  }
  return out += form;
}

}  // namespace

ReportOutcome write_report(const fs::path& run_directory, const ReportOptions& options) {
  ReportOutcome outcome;
  outcome.page = run_directory / "report.html";
  std::error_code error;
  if (!fs::is_directory(run_directory, error)) {
    outcome.message = run_directory.string() + " is not a directory; give the directory of a run";
    return outcome;
  }
  const std::optional<std::string> summary = read_whole(run_directory / "summary.json");
  if (!summary && !fs::exists(run_directory / "glstat.csv") && !fs::exists(run_directory / "result.pvd")) {
    outcome.message =
        run_directory.string() +
        " holds no run: it has none of summary.json, glstat.csv and result.pvd; give the directory "
        "that `cleave run` wrote";
    return outcome;
  }
  if (!summary) outcome.notes.push_back("summary.json is missing: the run goes on, or was killed.");
  Data data;
  data.json("summary", summary ? harmless(*summary) : "null");
  add_histories(data, run_directory, options.max_history_bytes, outcome.notes);
  // What lies on a line has profiles, everything else a view in space.
  const Scene profiles = build_profiles(run_directory, options.max_scene_bytes);
  const Scene scene = profiles.json.empty()
                          ? build_scene(run_directory, options.max_frames, options.max_scene_bytes)
                          : Scene{};
  for (const auto& [name, from] : {std::pair{"profiles", &profiles}, std::pair{"scene", &scene}}) {
    outcome.notes.insert(outcome.notes.end(), from->notes.begin(), from->notes.end());
    data.json(name, from->json.empty() ? "null" : from->json);
    for (const auto& [block, bytes] : from->blocks) data.block(block, bytes);
  }
  add_pictures(data, run_directory);
  add_colours(data);
  std::string notes;
  for (const std::string& note : outcome.notes) notes += (notes.empty() ? "" : ",") + json_text(note);
  data.json("notes", "[" + notes + "]");

  const std::string page = fill(
      page_html(),
      {{"<!-- style -->", page_style()}, {"<!-- data -->", data.text()}, {"<!-- script -->", page_script()}});
  if (const std::string problem = write_whole(outcome.page, page); !problem.empty())
    outcome.message = "cannot write " + outcome.page.string() + ": " + problem;
  outcome.ok = outcome.message.empty();
  return outcome;
}

}  // namespace cleave::results
