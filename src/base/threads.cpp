#include "base/threads.hpp"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_for_each.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
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

namespace {

using FedBody = void (*)(const void*, std::int32_t, Feed&);

class Stack final : public Feed {
 public:
  explicit Stack(std::vector<std::int32_t> items) : items_(std::move(items)) {}
  void add(std::int32_t item) override { items_.push_back(item); }
  bool take(std::int32_t& item) {
    if (items_.empty()) return false;
    item = items_.back();
    items_.pop_back();
    return true;
  }

 private:
  std::vector<std::int32_t> items_;
};

#if defined(__SANITIZE_THREAD__)
/// One locked stack for all threads, see run_chunks().
class SharedStack final : public Feed {
 public:
  explicit SharedStack(std::vector<std::int32_t> items) : items_(std::move(items)), left_(items_.size()) {}
  void add(std::int32_t item) override {
    const std::lock_guard lock(mutex_);
    items_.push_back(item);
    ++left_;
    changed_.notify_one();
  }
  bool take(std::int32_t& item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !items_.empty() || left_ == 0; });
    if (items_.empty()) return false;
    item = items_.back();
    items_.pop_back();
    return true;
  }
  void done() {
    const std::lock_guard lock(mutex_);
    if (--left_ == 0) changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::int32_t> items_;
  std::size_t left_;  ///< items waiting or being worked on
};
#else
class TaskFeed final : public Feed {
 public:
  explicit TaskFeed(tbb::feeder<std::int32_t>& feeder) : feeder_(feeder) {}
  void add(std::int32_t item) override { feeder_.add(item); }

 private:
  tbb::feeder<std::int32_t>& feeder_;
};
#endif

}  // namespace

void run_fed(const std::int32_t* seeds, std::size_t count, FedBody body, const void* context) {
  if (count == 0) return;
  if (thread_count() == 1) {
    Stack stack({seeds, seeds + count});
    for (std::int32_t item; stack.take(item);) body(context, item, stack);
    return;
  }
#if defined(__SANITIZE_THREAD__)
  SharedStack stack({seeds, seeds + count});
  std::vector<std::thread> threads;
  for (int i = 0; i < thread_count(); ++i)
    threads.emplace_back([&] {
      for (std::int32_t item; stack.take(item); stack.done()) body(context, item, stack);
    });
  for (std::thread& thread : threads) thread.join();
#else
  arena->execute([&] {
    tbb::parallel_for_each(seeds, seeds + count, [&](std::int32_t item, tbb::feeder<std::int32_t>& feeder) {
      TaskFeed feed(feeder);
      body(context, item, feed);
    });
  });
#endif
}

}  // namespace detail
}  // namespace cleave::base
