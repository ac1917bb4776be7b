#pragma once
/// Pitches a whole slab without solving anything, and accounts for every tent.

#include <gtest/gtest.h>

#include <cstdio>

#include "base/threads.hpp"
#include "discretisation/spacetime/scheduler.hpp"
#include "spacetime_meshes.hpp"

namespace cleave::discretisation::spacetime::sample {

/// What a run over a whole slab told.
struct Account {
  FrontStatus status;
  double volume = 0.0;              ///< of all tents
  double least_gain = 1e30;         ///< least ratio of height to what was sure
  double least = 1e30, most = 0.0;  ///< heights
  double strain = 0.0;              ///< largest ratio of a slope to its bound
  std::int64_t inclined = 0;
  std::string fault;
  bool level = true;
};

/// Pitches from 0 to end_time on one thread and checks every tent.
template <int D>
Account pitch_all(const SpaceMesh<D>& mesh, const PitchOptions& options, double end_time) {
  base::set_thread_count(1);
  const Pitcher<D> pitcher(mesh, options);
  Front<D> front = pitcher.level_front(0.0);
  Account account;
  Vertex last = -1;
  const auto check_star = [&] {
    if (last < 0) return;
    for (const Simplex s : mesh.star(last))
      account.strain = std::max(account.strain, pitcher.strain_on_bounds(front, s));
  };
  std::int64_t tents = 0;
  account.status = Scheduler<D>(pitcher).advance(front, end_time, [&](const Patch<D>& patch) -> Verdict {
    check_star();
    last = patch.pole;
    if (++tents > 200000) return {.kind = Verdict::fail, .what = "too many tents"};
    if (account.fault.empty()) account.fault = fault_of(mesh, patch);
    for (const auto& element : patch.elements) account.volume += element.volume;
    const double height = patch.top[D] - patch.foot[D];
    // Tents that the end cuts short are half of what is left, or all of it.
    const double sure = pitcher.sure_gain(front, patch.pole), left = end_time - patch.foot[D];
    if (height < 0.5 * left * (1.0 - 1e-9) && sure > 0.0 && options.smoothing == 0.0)
      account.least_gain = std::min(account.least_gain, height / sure);
    account.least = std::min(account.least, height);
    account.most = std::max(account.most, height);
    double moved = 0.0;
    for (std::size_t k = 0; k < D; ++k) moved += std::abs(patch.top[k] - patch.foot[k]);
    account.inclined += moved > 0.0;
    return {};
  });
  check_star();
  for (const double t : front.time) account.level &= t == end_time;
  return account;
}

template <int D>
void expect_whole_slab(const SpaceMeshInput<D>& input, PitchOptions options, double end_time,
                       const char* name, bool print = true) {
  SpaceMesh<D> mesh;
  const MeshFault fault = mesh.build(input);
  ASSERT_TRUE(fault.ok) << name << ": " << fault.what;
  const Account a = pitch_all(mesh, options, end_time);
  EXPECT_TRUE(a.status.ok) << name << ": " << a.status.what << " at " << a.status.vertex
                           << ", t = " << a.status.time;
  EXPECT_TRUE(a.level) << name;
  EXPECT_EQ(a.fault, "") << name;
  const double exact = mesh.volume() * end_time;
  EXPECT_NEAR(a.volume, exact, 1e-12 * exact) << name;
  EXPECT_GE(a.least_gain, 1.0 - 1e-9) << name;
  EXPECT_LE(a.strain, 1.0 + 1e-9) << name;
  if (print)
    std::printf("%-26s eps %.1f: %7lld tents, least gain / sure %.3f, slope / bound %.6f\n", name,
                options.eps, static_cast<long long>(a.status.patches), a.least_gain, a.strain);
}

inline const char* word(Progress p) {
  return p == Progress::high_mid ? "high-mid" : p == Progress::subsimplex ? "sub-simplex" : "budget";
}

}  // namespace cleave::discretisation::spacetime::sample
