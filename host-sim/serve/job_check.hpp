#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/settings.hpp"
#include "planner/gcode/interpreter.hpp"

namespace sim {

/// What speaks against running a program, in words for the operator.
struct JobFault {
  std::size_t line = 0;
  std::string message;

  [[nodiscard]] std::string text() const;
};

/// More faults than these say nothing new.
inline constexpr std::size_t kMostJobFaults = 20;

/// Reads a program as the controller would now, with its place, offsets and modes in `reader`,
/// and reports every line that it would refuse and, axis by axis, the first line that goes beyond
/// the travel ($130…), whether or not soft limits are on. Of an axis that is not homed nobody
/// knows where it may go: its extent counts.
/// @param homed bit i for axis i
[[nodiscard]] std::vector<JobFault> job_faults(std::string_view program,
                                               cnc::gcode::Interpreter reader,
                                               const cnc::Settings& settings,
                                               std::uint8_t homed);

}  // namespace sim
