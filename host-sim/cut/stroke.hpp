#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/import/place.hpp"

namespace sim::cut {

using drawing::Place;

/// What a stretch of a cut is for.
enum class Purpose : std::uint8_t {
  kPierce,   ///< The first bit of the lead-in, or of the contour, slowly.
  kLeadIn,   ///< From the waste to the contour.
  kContour,  ///< Along the edge of the part.
  kTab,      ///< Along it too, with the beam off.
  kOvercut,  ///< Once more along where the contour began.
  kLeadOut,  ///< From the contour into the waste.
};

/// A line or arc that the beam is driven along; bulge = tan(sweep / 4), positive to the left,
/// of any size.
struct Stroke {
  Place from{0.0, 0.0};
  Place to{0.0, 0.0};
  double bulge = 0.0;
  Purpose purpose = Purpose::kContour;
};

/// mm.
[[nodiscard]] double length_of(const Stroke& stroke);

/// Where the stroke is after a share of its length, 0…1, and the unit way it goes there.
[[nodiscard]] Place place_at(const Stroke& stroke, double share);
[[nodiscard]] Place tangent_at(const Stroke& stroke, double share);

/// From one share to the other. @pre 0 ≤ from < to ≤ 1
[[nodiscard]] Stroke part_of(const Stroke& stroke, double from, double to);

/// How far a place is from the nearest of the stroke, mm.
[[nodiscard]] double distance_to(const Stroke& stroke, const Place& place);

/// What of a row of strokes lies between two lengths from its start, mm; ends that are
/// met within a nanometre are not cut off.
[[nodiscard]] std::vector<Stroke> stretch_of(const std::vector<Stroke>& row,
                                             double from_mm,
                                             double to_mm);

[[nodiscard]] double length_of(const std::vector<Stroke>& row);

}  // namespace sim::cut
