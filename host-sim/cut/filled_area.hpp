#pragma once

#include <cstdint>

#include "host-sim/contour/contour_offset.hpp"

namespace sim::cut {

/// Least mean width of a loop of a filled area, mm. Narrower loops are left out.
inline constexpr double kMinFilledWidthMm = 1.0e-4;

/// Rule that decides which points are inside of contours.
enum class FilledBy : std::uint8_t {
  kOddCount,  ///< Points that an odd number of contours encloses.
  kTurns,     ///< Points around which the windings of all contours do not add up to 0.
};

/// Returns the area inside closed contours as contours that never cross and have the area on their
/// left. Loops of less than 1e-6 mm², and loops narrower than kMinFilledWidthMm, are left out.
/// Throws NoOffset if the outline of the area does not close.
/// @param drawn closed contours, which may cross each other and themselves; not empty
[[nodiscard]] Contour filled_area(const Contour& drawn, FilledBy rule = FilledBy::kOddCount);

}  // namespace sim::cut
