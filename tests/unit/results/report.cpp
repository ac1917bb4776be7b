#include "results/report.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include "report_run.hpp"
#include "results/report_encode.hpp"
#include "results/report_history.hpp"
#include "results/report_profile.hpp"
#include "results/report_scene.hpp"
#include "results/report_vtu.hpp"

namespace cleave::results {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

void put(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

class Report : public testing::Test {
 protected:
  Report() : run(fs::temp_directory_path() / ("cleave_report_" + std::to_string(::getpid()))) {
    fs::remove_all(run);
    fs::create_directories(run);
  }
  ~Report() override { fs::remove_all(run); }

  bool has_note(const ReportOutcome& outcome, const std::string& part) const {
    for (const std::string& note : outcome.notes)
      if (note.find(part) != std::string::npos) return true;
    return false;
  }
  fs::path run;
};

TEST_F(Report, PageHoldsTheRunAndNeedsNothingElse) {
  test::write_run(run, 4, 10, 3);
  put(run / "picture.png", "not really a picture");
  const ReportOutcome outcome = write_report(run);
  ASSERT_TRUE(outcome.ok) << outcome.message;
  EXPECT_TRUE(outcome.notes.empty()) << outcome.notes.front();
  const std::string page = text_of(run / "report.html");
  EXPECT_FALSE(fs::exists(run / "report.html.part"));

  // Nothing is loaded: no attribute or style points anywhere, and the page forbids it to itself.
  for (const char* load : {"src=\"http", "href=\"http", "src=\"//", "url(http", "@import", "<link", "fetch("})
    EXPECT_EQ(page.find(load), std::string::npos) << load;
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);

  // The data are there, and text of the deck cannot end their script elements.
  EXPECT_NE(page.find("\"keyword\": \"CONTACT_AUTOMATIC\""), std::string::npos);
  EXPECT_NE(page.find("227 m/s \\u003c/script>"), std::string::npos);
  EXPECT_EQ(page.find("227 m/s </script>"), std::string::npos);
  for (const char* block : {"history-glstat", "history-nodout", "topology-0", "frame-2", "image-picture"})
    EXPECT_NE(page.find("<script id=\"data-" + std::string(block) + "\" type=\"text/plain\">"),
              std::string::npos)
        << block;
  EXPECT_NE(page.find(base64("not really a picture")), std::string::npos);
  EXPECT_NE(page.find("class Viewer"), std::string::npos);
  EXPECT_EQ(page.find("<!-- data -->"), std::string::npos);
}

TEST_F(Report, SaysWhatIsNotARun) {
  const ReportOutcome empty = write_report(run);
  EXPECT_FALSE(empty.ok);
  EXPECT_NE(empty.message.find("holds no run"), std::string::npos);
  const ReportOutcome none = write_report(run / "absent");
  EXPECT_FALSE(none.ok);
  EXPECT_NE(none.message.find("is not a directory"), std::string::npos);
}

TEST_F(Report, MissingAndBrokenFilesAreNotes) {
  put(run / "summary.json", "{\"title\": \"alone\"}");
  const ReportOutcome alone = write_report(run);
  ASSERT_TRUE(alone.ok);
  EXPECT_TRUE(has_note(alone, "no histories"));
  EXPECT_TRUE(has_note(alone, "no 3D view"));

  test::write_run(run, 2, 3, 3);
  fs::remove(run / "summary.json");
  fs::resize_file(run / "result/result_1.vtu", 1500);
  std::ofstream(run / "glstat.csv", std::ios::app) << "8e-5,24";  // cut off while it was written
  const ReportOutcome killed = write_report(run);
  ASSERT_TRUE(killed.ok);
  EXPECT_TRUE(has_note(killed, "summary.json is missing"));
  EXPECT_TRUE(has_note(killed, "result_1.vtu is left out"));
  EXPECT_TRUE(has_note(killed, "1 incomplete rows of glstat.csv"));
}

TEST_F(Report, HistoryIsSplitByIdAndKeepsNotANumber) {
  put(run / "nodout.csv",
      "time,cycle,id,x\n0,0,7,1.5\n0,0,9,nan\n1e-3,1,7,-inf\n1e-3,1,9,wrong\n2e-3,2,7,4\n");
  const auto table = read_history(run / "nodout.csv");
  ASSERT_TRUE(table);
  EXPECT_EQ(table->columns, (std::vector<std::string>{"time", "cycle", "x"}));
  ASSERT_EQ(table->entities.size(), 2u);
  EXPECT_EQ(table->entities[0].id, 7);
  EXPECT_EQ(table->entities[0].column[0], (std::vector<double>{0.0, 1e-3, 2e-3}));
  EXPECT_EQ(table->entities[0].column[2][2], 4.0);
  EXPECT_TRUE(std::isinf(table->entities[0].column[2][1]));
  EXPECT_TRUE(std::isnan(table->entities[1].column[2][0]) && std::isnan(table->entities[1].column[2][1]));
  EXPECT_FALSE(read_history(run / "elout.csv"));
}

TEST_F(Report, LongHistoriesAreThinnedAndSayIt) {
  test::write_run(run, 2, 2, 1);
  ReportOptions small;
  small.max_history_bytes = 8000;
  const ReportOutcome outcome = write_report(run, small);
  ASSERT_TRUE(outcome.ok);
  EXPECT_TRUE(has_note(outcome, "Plots of glstat show every"));
  auto table = read_history(run / "glstat.csv");
  const double end = table->entities[0].column[0].back();
  EXPECT_EQ(thin(*table, 100), 5u);
  EXPECT_EQ(table->rows(), 81u);
  EXPECT_EQ(table->entities[0].column[0].back(), end);  // the last row stays
}

TEST_F(Report, FieldFileIsReadBack) {
  const auto mesh = test::cubes(2, 3, 4);
  test::write_vtu_file(run / "a.vtu", mesh, mesh, 8e-5);
  VtuFrame frame;
  ASSERT_EQ(read_vtu(run / "a.vtu", frame), "");
  ASSERT_EQ(frame.groups.size(), 1u);
  EXPECT_EQ(frame.groups[0].node, mesh.node);
  EXPECT_EQ(frame.position, mesh.position);
  EXPECT_EQ(frame.element_id.front(), 101.0);
  EXPECT_EQ(frame.fields.size(), 3u);
  EXPECT_NE(read_vtu(run / "none.vtu", frame), "");
  put(run / "b.vtu", "<VTKFile></VTKFile>");
  EXPECT_NE(read_vtu(run / "b.vtu", frame), "");
}

TEST_F(Report, SceneKeepsTheSkinWithinItsBudget) {
  test::write_run(run, 6, 20, 9);
  const Scene all = build_scene(run, 20, 1u << 24);
  // Skin of a 6 x 6 x 20 bar: 2 * 36 + 4 * 120 faces; one topology for all frames.
  EXPECT_NE(all.json.find("\"faces\":552"), std::string::npos) << all.json;
  ASSERT_EQ(all.blocks.size(), 1u + 9u);
  EXPECT_EQ(all.blocks[0].second.size(), 552u * (8 + 16 + 1));
  const std::size_t nodes = 552 + 2;  // Euler: nodes - edges + faces = 2 with two edges per quadrilateral
  EXPECT_EQ(all.blocks[1].second.size(), 2 * (3 * nodes + 2 * 552 + nodes));
  EXPECT_LT(all.json.find("effective_plastic_strain"), all.json.find("pressure"));
  EXPECT_NE(all.json.find("\"high\":2.7"), std::string::npos);

  const Scene few = build_scene(run, 20, 4 * all.blocks[1].second.size());
  EXPECT_EQ(few.blocks.size(), 1u + 4u);
  ASSERT_EQ(few.notes.size(), 1u);
  EXPECT_NE(few.notes[0].find("4 of 9 frames"), std::string::npos);
  EXPECT_EQ(few.blocks.back().second, all.blocks.back().second);  // the last frame is always there
}

TEST_F(Report, SceneFollowsErosionAndMarksWhatIsNoNumber) {
  fs::create_directories(run);
  auto two = test::cubes(2, 1, 1), one = test::cubes(2, 1, 1);
  one.node.resize(8);
  test::write_vtu_file(run / "0.vtu", two, two, 8e-5);
  one.position[0] = NAN;  // displacement and position of its first node
  test::write_vtu_file(run / "1.vtu", one, two, 8e-5);
  put(run / "result.pvd",
      "<DataSet timestep=\"0\" file=\"0.vtu\"/>\n<DataSet timestep=\"1e-6\" file=\"1.vtu\"/>");
  const Scene scene = build_scene(run, 20, 1u << 20);
  EXPECT_NE(scene.json.find("\"faces\":10,\"nodes\":12},{\"block\":\"topology-1\",\"faces\":6,\"nodes\":8}"),
            std::string::npos)
      << scene.json;
  EXPECT_NE(scene.json.find("\"time\":1e-06,\"topology\":1"), std::string::npos);
  EXPECT_EQ(scene.json.find("null"), std::string::npos);  // ranges are of the finite values
  const std::string& last = scene.blocks.back().second;
  EXPECT_EQ(last.size(), 2u * (3 * 8 + 2 * 6 + 8));
  EXPECT_NE(last.find("\xff\xff"), std::string::npos);
}

/// Two bars of two points each, in the wrong order, at two instants; velocity is a vector.
void write_bars(const fs::path& run) {
  const auto frame = [](double share) {
    std::string data;
    const auto array = [&](const std::vector<float>& values) {
      const std::uint64_t size = 4 * values.size(), at = data.size();
      data.append(reinterpret_cast<const char*>(&size), 8);
      append_bytes(data, values);
      return at;
    };
    const auto tag = [](const char* name, int size, std::uint64_t at) {
      return "<DataArray type=\"Float32\" Name=\"" + std::string(name) + "\" NumberOfComponents=\"" +
             std::to_string(size) + "\" format=\"appended\" offset=\"" + std::to_string(at) + "\"/>\n";
    };
    const float v = static_cast<float>(share);
    std::string head =
        "<VTKFile type=\"UnstructuredGrid\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        "<Piece NumberOfPoints=\"4\" NumberOfCells=\"0\">\n<PointData>\n" +
        tag("velocity", 3, array({2 * v, 9, 9, 3 * v, 9, 9, 0, 9, 9, v, 9, 9})) +
        tag("stress", 1, array({3, 4, 1, -2})) + "</PointData>\n<Points>\n" +
        tag("Points", 3, array({1, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0, 0})) + "</Points>\n";
    return head + "</Piece>\n<AppendedData encoding=\"raw\">\n_" + data + "</AppendedData>\n";
  };
  std::string list;
  for (const int i : {0, 1}) {
    put(run / ("bar_" + std::to_string(i) + ".vtu"), frame(1.0 + i));
    list += "<DataSet timestep=\"" + std::to_string(0.5 * i) + "\" file=\"bar_" + std::to_string(i) +
            ".vtu\"/>\n";
  }
  put(run / "result.pvd", list);
  put(run / "glstat.csv", "time,kinetic_energy\n0,1\n0.5,1\n");
}

TEST_F(Report, BarsHaveProfiles) {
  write_bars(run);
  const Scene profiles = build_profiles(run, 1 << 20);
  ASSERT_EQ(profiles.json,
            "{\"points\":4,\"times\":[0,0.5],\"fields\":[{\"name\":\"velocity\",\"low\":0,\"high\":6},"
            "{\"name\":\"stress\",\"low\":-2,\"high\":4}]}");
  ASSERT_EQ(profiles.blocks.size(), 3u);
  const auto numbers = [&](std::size_t b) {
    const std::string& bytes = profiles.blocks[b].second;
    std::vector<float> values(bytes.size() / 4);
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  };
  EXPECT_EQ(profiles.blocks[1].first, "profile-velocity");
  EXPECT_EQ(numbers(0), (std::vector<float>{0, 1, 1, 2}));
  EXPECT_EQ(numbers(1), (std::vector<float>{0, 2, 1, 3, 0, 4, 2, 6}));  // both values where bars meet
  EXPECT_EQ(numbers(2), (std::vector<float>{1, 3, -2, 4, 1, 3, -2, 4}));
  const ReportOutcome outcome = write_report(run);
  ASSERT_TRUE(outcome.ok);
  EXPECT_FALSE(has_note(outcome, "3D view"));
  EXPECT_NE(text_of(outcome.page).find("data-profile-stress"), std::string::npos);
}

TEST_F(Report, BodiesInSpaceHaveNone) {
  test::write_run(run, 3, 6, 3);
  EXPECT_TRUE(build_profiles(run, 1 << 20).json.empty());
}

/// Runs the page where there is a browser: its scripts must reach their end.
std::string page_in_a_browser(const fs::path& run) {
  const std::string command =
      "timeout 60 chromium --headless --no-sandbox --disable-gpu --no-first-run "
      "--disable-background-networking --disable-sync --user-data-dir='" +
      (run / "profile").string() + "' --virtual-time-budget=3000 --dump-dom 'file://" +
      (run / "report.html").string() + "' > '" + (run / "dom").string() + "' 2>/dev/null";
  const bool started = std::system(command.c_str()) == 0;
  const std::string dom = text_of(run / "dom");
  return started && dom.find("</html>") != std::string::npos ? dom : "";
}

TEST_F(Report, PageRunsInABrowser) {
  if (std::system("command -v chromium >/dev/null 2>&1") != 0) GTEST_SKIP() << "there is no chromium here";
  test::write_run(run, 3, 6, 3);
  ASSERT_TRUE(write_report(run).ok);
  const std::string dom = page_in_a_browser(run);
  if (dom.empty()) GTEST_SKIP() << "chromium does not start here";
  EXPECT_NE(dom.find("data-ready=\"with"), std::string::npos);
  EXPECT_NE(dom.find("0.99874</b>"), std::string::npos);
  EXPECT_NE(dom.find("z displacement"), std::string::npos);
  EXPECT_NE(dom.find("<section id=\"profiles\" hidden"), std::string::npos);

  write_bars(run);
  ASSERT_TRUE(write_report(run).ok);
  const std::string bars = page_in_a_browser(run);
  EXPECT_NE(bars.find("data-ready=\"without"), std::string::npos);
  EXPECT_NE(bars.find("t = 0.5   (2 of 2)"), std::string::npos);
  EXPECT_NE(bars.find("x from 0 to 2 to the right, t from 0 to 0.5 upwards; velocity from 0"),
            std::string::npos);
}

TEST(Encode, Base64AndJson) {
  // Test vectors of RFC 4648, section 10.
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(json_text("a\"b\\c<d\n"), "\"a\\\"b\\\\c\\u003cd\\u000a\"");
  EXPECT_EQ(json_number(0.1), "0.1");
  EXPECT_EQ(json_number(NAN), "null");
}

}  // namespace
}  // namespace cleave::results
