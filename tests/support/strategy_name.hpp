#pragma once

#include <string>

#include "host-sim/pocket/strategy.hpp"

namespace proof {

/// Returns the name of a strategy for the names of tests.
inline std::string strategy_name(sim::pocket::Strategy strategy) {
  switch (strategy) {
    case sim::pocket::Strategy::kContour:
      return "Contour";
    case sim::pocket::Strategy::kSpiral:
      return "Spiral";
    case sim::pocket::Strategy::kAdaptive:
      return "Adaptive";
    case sim::pocket::Strategy::kZigzag:
      return "Zigzag";
    default:
      return "Paper";
  }
}

}  // namespace proof
