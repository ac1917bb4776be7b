#pragma once
/// Advances the front tent by tent: which vertex next, on which thread.
///
/// A vertex is pitched exactly when its key (time, rank) is less than those of all its neighbours. Whatever
/// order such vertices are taken in, each finds the same neighbours, hence the same tent and the same data
/// below it: the result has the same bits for any number of threads. There is no barrier; scheduler.cpp says
/// who may touch what.

#include <atomic>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "discretisation/spacetime/pitcher.hpp"
#include "discretisation/spacetime/schedule_record.hpp"
#include "discretisation/spacetime/tent.hpp"

namespace cleave::discretisation::spacetime {

/// What the solver of a patch answers.
struct Verdict {
  enum Kind : std::uint8_t {
    accept,  ///< solved and committed: the front may move
    lower,   ///< nothing committed: offer the tent again at `factor` of its height
    fail     ///< nothing committed: stop
  };
  Kind kind = accept;
  double factor = 0.5;    ///< in (0, 1)
  std::string what = {};  ///< why it failed
};

/// How an advance ended.
struct FrontStatus {
  bool ok = true;
  Vertex vertex = -1;  ///< where it failed: the earliest failing tent, the same for any number of threads
  double time = 0.0;   ///< of its foot [time]
  double bound = 0.0;  ///< what its gain should at least have been [time]
  std::string what;
  std::int64_t patches = 0;  ///< accepted
  /// Vertices, ascending, with a tent below 1/20 of their first one of this advance, those before the end and
  /// those the solver asked for aside: where geometry slows the front down.
  std::vector<Vertex> slowed;
};

struct ScheduleOptions {
  bool verify = false;  ///< check every patch with fault_of()
  /// Patches handed to the solver at one time, when as many are ready: equal ones share the work of reading
  /// their operator. They share no simplex, and none is different for it.
  int together = 1;
};

/// Where an advance pauses before its end. The tents until then, and those after it has been taken up again,
/// are those of an advance without a pause.
struct Pause {
  /// Tents with a foot at or after this wait: then no vertex of the front is before it [time]
  double at = std::numeric_limits<double>::infinity();
  /// Set by another thread: finish the tents in flight and return; the front may be anywhere.
  const std::atomic<bool>* stop = nullptr;
};

template <int D>
class Scheduler {
 public:
  /// Solves one patch and commits its fields, or neither. Called on any thread; patches in flight at one time
  /// share no simplex. Must not throw or start parallel loops.
  using Solve = std::function<Verdict(const Patch<D>&)>;
  /// The same for several patches. @param verdicts [patches] all accepting on entry
  using SolveSeveral = std::function<void(std::span<const Patch<D>> patches, std::span<Verdict> verdicts)>;

  explicit Scheduler(const Pitcher<D>& pitcher, ScheduleOptions options = {})
      : pitcher_(pitcher), options_(options) {}

  /// Moves the whole front to end_time, exactly, or to a pause. Uses base::thread_count() threads. When a
  /// tent fails, the tents before it in time are still finished; the front stays admissible and the advance
  /// can be resumed.
  /// @param record  receives the tents with durations and dependencies when not null
  FrontStatus advance(Front<D>& front, double end_time, const Solve& solve, ScheduleRecord* record = nullptr,
                      const Pause& pause = {});
  FrontStatus advance_several(Front<D>& front, double end_time, const SolveSeveral& solve,
                              ScheduleRecord* record = nullptr, const Pause& pause = {});

 private:
  struct Run;
  const Pitcher<D>& pitcher_;
  ScheduleOptions options_;
};

}  // namespace cleave::discretisation::spacetime
