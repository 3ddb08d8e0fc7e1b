#pragma once

#include <utility>
#include <vector>

#include "firmware/machine/settings.hpp"
#include "tests/support/random_motors.hpp"

namespace proof {

using SettingValues = std::vector<std::pair<int, double>>;

inline void add_shaper(std::size_t axis,
                       const cnc::motion::ShaperSetting& shaper,
                       SettingValues& settings) {
  const int number = static_cast<int>(axis);
  settings.emplace_back(cnc::setting::kShaper + number, static_cast<double>(shaper.kind));
  settings.emplace_back(cnc::setting::kShaperFrequency + number,
                        static_cast<double>(shaper.frequency_hz));
  settings.emplace_back(cnc::setting::kShaperDamping + number, static_cast<double>(shaper.damping));
}

/// Returns settings of shapers of X, Y and Z, of backlash, or of both.
inline SettingValues random_motor_settings(Random& random) {
  SettingValues settings;
  const std::size_t what = random.below(3);
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    if (what != 1) add_shaper(axis, random_shaper(random), settings);
    if (what == 0 || random.chance(0.2)) continue;
    settings.emplace_back(cnc::setting::kBacklash + static_cast<int>(axis),
                          random.magnitude(0.005, 0.5));
  }
  return settings;
}

}  // namespace proof
