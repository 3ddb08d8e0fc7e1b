#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace sim {

/// Calls a worker exactly once with each number below `count`, in as many threads as there are
/// cores. The threads take the numbers in ascending order. The results must not depend on the
/// thread that computes them.
/// @param make_worker function that returns the worker of one thread, which is called with a number
template <typename MakeWorker>
void share_work(std::size_t count, const MakeWorker& make_worker) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    auto worker = make_worker();
    for (std::size_t i = next++; i < count; i = next++) worker(i);
  };
  const std::size_t threads =
      std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), count);
  std::vector<std::future<void>> others;
  for (std::size_t i = 1; i < threads; ++i) others.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& other : others) other.get();
}

}  // namespace sim
