#pragma once

#include <cstdint>

#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// The output over a slice in which the duty goes evenly from one value to
/// another: stairs of equal length, at most 100 µs, each as high as the slope
/// in its middle. So any whole number of stairs carries the slope's energy, and
/// what is lacking at their ends is at most growth · interval / 8.
///
/// @param from, to duty, 0…1.
/// @param ticks of the slice; a tick or none is as long as its mean.
[[nodiscard]] PowerCourse power_course(float from, float to, std::uint32_t ticks);

}  // namespace cnc::motion
