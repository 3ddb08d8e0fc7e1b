#pragma once

#include <cstddef>

#include "firmware/machine/settings.hpp"
#include "planner/base/axes.hpp"

namespace sim {

/// Returns the steps of each axis: per mm for X, Y and Z, and per degree for A, B and C.
template <typename Number>
cnc::AxisArray<Number> steps_per_mm(const cnc::Settings& settings) {
  cnc::AxisArray<Number> steps{};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    steps[axis] = settings.get(cnc::setting::kStepsPerMm, axis);
  }
  return steps;
}

}  // namespace sim
