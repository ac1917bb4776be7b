#include "discretisation/spacetime/schedule_record.hpp"

#include <algorithm>
#include <queue>

#include "base/assert.hpp"

namespace cleave::discretisation::spacetime {

Replay replay(const ScheduleRecord& record, int workers) {
  CLEAVE_ASSERT(workers > 0, "a replay needs a worker");
  const std::size_t count = record.tents.size();
  Replay result;
  if (count == 0) return result;

  // Turn "needs" into "allows".
  std::vector<std::int32_t> waiting(count, 0), start(count + 1, 0), allowed(record.needed.size());
  for (const std::int32_t needed : record.needed) ++start[static_cast<std::size_t>(needed) + 1];
  for (std::size_t i = 0; i < count; ++i) start[i + 1] += start[i];
  std::vector<std::int32_t> next(start.begin(), start.end() - 1);
  std::vector<double> chain(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    double before = 0.0;
    for (std::int64_t k = record.first_needed(i); k < record.first_needed(i + 1); ++k) {
      const auto needed = static_cast<std::size_t>(record.needed[static_cast<std::size_t>(k)]);
      allowed[static_cast<std::size_t>(next[needed]++)] = static_cast<std::int32_t>(i);
      ++waiting[i];
      before = std::max(before, chain[needed]);
    }
    chain[i] = before + record.tents[i].duration;
    result.longest = std::max(result.longest, chain[i]);
    result.work += record.tents[i].duration;
  }

  using Finish = std::pair<double, std::int32_t>;
  std::priority_queue<Finish, std::vector<Finish>, std::greater<>> running;
  std::priority_queue<std::int32_t, std::vector<std::int32_t>, std::greater<>>
      ready;  // tents are in foot order
  for (std::size_t i = 0; i < count; ++i)
    if (waiting[i] == 0) ready.push(static_cast<std::int32_t>(i));
  double now = 0.0;
  while (!ready.empty() || !running.empty()) {
    while (!ready.empty() && running.size() < static_cast<std::size_t>(workers)) {
      const std::int32_t i = ready.top();
      ready.pop();
      running.emplace(now + record.tents[static_cast<std::size_t>(i)].duration, i);
    }
    now = running.top().first;
    const auto done = static_cast<std::size_t>(running.top().second);
    running.pop();
    for (std::int32_t k = start[done]; k < start[done + 1]; ++k) {
      const std::int32_t i = allowed[static_cast<std::size_t>(k)];
      if (--waiting[static_cast<std::size_t>(i)] == 0) ready.push(i);
    }
  }
  result.makespan = now;
  result.efficiency = result.work / (static_cast<double>(workers) * now);
  return result;
}

}  // namespace cleave::discretisation::spacetime
