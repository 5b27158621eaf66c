// The thread pool that builders run on.
#include "host/trace/accel/task_pool.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>

using candela::accel::TaskPool;

TEST_CASE("wait returns after every task, and those that tasks submitted") {
  for (std::uint32_t threadCount : {1u, 2u, 5u}) {
    TaskPool pool(threadCount);
    std::atomic<int> done = 0;
    std::function<void(int)> spawn = [&](int depth) {
      ++done;
      if (depth == 0) return;
      for (int i = 0; i < 2; ++i) pool.submit([&spawn, depth] { spawn(depth - 1); });
    };
    for (int round = 1; round <= 3; ++round) {
      pool.submit([&] { spawn(8); });
      pool.wait();
      CHECK(done == round * 511);
    }
  }
}

TEST_CASE("wait() rethrows a task's exception, and the pool can be used again") {
  for (std::uint32_t threadCount : {1u, 3u}) {
    TaskPool pool(threadCount);
    for (int i = 0; i < 20; ++i) pool.submit([] { throw std::runtime_error("no"); });
    CHECK_THROWS_WITH(pool.wait(), "no");
    bool ran = false;
    pool.submit([&] { ran = true; });
    pool.wait();
    CHECK(ran);
  }
}

TEST_CASE("a pool without tasks terminates") {
  TaskPool pool(4);
  pool.wait();
}
