#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/import/place.hpp"

namespace sim::cut {

using drawing::Place;

/// Returns the direction that is a quarter turn to the right of `way`.
[[nodiscard]] inline Place right_of(const Place& way) { return {way.y(), -way.x()}; }

/// The purpose of a stroke in a cut.
enum class Purpose : std::uint8_t {
  kPierce,      ///< The first piece of the lead-in or of the contour, at a low feed.
  kLeadIn,      ///< A path from the waste to the contour.
  kContour,     ///< A path along the edge of the part.
  kTab,         ///< A path along the edge of the part with the beam off.
  kOvercut,     ///< A path along the beginning of the contour for a second time.
  kLeadOut,     ///< A path from the contour into the waste.
  kCornerLoop,  ///< A path past a corner of the part into the waste, and back to the next edge.
  kLink,        ///< A path through the waste from the end of the previous cut, instead of a pierce.
  kSlice,       ///< A path across the waste between parts, which divides the waste into pieces.
  kOverscan,    ///< A path before, between or after the lines of a filled area, with the beam off.
};

/// Returns whether the beam is on along a stroke of this purpose.
[[nodiscard]] constexpr bool has_beam(Purpose purpose) {
  return purpose != Purpose::kTab && purpose != Purpose::kOverscan;
}

/// A line or arc along which the head is driven. The bulge is tan(sweep / 4), positive to the left,
/// of any size.
struct Stroke {
  Place from{0.0, 0.0};
  Place to{0.0, 0.0};
  double bulge = 0.0;
  Purpose purpose = Purpose::kContour;
  double dwell_s = 0.0;  ///< Time for which the beam rests with its power off before the stroke.
};

/// Returns the length of a stroke, mm.
[[nodiscard]] double length_of(const Stroke& stroke);

/// Half of a stroke's sweep, radians, and the sine of this half.
struct HalfSweep {
  double angle = 0.0;
  double sine = 0.0;
};
[[nodiscard]] HalfSweep half_sweep_of(const Stroke& stroke);

/// Return the point at a share of a stroke's length, 0…1, and the unit direction of the stroke at
/// this point.
[[nodiscard]] Place place_at(const Stroke& stroke, double share);
[[nodiscard]] Place place_at(const Stroke& stroke, const HalfSweep& half, double share);
[[nodiscard]] Place tangent_at(const Stroke& stroke, double share);

/// Returns the part of a stroke between two shares of its length.
/// @pre 0 ≤ from < to ≤ 1
[[nodiscard]] Stroke part_of(const Stroke& stroke, double from, double to);

/// Returns a stroke that is driven in the opposite direction.
[[nodiscard]] Stroke reversed(const Stroke& stroke);

/// Returns the distance of a point from the nearest point of a stroke, mm.
[[nodiscard]] double distance_to(const Stroke& stroke, const Place& place);

[[nodiscard]] double length_of(const std::vector<Stroke>& row);

/// A row of strokes, with the distance along the row to the start of each stroke. Thanks to these
/// distances, a search for a point need not begin at the start of the row.
class MeasuredRow {
 public:
  explicit MeasuredRow(std::vector<Stroke> row);

  [[nodiscard]] const std::vector<Stroke>& strokes() const { return row_; }
  /// Returns the length of the row, mm.
  [[nodiscard]] double length() const { return ways_.back(); }
  /// Returns the distance along the row to the start of a stroke, or to the end of the row, mm.
  [[nodiscard]] double way_to(std::size_t stroke) const { return ways_[stroke]; }

  /// Returns the strokes between two distances from the start. At both ends, rests of strokes
  /// shorter than a nanometre are not cut off.
  [[nodiscard]] std::vector<Stroke> stretch(double from_mm, double to_mm) const;
  /// Returns the strokes of a closed row, from the point at `way_mm` once around to the same point.
  [[nodiscard]] std::vector<Stroke> begun_at(double way_mm) const;
  /// Return the unit direction in which a closed row arrives at a point, and the unit direction in
  /// which it continues from there.
  [[nodiscard]] Place arriving(double way_mm) const;
  [[nodiscard]] Place leaving(double way_mm) const;
  [[nodiscard]] Place place(double way_mm) const;
  /// Returns the number of the stroke that contains the point at `way_mm`, or that begins there.
  [[nodiscard]] std::size_t stroke_at(double way_mm) const;

 private:
  std::vector<Stroke> row_;
  std::vector<HalfSweep> halves_;  ///< Half of the sweep of each stroke.
  /// Distances along the row to the start of each stroke, and to the end.
  std::vector<double> ways_;
};

}  // namespace sim::cut
