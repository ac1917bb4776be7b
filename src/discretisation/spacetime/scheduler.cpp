#include "discretisation/spacetime/scheduler.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <mutex>
#include <queue>

#include "base/assert.hpp"
#include "base/threads.hpp"

namespace cleave::discretisation::spacetime {
namespace {

/// Memory of recorded tents, per vertex: written only by the thread that pitches the vertex.
struct Diary {
  struct Entry {
    double foot, top, duration;
    std::vector<std::int32_t> seen;  ///< tents so far at the vertex itself and at each of its neighbours
  };
  std::vector<Entry> entries;
};

/// Vertices that may be pitched, in the order (window of time, vertex). Windows of a few tents' height keep
/// the front together; within one, vertices go by number, which is what finds their neighbourhood in cache:
/// lowest first, strictly, would wander over the whole mesh.
class ReadyVertices {
 public:
  explicit ReadyVertices(double window) : window_(window) {}

  std::int64_t window_of(double time) const { return static_cast<std::int64_t>(std::floor(time / window_)); }
  void add(double time, Vertex v) {
    const std::lock_guard lock(mutex_);
    heap_.emplace(window_of(time), v);
  }
  /// Takes its share of what is ready, or enough to find equal ones, at most `most`; all of one window.
  void take(std::size_t most, std::size_t shares, std::vector<Vertex>& out) {
    const std::lock_guard lock(mutex_);
    most = std::min({most, heap_.size(), std::max(enough, (heap_.size() + shares - 1) / shares)});
    while (out.size() < most && (out.empty() || heap_.top().first == window_taken_)) {
      window_taken_ = heap_.top().first;
      out.push_back(heap_.top().second);
      heap_.pop();
    }
  }

 private:
  using Entry = std::pair<std::int64_t, Vertex>;
  static constexpr std::size_t enough = 16;  ///< equal ones among fewer would leave lanes empty
  const double window_;
  std::int64_t window_taken_ = 0;
  std::mutex mutex_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap_;
};

}  // namespace

/// What one advance knows.
template <int D>
struct Scheduler<D>::Run {
  const Scheduler& scheduler;
  const SpaceMesh<D>& mesh;
  Front<D>& front;
  const double end_time;
  const SolveSeveral& solve;
  const Pause& pause;
  std::vector<Diary> diaries;        ///< [vertex] when recording
  std::vector<double> first_height;  ///< [vertex] of its first tent, 0 before; written by whoever pitches it
  std::vector<char> slowed;          ///< [vertex]
  std::atomic<std::int64_t> patches{0};

  std::mutex failure_lock;
  FrontStatus failure;
  Key failed_at;
  std::atomic<double> stop_after{
      std::numeric_limits<double>::infinity()};  ///< tents with later feet are dropped

  /// A tent on its way.
  struct Tent {
    Key key;
    Pole<D> pole;
    double offered = 0.0, share = 1.0;  ///< height [time]; part of it that is tried
  };

  /// The tent over v. False if there is none.
  bool pitch(Vertex v, Tent& tent) {
    tent.key = scheduler.pitcher_.key(front, v);
    tent.share = 1.0;
    if (tent.key.time > stop_after.load(std::memory_order_relaxed) || tent.key.time >= pause.at) return false;
    if (pause.stop && pause.stop->load(std::memory_order_relaxed)) return false;
    tent.pole = scheduler.pitcher_.pitch(front, v, end_time);
    tent.offered = tent.pole.height();
    return tent.offered > 0.0 || fail(v, tent.key, "the front cannot rise");
  }

  bool build(const Tent& tent, Patch<D>& patch) {
    build_patch(mesh, front, tent.pole, patch);
    if (!scheduler.options_.verify) return true;
    const std::string fault = fault_of(mesh, patch);
    return fault.empty() || fail(tent.pole.vertex, tent.key, fault);
  }

  /// A tent that the solver asked to be lower. False when nothing was solved.
  bool lower(Tent& tent, Patch<D>& patch, Verdict verdict) {
    const Vertex v = tent.pole.vertex;
    while (verdict.kind != Verdict::accept) {
      if (verdict.kind == Verdict::fail) return fail(v, tent.key, verdict.what);
      CLEAVE_ASSERT(verdict.factor > 0.0 && verdict.factor < 1.0, "a lower tent must be lower, and a tent");
      tent.share *= verdict.factor;
      if (tent.share < 1e-6)
        return fail(
            v, tent.key,
            "no tent is low enough for the solver" + (verdict.what.empty() ? "" : ": " + verdict.what));
      // Every point below an admissible top of a vertical pole is admissible; of an inclined pole it need not
      // be. So a tent that was refused stands upright.
      tent.pole = scheduler.pitcher_.pitch_towards(front, v, end_time, {});
      tent.pole.top[D] = tent.pole.foot[D] + tent.share * tent.pole.height();
      if (!build(tent, patch)) return false;
      verdict = {};
      solve({&patch, 1}, {&verdict, 1});
    }
    return true;
  }

  /// Pitches vertices none of which is next to another, and moves the front there. On return `list` holds
  /// those that moved.
  void pitch_all(std::vector<Vertex>& list) {
    thread_local std::vector<Tent> tents;
    thread_local std::vector<Patch<D>> patches_at_work;
    thread_local std::vector<Verdict> verdicts;
    const auto started = std::chrono::steady_clock::now();
    if (tents.size() < list.size()) tents.resize(list.size()), patches_at_work.resize(list.size());
    std::size_t count = 0;
    for (const Vertex v : list)
      if (pitch(v, tents[count]) && build(tents[count], patches_at_work[count])) ++count;
    list.clear();
    verdicts.assign(count, Verdict{});
    if (count > 0) solve({patches_at_work.data(), count}, verdicts);
    for (std::size_t k = 0; k < count; ++k)
      if (lower(tents[k], patches_at_work[k], std::move(verdicts[k]))) {
        rise(tents[k], started, static_cast<double>(count));
        list.push_back(tents[k].pole.vertex);
      }
  }

  void rise(const Tent& tent, std::chrono::steady_clock::time_point started, double sharers) {
    const auto v = static_cast<std::size_t>(tent.pole.vertex);
    double& first = first_height[v];
    if (first == 0.0) first = tent.offered;
    const bool cut_by_end = tent.offered >= 0.5 * (end_time - tent.pole.foot[D]) * (1.0 - 1e-9);
    if (tent.offered < 0.05 * first && !cut_by_end) slowed[v] = 1;
    scheduler.pitcher_.commit(front, tent.pole);
    patches.fetch_add(1, std::memory_order_relaxed);
    if (diaries.empty()) return;
    Diary& diary = diaries[v];
    Diary::Entry entry{tent.pole.foot[D], tent.pole.top[D], 0.0, {}};
    entry.seen.push_back(static_cast<std::int32_t>(diary.entries.size()));
    for (const Vertex w : mesh.neighbours(tent.pole.vertex))
      entry.seen.push_back(static_cast<std::int32_t>(diaries[static_cast<std::size_t>(w)].entries.size()));
    entry.duration =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count() / sharers;
    diary.entries.push_back(std::move(entry));
  }

  bool fail(Vertex v, const Key& key, const std::string& what) {
    const std::lock_guard lock(failure_lock);
    if (failure.ok || key < failed_at) {
      failed_at = key;
      failure = {.ok = false,
                 .vertex = v,
                 .time = key.time,
                 .bound = scheduler.pitcher_.sure_gain(front, v),
                 .what = what,
                 .patches = 0,
                 .slowed = {}};
      stop_after.store(key.time, std::memory_order_relaxed);
    }
    return false;
  }

  /// Every edge of the mesh points from its lower to its higher end. `lower_count[v]` counts the neighbours
  /// below v; a vertex is ready when it is zero, and pitching it turns its edges over. Only the thread that
  /// pitches v turns the edges of v, since none of its neighbours is ready then. Releasing the last count of
  /// w makes everything written around w visible to whoever pitches w.
  void work() {
    const auto count = static_cast<std::size_t>(mesh.vertex_count());
    const auto lower_count = std::make_unique<std::atomic<std::int32_t>[]>(count);
    ReadyVertices ready(window());
    std::vector<std::int32_t>
        tokens;  // one for each vertex in `ready`; which one it gets is the queue's affair
    for (Vertex v = 0; v < mesh.vertex_count(); ++v) {
      const Key key = scheduler.pitcher_.key(front, v);
      std::int32_t below = 0;
      for (const Vertex w : mesh.neighbours(v)) below += scheduler.pitcher_.key(front, w) < key;
      lower_count[static_cast<std::size_t>(v)].store(below, std::memory_order_relaxed);
      if (below > 0 || key.time >= end_time) continue;
      ready.add(key.time, v);
      tokens.push_back(0);
    }
    const auto together = static_cast<std::size_t>(std::max(1, scheduler.options_.together)),
               shares = together == 1 ? count : static_cast<std::size_t>(std::max(1, base::thread_count()));
    base::for_each_fed(tokens, [&](std::int32_t, base::Feed& feed) {
      thread_local std::vector<Vertex> list, turned;
      list.clear();
      ready.take(together, shares, list);
      if (list.empty()) return;  // others took more than one each
      const std::int64_t window_of_list = ready.window_of(front.time[static_cast<std::size_t>(list[0])]);
      // Goes on with vertices it made ready, in the same window: their data are in cache.
      while (!list.empty()) {
        pitch_all(list);
        const std::size_t moved = list.size();
        for (std::size_t k = 0; k < moved; ++k) {
          const Vertex v = list[k];
          const Key key = scheduler.pitcher_.key(front, v);
          turned.clear();
          for (const Vertex w : mesh.neighbours(v))
            if (scheduler.pitcher_.key(front, w) < key) turned.push_back(w);
          lower_count[static_cast<std::size_t>(v)].store(static_cast<std::int32_t>(turned.size()),
                                                         std::memory_order_relaxed);
          const auto offer = [&](double time, Vertex w) {
            if (time >= end_time) return;
            if (together == 1 && list.size() == moved && ready.window_of(time) <= window_of_list) {
              list.push_back(w);
            } else {
              ready.add(time, w);
              feed.add(0);
            }
          };
          const bool still_lowest = turned.empty();
          for (const Vertex w : turned) {
            const double time =
                front.time[static_cast<std::size_t>(w)];  // w may move once its count is released
            if (lower_count[static_cast<std::size_t>(w)].fetch_sub(1, std::memory_order_acq_rel) == 1)
              offer(time, w);
          }
          if (still_lowest) offer(key.time, v);
        }
        list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(moved));
      }
    });
  }

  /// A few times what a wave needs to cross a simplex [time].
  double window() const {
    double sum = 0.0;
    for (Simplex s = 0; s < mesh.simplex_count(); ++s) {
      const auto& simplex = mesh.simplex(s);
      sum += distance(mesh.position()[static_cast<std::size_t>(simplex[0])],
                      mesh.position()[static_cast<std::size_t>(simplex[1])]) /
             mesh.speed(s).fastest;
    }
    return 4.0 * sum / mesh.simplex_count();
  }

  void write(ScheduleRecord& record) const {
    struct Place {
      Key key;
      Vertex v;
      std::int32_t number;
    };
    std::vector<Place> places;
    std::vector<std::vector<std::int32_t>> at(diaries.size());
    for (std::size_t v = 0; v < diaries.size(); ++v) {
      at[v].resize(diaries[v].entries.size());
      for (std::size_t n = 0; n < at[v].size(); ++n)
        places.push_back({{diaries[v].entries[n].foot, mesh.rank(static_cast<Vertex>(v))},
                          static_cast<Vertex>(v),
                          static_cast<std::int32_t>(n)});
    }
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.key < b.key; });
    for (std::size_t i = 0; i < places.size(); ++i)
      at[static_cast<std::size_t>(places[i].v)][static_cast<std::size_t>(places[i].number)] =
          static_cast<std::int32_t>(i);
    record = {};
    for (const Place& place : places) {
      const auto v = static_cast<std::size_t>(place.v);
      const auto& entry = diaries[v].entries[static_cast<std::size_t>(place.number)];
      record.tents.push_back({.pole = place.v,
                              .foot = entry.foot,
                              .top = entry.top,
                              .duration = entry.duration,
                              .first_needed = static_cast<std::int64_t>(record.needed.size())});
      const std::size_t begin = record.needed.size();
      const auto need = [&](std::size_t w, std::int32_t seen) {
        if (seen > 0) record.needed.push_back(at[w][static_cast<std::size_t>(seen - 1)]);
      };
      need(v, entry.seen[0]);
      const auto around = mesh.neighbours(place.v);
      for (std::size_t k = 0; k < around.size(); ++k)
        need(static_cast<std::size_t>(around[k]), entry.seen[k + 1]);
      std::sort(record.needed.begin() + static_cast<std::ptrdiff_t>(begin), record.needed.end());
    }
  }
};

template <int D>
FrontStatus Scheduler<D>::advance(Front<D>& front, double end_time, const Solve& solve,
                                  ScheduleRecord* record, const Pause& pause) {
  return advance_several(
      front, end_time,
      [&](std::span<const Patch<D>> patches, std::span<Verdict> verdicts) {
        for (std::size_t k = 0; k < patches.size(); ++k) verdicts[k] = solve(patches[k]);
      },
      record, pause);
}

template <int D>
FrontStatus Scheduler<D>::advance_several(Front<D>& front, double end_time, const SolveSeveral& solve,
                                          ScheduleRecord* record, const Pause& pause) {
  Run run{.scheduler = *this,
          .mesh = pitcher_.mesh(),
          .front = front,
          .end_time = end_time,
          .solve = solve,
          .pause = pause,
          .diaries = {},
          .first_height = std::vector<double>(front.time.size(), 0.0),
          .slowed = std::vector<char>(front.time.size(), 0),
          .patches = 0,
          .failure_lock = {},
          .failure = {},
          .failed_at = {},
          .stop_after = std::numeric_limits<double>::infinity()};
  if (record) run.diaries.resize(front.time.size());
  run.work();
  if (record) run.write(*record);
  run.failure.patches = run.patches;
  for (std::size_t v = 0; v < run.slowed.size(); ++v)
    if (run.slowed[v]) run.failure.slowed.push_back(static_cast<Vertex>(v));
  return run.failure;
}

template class Scheduler<1>;
template class Scheduler<2>;
template class Scheduler<3>;

}  // namespace cleave::discretisation::spacetime
