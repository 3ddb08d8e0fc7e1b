#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/import/place.hpp"

namespace sim::cut {

using drawing::Place;

/// A quarter turn to the right.
[[nodiscard]] inline Place right_of(const Place& way) { return {way.y(), -way.x()}; }

/// What a stretch of a cut is for.
enum class Purpose : std::uint8_t {
  kPierce,      ///< The first bit of the lead-in, or of the contour, slowly.
  kLeadIn,      ///< From the waste to the contour.
  kContour,     ///< Along the edge of the part.
  kTab,         ///< Along it too, with the beam off.
  kOvercut,     ///< Once more along where the contour began.
  kLeadOut,     ///< From the contour into the waste.
  kCornerLoop,  ///< Past a corner of the part into the waste, and back to its next edge.
  kLink,        ///< Through the waste from the end of the cut before, instead of a pierce.
  kSlice,       ///< Across the waste between parts, which makes pieces of it.
  kOverscan,    ///< Before, between and after the lines of a filled area, with the beam off.
};

/// Returns whether the beam is on along a stretch.
[[nodiscard]] constexpr bool has_beam(Purpose purpose) {
  return purpose != Purpose::kTab && purpose != Purpose::kOverscan;
}

/// A line or arc that the beam is driven along; bulge = tan(sweep / 4), positive to the left,
/// of any size.
struct Stroke {
  Place from{0.0, 0.0};
  Place to{0.0, 0.0};
  double bulge = 0.0;
  Purpose purpose = Purpose::kContour;
  double dwell_s = 0.0;  ///< The beam rests dark for so long before it goes along.
};

/// mm.
[[nodiscard]] double length_of(const Stroke& stroke);

/// Half of a stroke's sweep, radians, and its sine.
struct HalfSweep {
  double angle = 0.0;
  double sine = 0.0;
};
[[nodiscard]] HalfSweep half_sweep_of(const Stroke& stroke);

/// Where the stroke is after a share of its length, 0…1, and the unit way it goes there.
[[nodiscard]] Place place_at(const Stroke& stroke, double share);
[[nodiscard]] Place place_at(const Stroke& stroke, const HalfSweep& half, double share);
[[nodiscard]] Place tangent_at(const Stroke& stroke, double share);

/// From one share to the other. @pre 0 ≤ from < to ≤ 1
[[nodiscard]] Stroke part_of(const Stroke& stroke, double from, double to);

/// The same from its end to its start.
[[nodiscard]] Stroke reversed(const Stroke& stroke);

/// How far a place is from the nearest of the stroke, mm.
[[nodiscard]] double distance_to(const Stroke& stroke, const Place& place);

[[nodiscard]] double length_of(const std::vector<Stroke>& row);

/// A row of strokes with the way to each of them, so that nothing is looked for from the start.
class MeasuredRow {
 public:
  explicit MeasuredRow(std::vector<Stroke> row);

  [[nodiscard]] const std::vector<Stroke>& strokes() const { return row_; }
  /// mm.
  [[nodiscard]] double length() const { return ways_.back(); }
  /// From the start of the row to that of a stroke, or to the end of the row, mm.
  [[nodiscard]] double way_to(std::size_t stroke) const { return ways_[stroke]; }

  /// What lies between two lengths from the start, mm; ends that are met within a nanometre
  /// are not cut off.
  [[nodiscard]] std::vector<Stroke> stretch(double from_mm, double to_mm) const;
  /// The same of a closed row from a length on once around.
  [[nodiscard]] std::vector<Stroke> begun_at(double way_mm) const;
  /// The unit way that a closed row comes there, and that it goes on.
  [[nodiscard]] Place arriving(double way_mm) const;
  [[nodiscard]] Place leaving(double way_mm) const;
  [[nodiscard]] Place place(double way_mm) const;
  /// Returns the number of the stroke that begins at a length from the start, or goes on there.
  [[nodiscard]] std::size_t stroke_at(double way_mm) const;

 private:
  std::vector<Stroke> row_;
  std::vector<HalfSweep> halves_;  ///< By stroke.
  std::vector<double> ways_;       ///< One more than strokes.
};

}  // namespace sim::cut
