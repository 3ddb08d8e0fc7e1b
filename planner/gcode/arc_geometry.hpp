#pragma once

#include <cstdint>

namespace cnc::gcode {

/// A vector in the plane of an arc, in whole nanometres. It is a difference of positions that are
/// in range, so |component| ≤ 2e12.
struct PlaneVector {
  std::int64_t first = 0;
  std::int64_t second = 0;

  [[nodiscard]] bool is_null() const { return first == 0 && second == 0; }
  /// Returns the length in mm, with a relative error of at most 3e-7.
  [[nodiscard]] float length() const;

  friend PlaneVector operator-(PlaneVector a, PlaneVector b) {
    return {a.first - b.first, a.second - b.second};
  }
};

/// Permitted distance of an arc's end from the circle through its start.
struct ArcTolerance {
  float absolute_mm = 0.05F;
  float relative = 0.01F;  ///< Share of the radius.
};

/// Returns the greater of the two tolerances, at most 0.5 mm. It is never stricter than Grbl 1.1,
/// which takes 0.005 mm, or 0.1 % of the radius up to 0.5 mm.
[[nodiscard]] float allowed_deviation(const ArcTolerance& tolerance, float radius_mm);

/// Returns | |centre to end| − |centre to start| | in mm, both vectors from the start.
///
/// It is not computed as the difference of the two radii, which for large circles is rounding
/// noise, but as |d·(d − 2c)| / (r0 + r1). Both are equal since r1² − r0² = d·(d − 2c). The product
/// is computed in integers. The error is at most 1e-6 of the result, plus 2e-8 of the radius where
/// the radius exceeds 0.5 m.
/// @pre `centre` is not the start.
[[nodiscard]] float radius_deviation(PlaneVector end, PlaneVector centre);

struct CentreByRadius {
  PlaneVector centre;  ///< Vector from the start.
  /// Excess of the chord over the diameter; 0 if the chord is not longer. The error is at most 1e-8
  /// of the radius, and 0 for radii below 1 m.
  float excess_mm = 0.0F;
};

/// Returns the centre of the arc to `end`, relative to the start, for a given radius (RS274/NGC
/// 3.5.3.1). Of the two possible centres it is that of the shorter arc for a positive radius, and
/// of the longer arc for a negative one. A chord that is longer than the diameter has no centre;
/// then the result is the middle of the chord.
/// The error is at most 3e-7 of the radius. The distance of the centre from the perpendicular
/// through the middle of the chord has the same bound.
/// @param radius_nm not zero, in the range of a coordinate.
/// @pre `end` is not the start.
[[nodiscard]] CentreByRadius centre_by_radius(PlaneVector end,
                                              std::int64_t radius_nm,
                                              bool clockwise);

}  // namespace cnc::gcode
