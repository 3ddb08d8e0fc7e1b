#pragma once

#include <cstdint>

#include "host-sim/contour/contour_offset.hpp"

namespace sim::cut {

/// Loops narrower than this on average are left out of a filled area, mm.
inline constexpr double kLeastFilledWidthMm = 1.0e-4;

/// The places that are inside of contours.
enum class FilledBy : std::uint8_t {
  kOddCount,  ///< Those that an odd number of contours encloses.
  kTurns,     ///< Those around which the turns of all contours are not 0 in all.
};

/// Returns the area inside of closed contours, on the left of its own contours, which never cross:
/// loops of less than 1e-6 mm² are left out, and those narrower than kLeastFilledWidthMm. Throws
/// NoOffset where what they enclose does not close.
/// @param drawn closed contours, which may cross each other and themselves; not empty
[[nodiscard]] Contour filled_area(const Contour& drawn, FilledBy rule = FilledBy::kOddCount);

}  // namespace sim::cut
