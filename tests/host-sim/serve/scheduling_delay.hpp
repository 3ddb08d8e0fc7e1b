#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

namespace sim {

/// Returns the milliseconds for which a thread of this process was ready to run and waited for a
/// processor, by the kernel's accounting. Other work on the machine increases this time; a thread
/// that blocks, sleeps or works does not.
inline std::chrono::duration<double, std::milli> scheduling_delay(pid_t thread) {
  std::ifstream account{fmt::format("/proc/self/task/{}/schedstat", thread)};
  double worked_ns = 0.0;
  double waited_ns = 0.0;
  account >> worked_ns >> waited_ns;
  return std::chrono::duration<double, std::nano>{waited_ns};
}

}  // namespace sim
