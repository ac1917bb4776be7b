#include "base/threads.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <vector>

namespace cleave::base {
namespace {

TEST(Threads, EveryChunkRunsOnceForAnyNumberOfThreads) {
  for (int threads : {1, 2, 3, 7}) {
    set_thread_count(threads);
    EXPECT_EQ(thread_count(), threads);
    std::vector<std::atomic<int>> visits(1000);
    for_each_chunk(visits.size(), [&](std::size_t chunk) { ++visits[chunk]; });
    for (const auto& count : visits) EXPECT_EQ(count.load(), 1);
  }
}

TEST(Threads, RangesCoverAllAndDoNotDependOnThreads) {
  for (int threads : {1, 3}) {
    set_thread_count(threads);
    std::vector<int> owner(1003, -1);
    for_each_range(owner.size(), 100, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) owner[i] = static_cast<int>(begin);
    });
    for (std::size_t i = 0; i < owner.size(); ++i) EXPECT_EQ(owner[i], static_cast<int>(i / 100 * 100));
  }
}

TEST(Threads, FedItemsRunOnceAndSeeWhatFedThem) {
  // A binary tree of items, each fed by its parent, whose plain write the child must see.
  for (int threads : {1, 2, 3, 7}) {
    set_thread_count(threads);
    std::vector<int> visits(1000, 0);
    for_each_fed({1}, [&](std::int32_t item, Feed& feed) {
      const auto i = static_cast<std::size_t>(item);
      visits[i] = i == 1 ? 1 : visits[i / 2] + 1;
      for (std::int32_t child = 2 * item; child < 2 * item + 2; ++child)
        if (child < 1000) feed.add(child);
    });
    for (std::size_t i = 1; i < visits.size(); ++i) EXPECT_EQ(visits[i], i == 1 ? 1 : visits[i / 2] + 1);
    for_each_fed({}, [&](std::int32_t, Feed&) { ADD_FAILURE(); });
  }
}

TEST(Threads, NestedLoopsAndEmptyLoopsAreFine) {
  set_thread_count(2);
  std::atomic<int> count{0};
  for_each_chunk(0, [&](std::size_t) { ++count; });
  for_each_chunk(4, [&](std::size_t) { for_each_chunk(5, [&](std::size_t) { ++count; }); });
  EXPECT_EQ(count.load(), 20);
}

}  // namespace
}  // namespace cleave::base
