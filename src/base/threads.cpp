#include "base/threads.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace cleave::base {
namespace {

int requested_threads = 0;
std::unique_ptr<tbb::global_control> limit;  // lets more workers than cores run when asked: tests need that
std::unique_ptr<tbb::task_arena> arena;

}  // namespace

void set_thread_count(int count) {
  requested_threads = count > 0 ? count : static_cast<int>(std::thread::hardware_concurrency());
  arena.reset();
  limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                static_cast<std::size_t>(requested_threads));
  arena = std::make_unique<tbb::task_arena>(requested_threads);
}

int thread_count() {
  if (requested_threads == 0) set_thread_count(0);
  return requested_threads;
}

namespace detail {

void run_chunks(std::size_t count, void (*body)(const void*, std::size_t), const void* context) {
  if (count == 0) return;
  if (thread_count() == 1 || count == 1) {
    for (std::size_t chunk = 0; chunk < count; ++chunk) body(context, chunk);
    return;
  }
#if defined(__SANITIZE_THREAD__)
  // The installed oneTBB is not instrumented: the sanitizer would miss its synchronisation and see races
  // where there are none. Plain threads over the same chunks let it judge the bodies, which is what it is
  // here for.
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < thread_count(); ++i)
    threads.emplace_back([&] {
      for (std::size_t chunk; (chunk = next++) < count;) body(context, chunk);
    });
  for (std::thread& thread : threads) thread.join();
#else
  arena->execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t chunk = range.begin(); chunk != range.end(); ++chunk) body(context, chunk);
        },
        tbb::auto_partitioner());
  });
#endif
}

}  // namespace detail
}  // namespace cleave::base
