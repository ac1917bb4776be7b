// Time per patch as the front grows, with and without the patch solver, on one thread and on two.
// bench_spacetime_scaling [DEGREE [LARGEST [THREADS]]]: P of the Trefftz space, the largest number of
// patches; one number of threads instead of one and two.
#include <cstdio>
#include <cstdlib>

#include "spacetime_wave.hpp"

int main(int words, char** word) {
  using namespace cleave::bench;
  const int degree = words > 1 ? std::atoi(word[1]) : 2;
  const double largest = words > 2 ? std::atof(word[2]) : 1e6;
  std::printf("solver threads n patches us_per_patch us_per_element wall_us_per_patch\n");
  for (const bool solve : {false, true})
    for (const int threads : {1, 2}) {
      if (words > 3 && threads != std::atoi(word[3])) continue;
      for (double patches = 1e4; patches <= largest * 1.01; patches *= 10.0) {
        // About twenty tents on each vertex. Small bodies have more patches on their boundary, with fewer
        // elements.
        const int n = static_cast<int>(std::lround(std::sqrt(patches / 20.0)));
        cleave::base::set_thread_count(threads);
        Runner runner(squares(n), {{LocalSpace::trefftz, degree}});
        const double end = 22.0 / n;
        if (patches < 5e4) runner.run(end, solve);  // memory touched, tables made
        const Outcome out = runner.run(end, solve);
        if (!out.ok) return 1;
        const double scale = 1e6 / static_cast<double>(out.patches);
        std::printf("%s %d %d %lld %.3f %.4f %.3f\n", solve ? "trefftz" : "empty", threads, n,
                    static_cast<long long>(out.patches), out.cpu * scale,
                    1e6 * out.cpu / static_cast<double>(out.elements), out.wall * scale);
        std::fflush(stdout);
      }
    }
}
