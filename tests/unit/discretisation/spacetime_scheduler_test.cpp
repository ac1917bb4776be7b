#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "base/threads.hpp"
#include "discretisation/spacetime/scheduler.hpp"
#include "spacetime_meshes.hpp"

namespace cleave::discretisation::spacetime::sample {
namespace {

std::uint64_t mix(std::uint64_t hash, std::uint64_t bits) {
  return (hash ^ bits) * 0x100000001b3u;
}

template <class Numbers>
std::uint64_t mix_all(std::uint64_t hash, const Numbers& numbers) {
  for (const double x : numbers) hash = mix(hash, std::bit_cast<std::uint64_t>(x));
  return hash;
}

/// A solver that leaves in every simplex a hash of what it saw: the patch, and what lay below it.
template <int D>
class Witness {
 public:
  explicit Witness(const SpaceMesh<D>& mesh) : below_(static_cast<std::size_t>(mesh.simplex_count()), 1) {}

  Verdict operator()(const Patch<D>& patch) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const auto& element : patch.elements) {
      hash = mix(hash, below_[static_cast<std::size_t>(element.simplex)]);
      for (const auto& corner : element.corner) hash = mix_all(hash, corner);
    }
    for (const auto& facet : patch.facets)
      hash = mix_all(mix(hash, static_cast<std::uint64_t>(facet.kind)), facet.normal);
    if (rejecting && (hash >> 32) % 5 == 0) return {.kind = Verdict::lower, .factor = 0.7};
    if (patch.foot[D] > fail_after && patch.pole % 7 == 3) return {.kind = Verdict::fail, .what = "no more"};
    for (const auto& element : patch.elements)
      hash = below_[static_cast<std::size_t>(element.simplex)] =
          mix(hash, static_cast<std::uint64_t>(element.simplex));
    return {};
  }

  std::uint64_t seal() const {
    std::uint64_t hash = 1;
    for (const std::uint64_t h : below_) hash = mix(hash, h);
    return hash;
  }

  bool rejecting = false;
  double fail_after = 1e30;

 private:
  std::vector<std::uint64_t> below_;
};

template <int D>
void expect_same_bits(const SpaceMeshInput<D>& input, const PitchOptions& options, double end_time,
                      bool rejecting) {
  SpaceMesh<D> mesh;
  ASSERT_TRUE(mesh.build(input).ok);
  const Pitcher<D> pitcher(mesh, options);
  std::uint64_t seal = 0;
  std::int64_t patches = 0;
  std::vector<Point<D>> position;
  for (const int threads : {1, 2, 3, 7}) {
    base::set_thread_count(threads);
    Front<D> front = pitcher.level_front(0.0);
    Witness<D> witness(mesh);
    witness.rejecting = rejecting;
    const FrontStatus status =
        Scheduler<D>(pitcher, {.verify = true}).advance(front, end_time, std::ref(witness));
    ASSERT_TRUE(status.ok) << status.what;
    for (const double t : front.time) ASSERT_EQ(t, end_time);
    if (threads == 1) {
      seal = witness.seal();
      patches = status.patches;
      position = front.position;
    }
    EXPECT_EQ(witness.seal(), seal) << threads << " threads";
    EXPECT_EQ(status.patches, patches);
    EXPECT_EQ(front.position, position);
  }
  base::set_thread_count(1);
}

TEST(SpacetimeScheduler, SameBitsForAnyNumberOfThreads) {
  expect_same_bits<1>(line(200, 0.4), {}, 0.5, false);
  expect_same_bits<2>(delaunay(300, 5), {.progress = Progress::budget}, 0.2, false);
  expect_same_bits<2>(grid(12, 0.3), {.progress = Progress::high_mid, .smoothing = 0.2}, 0.3, false);
  expect_same_bits<2>(grid(12, 0.3), {.progress = Progress::budget, .smoothing = 0.2}, 0.3, true);
  expect_same_bits<3>(cube(4, 0.15), {}, 0.2, false);
  auto cracked = grid(12);
  ASSERT_TRUE(add_crack(cracked, std::vector<Point<2>>{{0.25, 0.5}, {0.75, 0.5}}).ok);
  expect_same_bits<2>(cracked, {}, 0.3, true);
}

TEST(SpacetimeScheduler, StoppingAndGoingOnChangesNothing) {
  // A copy of the front is a checkpoint: going on from it repeats the tents.
  SpaceMesh<2> mesh;
  ASSERT_TRUE(mesh.build(grid(8, 0.3)).ok);
  const Pitcher<2> pitcher(mesh, {.progress = Progress::budget});
  base::set_thread_count(1);
  Front<2> front = pitcher.level_front(0.0);
  Witness<2> witness(mesh);
  Scheduler<2> scheduler(pitcher);
  std::int64_t seen = 0;
  Front<2> saved;
  Witness<2> saved_witness(mesh);
  ASSERT_TRUE(scheduler
                  .advance(front, 0.4,
                           [&](const Patch<2>& patch) {
                             if (++seen == 300) {
                               saved = front;
                               saved_witness = witness;
                             }
                             return witness(patch);
                           })
                  .ok);
  ASSERT_GT(seen, 400);
  for (const int threads : {1, 3}) {
    base::set_thread_count(threads);
    Front<2> again = saved;
    Witness<2> other = saved_witness;
    const FrontStatus status = scheduler.advance(again, 0.4, std::ref(other));
    EXPECT_EQ(status.patches, seen - 299);
    EXPECT_EQ(other.seal(), witness.seal());
  }
  base::set_thread_count(1);
}

TEST(SpacetimeScheduler, NamesTheEarliestFailureForAnyNumberOfThreads) {
  SpaceMesh<2> mesh;
  ASSERT_TRUE(mesh.build(delaunay(300, 5)).ok);
  const Pitcher<2> pitcher(mesh, {});
  // The tents up to the first failure are those of a run without: the earliest that will fail is known from
  // it.
  Key earliest{.time = 1e30, .rank = 0};
  Vertex first = -1;
  base::set_thread_count(1);
  Front<2> whole = pitcher.level_front(0.0);
  ASSERT_TRUE(Scheduler<2>(pitcher)
                  .advance(whole, 0.5,
                           [&](const Patch<2>& patch) {
                             const Key key{.time = patch.foot[2], .rank = mesh.rank(patch.pole)};
                             if (patch.pole % 7 == 3 && key.time > 0.1 && key < earliest) {
                               earliest = key;
                               first = patch.pole;
                             }
                             return Verdict{};
                           })
                  .ok);
  for (const int threads : {1, 2, 3, 7}) {
    base::set_thread_count(threads);
    Front<2> front = pitcher.level_front(0.0);
    Witness<2> witness(mesh);
    witness.fail_after = 0.1;
    const FrontStatus status = Scheduler<2>(pitcher).advance(front, 0.5, std::ref(witness));
    EXPECT_FALSE(status.ok);
    EXPECT_EQ(status.what, "no more");
    EXPECT_GT(status.bound, 0.0);
    EXPECT_EQ(status.vertex, first);
    EXPECT_EQ(status.time, earliest.time);
    for (Simplex s = 0; s < mesh.simplex_count(); ++s)
      EXPECT_LE(pitcher.strain_on_bounds(front, s), 1.0 + 1e-9);
    witness.fail_after = 1e30;  // and on it goes
    EXPECT_TRUE(Scheduler<2>(pitcher).advance(front, 0.5, std::ref(witness)).ok);
  }
  base::set_thread_count(1);
}

TEST(SpacetimeScheduler, NamesVerticesThatSlowDown) {
  // With a tiny eps the front may become nearly as steep as causality allows: a few vertices crawl.
  SpaceMesh<2> mesh;
  ASSERT_TRUE(mesh.build(delaunay(150, 2)).ok);
  const auto slowed = [&](double eps, int threads) {
    base::set_thread_count(threads);
    const Pitcher<2> pitcher(mesh, {.eps = eps});
    Front<2> front = pitcher.level_front(0.0);
    std::vector<double> first(front.time.size(), 0.0);
    std::vector<Vertex> low;
    const FrontStatus status = Scheduler<2>(pitcher).advance(front, 0.5, [&](const Patch<2>& patch) {
      double& height = first[static_cast<std::size_t>(patch.pole)];
      if (height == 0.0) height = patch.top[2] - patch.foot[2];
      if (patch.top[2] < 0.4 && patch.top[2] - patch.foot[2] < 0.05 * height && threads == 1)
        low.push_back(patch.pole);
      return Verdict{};
    });
    EXPECT_TRUE(status.ok);
    for (const Vertex v : low) EXPECT_TRUE(std::binary_search(status.slowed.begin(), status.slowed.end(), v));
    return status.slowed;
  };
  const auto crawling = slowed(0.001, 1);
  EXPECT_FALSE(crawling.empty());
  EXPECT_LT(crawling.size(), 20u);
  EXPECT_EQ(slowed(0.001, 3), crawling);
  EXPECT_TRUE(slowed(0.1, 1).empty());
  base::set_thread_count(1);
}

TEST(SpacetimeScheduler, RecordsWhatEachTentNeeds) {
  SpaceMesh<2> mesh;
  ASSERT_TRUE(mesh.build(grid(20, 0.25)).ok);
  const Pitcher<2> pitcher(mesh, {});
  ScheduleRecord serial;
  for (const int threads : {1, 3}) {
    base::set_thread_count(threads);
    Front<2> front = pitcher.level_front(0.0);
    Witness<2> witness(mesh);
    ScheduleRecord record;
    const FrontStatus status = Scheduler<2>(pitcher).advance(front, 0.3, std::ref(witness), &record);
    ASSERT_EQ(static_cast<std::int64_t>(record.tents.size()), status.patches);
    if (threads == 1) serial = record;
    EXPECT_EQ(record.needed, serial.needed);
    for (std::size_t i = 0; i < record.tents.size(); ++i) {
      EXPECT_EQ(record.tents[i].pole, serial.tents[i].pole);
      EXPECT_EQ(record.tents[i].top, serial.tents[i].top);
      for (auto k = record.first_needed(i); k < record.first_needed(i + 1); ++k) {
        const auto needed = static_cast<std::size_t>(record.needed[static_cast<std::size_t>(k)]);
        EXPECT_LT(needed, i);
        const Vertex pole = record.tents[needed].pole;
        const auto around = mesh.neighbours(record.tents[i].pole);
        EXPECT_TRUE(pole == record.tents[i].pole ||
                    std::find(around.begin(), around.end(), pole) != around.end());
      }
    }
  }
  base::set_thread_count(1);

  for (auto& tent : serial.tents) tent.duration = 1.0;
  const Replay one = replay(serial, 1), four = replay(serial, 4), many = replay(serial, 4096);
  EXPECT_DOUBLE_EQ(one.makespan, static_cast<double>(serial.tents.size()));
  EXPECT_DOUBLE_EQ(one.efficiency, 1.0);
  EXPECT_GT(four.efficiency, 0.95);  // 110 vertices of the front per worker
  EXPECT_DOUBLE_EQ(many.makespan, many.longest);
  EXPECT_LT(many.longest, one.makespan / 20.0);
}

TEST(SpacetimeScheduler, ReplaysAChainAndAFork) {
  // 0 -> 1 -> 3, 0 -> 2 -> 3 with durations 1, 2, 3, 4.
  ScheduleRecord record;
  record.tents = {{.duration = 1.0, .first_needed = 0},
                  {.duration = 2.0, .first_needed = 0},
                  {.duration = 3.0, .first_needed = 1},
                  {.duration = 4.0, .first_needed = 2}};
  record.needed = {0, 0, 1, 2};
  EXPECT_DOUBLE_EQ(replay(record, 1).makespan, 10.0);
  EXPECT_DOUBLE_EQ(replay(record, 2).makespan, 8.0);
  EXPECT_DOUBLE_EQ(replay(record, 2).longest, 8.0);
  EXPECT_DOUBLE_EQ(replay(record, 2).efficiency, 10.0 / 16.0);
  EXPECT_DOUBLE_EQ(replay({}, 2).makespan, 0.0);
}

TEST(SpacetimePatch, FaultsAreSeen) {
  SpaceMesh<2> mesh;
  ASSERT_TRUE(mesh.build(grid(4, 0.2)).ok);
  const Pitcher<2> pitcher(mesh, {});
  Front<2> front = pitcher.level_front(0.0);
  const Vertex inner = 12, rim = 2;
  Patch<2> patch;
  const auto build = [&](Vertex v) { build_patch(mesh, front, pitcher.pitch(front, v, 10.0), patch); };
  build(inner);
  EXPECT_EQ(fault_of(mesh, patch), "");
  EXPECT_EQ(patch.facets.size(), 4 * patch.elements.size());
  for (const auto& facet : patch.facets) EXPECT_NE(facet.kind, FacetKind::boundary);
  patch.elements[0].volume = 0.0;
  EXPECT_NE(fault_of(mesh, patch).find("volume"), std::string::npos);
  build(inner);
  patch.facets[2].normal[0] *= 1.001;
  EXPECT_NE(fault_of(mesh, patch).find("normals differ"), std::string::npos);
  build(inner);
  patch.facets[2].twin = patch.facets[3].twin;
  EXPECT_NE(fault_of(mesh, patch).find("wrong element"), std::string::npos);
  build(inner);
  patch.facets[0].normal[2] *= 1.001;
  EXPECT_NE(fault_of(mesh, patch).find("closed"), std::string::npos);
  Pole<2> high = pitcher.pitch(front, inner, 10.0);
  high.top[2] *= 1.2;
  build_patch(mesh, front, high, patch);
  EXPECT_NE(fault_of(mesh, patch).find("ends in a front steeper"), std::string::npos);
  front.time[inner] = high.top[2];
  build(7);  // a neighbour of the steep vertex
  EXPECT_NE(fault_of(mesh, patch).find("stands on a front steeper"), std::string::npos);
  front.time[inner] = 0.0;
  build(rim);
  EXPECT_EQ(fault_of(mesh, patch), "");
  Pole<2> leaning = pitcher.pitch(front, rim, 10.0);
  leaning.top[1] += 0.01;
  build_patch(mesh, front, leaning, patch);
  EXPECT_NE(fault_of(mesh, patch).find("leans"), std::string::npos);
}

}  // namespace
}  // namespace cleave::discretisation::spacetime::sample
