#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/import/place.hpp"

namespace sim::cut {

using drawing::Place;

/// Returns a direction turned by a quarter turn to the right.
[[nodiscard]] inline Place right_of(const Place& way) { return {way.y(), -way.x()}; }

/// The purpose of a stroke in a cut.
enum class Purpose : std::uint8_t {
  kPierce,      ///< The first piece of the lead-in, or of the contour, driven slowly.
  kLeadIn,      ///< From the waste to the contour.
  kContour,     ///< Along the edge of the part.
  kTab,         ///< Along the edge of the part, with the beam off.
  kOvercut,     ///< A second time along the beginning of the contour.
  kLeadOut,     ///< From the contour into the waste.
  kCornerLoop,  ///< Past a corner of the part into the waste, and back to its next edge.
  kLink,        ///< Through the waste from the end of the previous cut, instead of a pierce.
  kSlice,       ///< Across the waste between parts, which divides the waste into pieces.
  kOverscan,    ///< Before, between and after the lines of a filled area, with the beam off.
};

/// Returns whether the beam is on along a stroke.
[[nodiscard]] constexpr bool has_beam(Purpose purpose) {
  return purpose != Purpose::kTab && purpose != Purpose::kOverscan;
}

/// A line or arc along which the beam is driven. The bulge is tan(sweep / 4), positive to the left,
/// of any size.
struct Stroke {
  Place from{0.0, 0.0};
  Place to{0.0, 0.0};
  double bulge = 0.0;
  Purpose purpose = Purpose::kContour;
  double dwell_s = 0.0;  ///< Time that the beam rests off before it follows the stroke.
};

/// Returns the length of a stroke, mm.
[[nodiscard]] double length_of(const Stroke& stroke);

/// Half of a stroke's sweep, radians, and its sine.
struct HalfSweep {
  double angle = 0.0;
  double sine = 0.0;
};
[[nodiscard]] HalfSweep half_sweep_of(const Stroke& stroke);

/// Return the point of a stroke at a share of its length, 0…1, and the unit direction of the stroke
/// there.
[[nodiscard]] Place place_at(const Stroke& stroke, double share);
[[nodiscard]] Place place_at(const Stroke& stroke, const HalfSweep& half, double share);
[[nodiscard]] Place tangent_at(const Stroke& stroke, double share);

/// Returns the part of a stroke from one share of its length to another.
/// @pre 0 ≤ from < to ≤ 1
[[nodiscard]] Stroke part_of(const Stroke& stroke, double from, double to);

/// Returns a stroke in the opposite direction.
[[nodiscard]] Stroke reversed(const Stroke& stroke);

/// Returns the distance of a point to the nearest point of a stroke, mm.
[[nodiscard]] double distance_to(const Stroke& stroke, const Place& place);

[[nodiscard]] double length_of(const std::vector<Stroke>& row);

/// A row of strokes with the distance to the start of each stroke, so that searches need not begin
/// at the start of the row.
class MeasuredRow {
 public:
  explicit MeasuredRow(std::vector<Stroke> row);

  [[nodiscard]] const std::vector<Stroke>& strokes() const { return row_; }
  /// Returns the length of the row, mm.
  [[nodiscard]] double length() const { return ways_.back(); }
  /// Returns the distance along the row to the start of a stroke, or to the end of the row, mm.
  [[nodiscard]] double way_to(std::size_t stroke) const { return ways_[stroke]; }

  /// Returns the strokes between two distances from the start, mm. Ends that are reached within a
  /// nanometre are not cut off.
  [[nodiscard]] std::vector<Stroke> stretch(double from_mm, double to_mm) const;
  /// Returns the strokes of a closed row for one full pass, from a distance on.
  [[nodiscard]] std::vector<Stroke> begun_at(double way_mm) const;
  /// Return the unit direction in which a closed row arrives at a point, and the one in which it
  /// continues.
  [[nodiscard]] Place arriving(double way_mm) const;
  [[nodiscard]] Place leaving(double way_mm) const;
  [[nodiscard]] Place place(double way_mm) const;
  /// Returns the number of the stroke that begins at a distance from the start, or contains this
  /// point.
  [[nodiscard]] std::size_t stroke_at(double way_mm) const;

 private:
  std::vector<Stroke> row_;
  std::vector<HalfSweep> halves_;  ///< Half sweep of each stroke.
  std::vector<double> ways_;       ///< Distances along the row, one more than there are strokes.
};

}  // namespace sim::cut
