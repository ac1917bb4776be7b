#include "base/threads.hpp"

#include <memory>
#include <thread>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

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
  arena->execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t chunk = range.begin(); chunk != range.end(); ++chunk) body(context, chunk);
        },
        tbb::auto_partitioner());
  });
}

}  // namespace detail
}  // namespace cleave::base
