#include "results/recorder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <nlohmann/json.hpp>

#include "results/restart.hpp"
#include "small_run.hpp"

namespace cleave::results::test {
namespace {

/// Asks for every history, at intervals that do not divide each other.
void ask_for_everything(SmallRun& run) {
  model::Requests& requests = run.model.requests;
  requests.field.every = 0.13;
  requests.glstat.every = 0.02;
  requests.matsum.every = 0.05;
  requests.nodout.every = 0.03;
  requests.elout.every = 0.07;
  requests.rwforc.every = 0.04;
  requests.spcforc.every = 0.06;
  requests.history_nodes = {0, 8};
  requests.history_solids = {1, 2};
  run.model.walls.resize(1);
  run.walls.resize(1);
}

const char* const compared[] = {"glstat.csv",
                                "matsum.csv",
                                "nodout.csv",
                                "elout.csv",
                                "rwforc.csv",
                                "spcforc.csv",
                                "glstat",
                                "matsum",
                                "nodout",
                                "elout",
                                "rwforc",
                                "spcforc",
                                "result.pvd",
                                "result/result_0000.vtu",
                                "result/result_0004.vtu",
                                "result/result_0007.vtu",
                                "result/result_0008.vtu"};

void expect_same_files(const SmallRun& a, const SmallRun& b) {
  for (const char* name : compared) {
    EXPECT_FALSE(a.text(name).empty()) << name;
    EXPECT_TRUE(a.text(name) == b.text(name)) << name;
  }
}

TEST(Recorder, ContinuesAfterAStopAsIfItHadNotStopped) {
  SmallRun whole("whole");
  ask_for_everything(whole);
  {
    Recorder recorder(whole.model, whole.options());
    whole.run(recorder, 100);
  }
  // Cycle 47 is due for nothing: the stop writes rows and a frame that an uninterrupted run does not have.
  SmallRun halves("halves");
  ask_for_everything(halves);
  {
    Recorder recorder(halves.model, halves.options());
    halves.run(recorder, 47);
  }
  EXPECT_EQ(split(halves.lines("glstat.csv").back())[1], "47");
  const Restart restart = read_restart(halves.directory / "restart.h5");
  ASSERT_EQ(restart.error, "");
  halves.state = restart.state;
  {
    Recorder recorder(halves.model, halves.options());
    halves.run(recorder, 100);
  }
  expect_same_files(whole, halves);
}

TEST(Recorder, ContinuesAfterAKillLongAfterTheRestartWasWritten) {
  SmallRun whole("unkilled");
  ask_for_everything(whole);
  {
    Recorder recorder(whole.model, whole.options());
    whole.run(recorder, 100);
  }
  SmallRun killed("killed");
  ask_for_everything(killed);
  killed.model.requests.running_restart_cycles = 30;
  {
    Recorder recorder(killed.model, killed.options());
    killed.run(recorder, 85, false);  // no finish()
  }
  const Restart restart = read_restart(killed.directory / "restart.h5");
  ASSERT_EQ(restart.state.cycle, 60);
  killed.state = restart.state;
  {
    Recorder recorder(killed.model, killed.options());
    killed.run(recorder, 100);
  }
  expect_same_files(whole, killed);
}

TEST(Recorder, RestartingAFinishedRunAddsNothing) {
  SmallRun run("finished"), reference("finished_reference");
  for (SmallRun* each : {&run, &reference}) {
    ask_for_everything(*each);
    Recorder recorder(each->model, each->options());
    each->run(recorder, 100);
  }
  run.state = read_restart(run.directory / "restart.h5").state;
  Recorder recorder(run.model, run.options());
  run.run(recorder, 100);
  expect_same_files(run, reference);
}

TEST(Recorder, TheSummaryKnowsTheWholeRunAfterARestart) {
  SmallRun run("summary_restart");
  {
    Recorder recorder(run.model, run.options());
    run.run(recorder, 47);
  }
  run.state = read_restart(run.directory / "restart.h5").state;
  Recorder recorder(run.model, run.options());
  run.run(recorder, 100);
  recorder.summarise({});
  EXPECT_EQ(nlohmann::json::parse(run.text("summary.json"))["energy"]["kinetic_high"], 50.0);
}

TEST(Recorder, StartsAnewInADirectoryOfAnEarlierRun) {
  SmallRun run("again");
  ask_for_everything(run);
  {
    Recorder recorder(run.model, run.options());
    run.run(recorder, 100);
  }
  run.model.requests = {};
  run.state.cycle = 0;
  run.update();
  std::ofstream(run.directory / "result.pvd.part") << "left by a kill";
  Recorder recorder(run.model, run.options());
  run.run(recorder, 5);
  EXPECT_EQ(run.lines("glstat.csv").size(), 1u + 6u);  // every 0.001, so every cycle
  EXPECT_FALSE(std::filesystem::exists(run.directory / "nodout.csv"));
  EXPECT_FALSE(std::filesystem::exists(run.directory / "result/result_0002.vtu"));
  EXPECT_FALSE(std::filesystem::exists(run.directory / "result.pvd.part"));
}

TEST(Recorder, WritesRestartsAtTheCyclesAskedForAndOnRequest) {
  SmallRun run("restarts");
  run.model.requests.restart_cycles = 40;
  Recorder recorder(run.model, run.options());
  run.run(recorder, 90, false);
  EXPECT_TRUE(std::filesystem::exists(run.directory / "restart_40.h5"));
  EXPECT_TRUE(std::filesystem::exists(run.directory / "restart_80.h5"));
  EXPECT_FALSE(std::filesystem::exists(run.directory / "restart.h5"));
  run.wishes.restart = true;
  recorder.after_step(run.frame());
  EXPECT_FALSE(run.wishes.restart);
  EXPECT_EQ(read_restart(run.directory / "restart.h5").state.cycle, 90);
}

TEST(Recorder, WritesNoRestartOfAFailedState) {
  SmallRun run("failed");
  Recorder recorder(run.model, run.options());
  recorder.begin(run.frame());
  discretisation::StepStatus status;
  status.ok = false;
  status.element = 2;
  status.what = "volume became negative";
  recorder.finish(run.frame(), solver::Ending::physics, status);
  EXPECT_FALSE(std::filesystem::exists(run.directory / "restart.h5"));
  const std::string log = run.text("messag");
  EXPECT_NE(log.find("*** Error: solid element         2: volume became negative"), std::string::npos);
  EXPECT_NE(log.find("E r r o r   t e r m i n a t i o n"), std::string::npos);
}

TEST(Recorder, NamesTheKindOfElementThatFailed) {
  const auto said = [](model::Id element, model::Index part) {
    SmallRun run("kind");
    run.model.mesh.shells.push_back({model::Shape::quad4, {2, 7}, {1, 1}, {0, 1, 2, 3, 4, 5, 6, 7}});
    Recorder recorder(run.model, run.options());
    recorder.begin(run.frame());
    recorder.finish(run.frame(), solver::Ending::physics, {false, part, element, "it failed", ""});
    const std::string log = run.text("messag");
    const std::size_t at = log.find("*** Error: ");
    return log.substr(at, log.find('\n', at) - at);
  };
  const model::Index own = SmallRun("part").model.mesh.solids.at(0).part.at(1);
  EXPECT_EQ(said(2, -1), "*** Error: solid element         2: it failed");
  EXPECT_EQ(said(2, own), "*** Error: solid element         2: it failed");
  EXPECT_EQ(said(7, -1), "*** Error: shell element         7: it failed");
  EXPECT_EQ(said(99, -1), "*** Error: element        99: it failed");
  EXPECT_EQ(said(0, -1), "*** Error: it failed");  // of no element: a contact
}

TEST(Recorder, LogsDeletionsMassScalingAndTheEnd) {
  SmallRun run("log");
  Recorder recorder(run.model, run.options());
  recorder.begin(run.frame());
  run.state.cycle = 1;
  run.update();
  run.eroded = {2};
  run.state.added_mass = 0.16;
  recorder.after_step(run.frame());
  recorder.finish(run.frame(), solver::Ending::end_time, {});
  const std::string log = run.text("messag");
  EXPECT_NE(log.find(" solid element         2 failed at time   1.00000E-02\n"), std::string::npos);
  EXPECT_NE(log.find("added mass 1.6000E-01 (1.000 %)"), std::string::npos);
  EXPECT_NE(log.find("N o r m a l    t e r m i n a t i o n"), std::string::npos);
  EXPECT_NE(log.find("write result/result_0000.vtu"), std::string::npos);
}

/// In a child, because the limit cannot be raised again: the disk is full for every file above 6000 bytes.
TEST(Recorder, StopsOnceAndKeepsWholeFilesWhenTheDiskIsFull) {
  SmallRun run("full");
  ask_for_everything(run);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const rlimit limit{6000, 6000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    testing::internal::CaptureStderr();
    Recorder recorder(run.model, run.options());
    run.run(recorder, 1000000);
    recorder.summarise({});
    const std::string said = testing::internal::GetCapturedStderr();
    const auto first = said.find("cannot write");
    const bool once = first != std::string::npos &&
                      said.find("cannot write", first + 1) == std::string::npos &&
                      said.find("File too large") != std::string::npos;
    ::_exit(recorder.failed() && run.wishes.stop && once ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  // Every line is whole, and every listed frame is there.
  for (const char* name :
       {"glstat.csv", "matsum.csv", "nodout.csv", "elout.csv", "rwforc.csv", "spcforc.csv"}) {
    EXPECT_TRUE(run.text(name).ends_with("\n")) << name;
    const auto lines = run.lines(name);
    for (const std::string& line : lines) EXPECT_EQ(split(line).size(), split(lines[0]).size()) << name;
  }
  const std::string list = run.text("result.pvd");
  EXPECT_TRUE(list.ends_with("</VTKFile>\n"));
  for (auto at = list.find("file=\""); at != std::string::npos; at = list.find("file=\"", at + 1)) {
    const std::string file = list.substr(at + 6, list.find('"', at + 6) - at - 6);
    EXPECT_TRUE(run.text(file).ends_with("</VTKFile>\n")) << file;
  }
  for (const auto& file : std::filesystem::recursive_directory_iterator(run.directory))
    EXPECT_NE(file.path().extension(), ".part") << file.path();
}

}  // namespace
}  // namespace cleave::results::test
