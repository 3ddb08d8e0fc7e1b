#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace proof {

/// A seed with which the planner exceeds limits by a known fault, with the greatest values as
/// ratios to their limits; 0 means that the limit is kept. known_excess_test.cpp runs these seeds;
/// the random tests skip them.
struct KnownExcess {
  std::uint64_t seed;
  double jerk;
  double acceleration;  ///< Acceleration of an axis.
  double speed_change;  ///< Change of an axis's speed between slices.
};

/// Seeds with an operator (Job and Meddler), who changes the speed where a curve uses all of the
/// jerk limit.
inline constexpr std::array<KnownExcess, 1> kOperatorExcess{{
    {3008, 1.0374444, 1.0040653, 0.0},
}};

/// Seeds of programs without a limit of jerk (WeldedJob).
inline constexpr std::array<KnownExcess, 1> kProgramExcess{{
    {54'432, 0.0, 0.0, 1.0032552},
}};

[[nodiscard]] inline bool is_known(std::span<const KnownExcess> known, std::uint64_t seed) {
  return std::ranges::count(known, seed, &KnownExcess::seed) != 0;
}

}  // namespace proof
