// How many workers a front feeds: the tents of one run with their durations, replayed on ideal workers.
// bench_spacetime_schedule [N [DEGREE]]: squares along a side, P of the Trefftz space; 0 for tents of equal
// cost.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "spacetime_wave.hpp"

int main(int words, char** word) {
  using namespace cleave::bench;
  const int n = words > 1 ? std::atoi(word[1]) : 200, degree = words > 2 ? std::atoi(word[2]) : 2;
  cleave::base::set_thread_count(1);
  Runner runner(squares(n), {{LocalSpace::trefftz, std::max(degree, 1)}});
  ScheduleRecord record;
  const Outcome out = runner.run(8.0 / n, degree > 0, &record);
  if (!out.ok) return 1;
  // What interrupted a tent is no property of the tent: no duration counts more than four times the median.
  std::vector<double> duration;
  for (auto& tent : record.tents) duration.push_back(degree > 0 ? tent.duration : 1e-6);
  std::nth_element(duration.begin(), duration.begin() + static_cast<std::ptrdiff_t>(duration.size() / 2),
                   duration.end());
  const double median = duration[duration.size() / 2];
  for (auto& tent : record.tents) tent.duration = degree > 0 ? std::min(tent.duration, 4.0 * median) : median;
  const int vertices = runner.mesh().vertex_count();
  std::printf("%d vertices, %zu tents, median %.1f us\nworkers vertices/worker efficiency\n", vertices,
              record.tents.size(), 1e6 * median);
  for (int workers = 2; workers <= 4096; workers *= 2)
    std::printf("%d %.0f %.4f\n", workers, double(vertices) / workers, replay(record, workers).efficiency);
}
