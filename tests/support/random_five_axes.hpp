#pragma once

#include <utility>
#include <vector>

#include "firmware/machine/settings.hpp"
#include "tests/support/random_source.hpp"

namespace proof {

/// Returns the settings of a five-axis machine of a kind ($900), with levers of up to 200 mm in
/// each direction.
[[nodiscard]] inline std::vector<std::pair<int, double>> random_five_axes(Random& random,
                                                                          int kind) {
  std::vector<std::pair<int, double>> settings{{cnc::setting::kRotaryAxes, kind},
                                               {cnc::setting::kRotaryReversed, random.below(4)}};
  for (int i = 0; i < 3; ++i) {
    settings.emplace_back(cnc::setting::kTiltPoint + i, random.between(-200.0, 200.0));
    settings.emplace_back(cnc::setting::kTurnPoint + i, random.between(-200.0, 200.0));
  }
  return settings;
}

}  // namespace proof
