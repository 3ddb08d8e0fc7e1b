#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace sim {

/// How late this machine wakes a thread that sleeps a millisecond at a time, beside the loop that is
/// measured: a machine that is busy with other work makes both late, a loop that blocks only itself.
class SchedulingDelay {
 public:
  using Clock = std::chrono::steady_clock;
  using Milliseconds = std::chrono::duration<double, std::milli>;

  SchedulingDelay() : thread_{[this] { run(); }} {}
  SchedulingDelay(const SchedulingDelay&) = delete;
  SchedulingDelay& operator=(const SchedulingDelay&) = delete;
  ~SchedulingDelay() {
    ends_ = true;
    thread_.join();
  }

  void restart() { worst_ms_ = 0.0; }
  /// The greatest since restart(), that of a sleep that has not ended yet included.
  [[nodiscard]] Milliseconds worst() const {
    const Milliseconds asleep = Clock::now() - Clock::time_point{Clock::duration{asleep_since_}};
    return Milliseconds{std::max(worst_ms_.load(), asleep.count() - kSleep.count())};
  }

 private:
  static constexpr Milliseconds kSleep{1.0};

  void run() {
    while (!ends_) {
      const auto begin = Clock::now();
      asleep_since_ = begin.time_since_epoch().count();
      std::this_thread::sleep_for(kSleep);
      const Milliseconds passed = Clock::now() - begin;
      worst_ms_ = std::max(worst_ms_.load(), passed.count() - kSleep.count());
    }
  }

  std::atomic<double> worst_ms_{0.0};
  std::atomic<Clock::rep> asleep_since_{Clock::now().time_since_epoch().count()};
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace sim
