#pragma once

#include <cstdint>

#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// Returns the output over a slice in which the duty goes evenly from one value to another. The
/// output has stairs of equal length, at most 100 µs. Each stair has the height of the slope at the
/// stair's middle. So any whole number of stairs has the energy of the slope, and within a stair at
/// most growth · interval / 8 is missing.
///
/// @param from, to duty, 0…1
/// @param ticks length of the slice; up to 100 µs the output is constant at the mean
[[nodiscard]] PowerCourse power_course(float from, float to, std::uint32_t ticks);

}  // namespace cnc::motion
