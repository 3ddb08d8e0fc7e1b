#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

namespace proof {

/// A seed at which the planner exceeds limits by a known fault, and by how much: greatest values
/// as ratios of their limits, 0 for a limit that is kept. known_excess_test.cpp runs these seeds,
/// the random tests leave them out.
struct KnownExcess {
  std::uint64_t seed;
  double jerk;
  double acceleration;  ///< Of an axis.
  double speed_change;  ///< Of an axis between slices.
};

/// Operators that change the pace where a curve needs all jerk: Job and Meddler.
inline constexpr std::array<KnownExcess, 1> kOperatorExcess{{
    {3008, 1.0374444, 1.0040653, 0.0},
}};

/// Programs without a limit of jerk: WeldedJob.
inline constexpr std::array<KnownExcess, 1> kProgramExcess{{
    {54'432, 0.0, 0.0, 1.0032552},
}};

[[nodiscard]] inline bool is_known(std::span<const KnownExcess> known, std::uint64_t seed) {
  return std::ranges::count(known, seed, &KnownExcess::seed) != 0;
}

}  // namespace proof
