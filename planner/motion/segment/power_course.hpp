#pragma once

#include <cstdint>

#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// Returns the output over a slice in which the duty changes linearly from one value to another.
/// The output is a staircase with stairs of equal duration, at most 100 µs. The level of a stair is
/// the linear duty at the stair's middle. So a whole number of stairs has the energy of the linear
/// duty. Within a stair, the energy differs by at most growth · interval / 8, with the values of
/// PowerCourse.
///
/// @param from, to duty, 0…1
/// @param ticks duration of the slice; if it is at most 100 µs, the output is constant at the mean
[[nodiscard]] PowerCourse power_course(float from, float to, std::uint32_t ticks);

}  // namespace cnc::motion
