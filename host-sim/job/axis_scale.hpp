#pragma once

#include <cstddef>

#include "firmware/machine/settings.hpp"
#include "planner/base/axes.hpp"

namespace sim {

/// Returns steps per mm for X Y Z and steps per degree for A B C.
template <typename Number>
cnc::AxisArray<Number> steps_per_mm(const cnc::Settings& settings) {
  cnc::AxisArray<Number> steps{};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    steps[axis] = settings.get(cnc::setting::kStepsPerMm, axis);
  }
  return steps;
}

}  // namespace sim
