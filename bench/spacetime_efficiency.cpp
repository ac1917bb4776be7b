// Error against cost of the three local spaces on the standing P wave; a line of figures for each run.
// bench_spacetime_efficiency [END [SECONDS [REPEAT [SPACE]]]]: time of the wave, the longest run worth
// waiting for, 1 for tents that repeat and share their operators, one space only.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "spacetime_wave.hpp"

int main(int words, char** word) {
  using namespace cleave::bench;
  const double end = words > 1 ? std::atof(word[1]) : 0.5, longest = words > 2 ? std::atof(word[2]) : 3.0;
  const bool repeat = words > 3 && std::atoi(word[3]) == 1;
  const int only = words > 4 ? std::atoi(word[4]) : -1;
  cleave::base::set_thread_count(1);
  std::printf("space degree n patches us_per_patch seconds error_u error_energy momentum balance\n");
  const char* names[] = {"one_field", "three_fields", "trefftz"};
  for (const LocalSpace space : {LocalSpace::one_field, LocalSpace::three_field, LocalSpace::trefftz})
    for (int p = 1; p <= 5 && (only < 0 || only == static_cast<int>(space)); ++p) {  // of velocity and strain
      double before = 0.0;
      for (int n = 2; n <= 64 && 9.0 * before < longest; n *= 2) {
        Runner runner(squares(n), {{space, space == LocalSpace::three_field ? p : p + 1}});
        runner.repeat = repeat;
        Outcome check;
        if (n <= 4) check = runner.run(end, true, nullptr, true);  // identities, and tables made once
        Outcome out = runner.run(end);
        for (int again = 0; again < (out.cpu < 0.5 ? 4 : 1); ++again)
          out.cpu = std::min(out.cpu, runner.run(end).cpu);
        if (!out.ok) return 1;
        runner.measure(end, out);
        before = out.cpu;
        std::printf("%s %d %d %lld %.2f %.5f %.4e %.4e %.1e %.1e\n", names[static_cast<int>(space)], p, n,
                    static_cast<long long>(out.patches), 1e6 * out.cpu / static_cast<double>(out.patches),
                    out.cpu, out.displacement, out.energy, check.momentum, check.balance);
        std::fflush(stdout);
      }
    }
}
