#pragma once

#include <cstdint>

namespace cnc::gcode {

/// A vector in the plane of an arc, in whole nanometres. It is the difference of two positions in
/// range, so |component| ≤ 2e12.
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

/// Permitted distance of an arc's end from the circle through the arc's start.
struct ArcTolerance {
  float absolute_mm = 0.05F;
  float relative = 0.01F;  ///< Tolerance as a share of the radius.
};

/// Returns the greater one of the two tolerances, limited to 0.5 mm. The result is never stricter
/// than the tolerance of Grbl 1.1: the greater one of 0.005 mm and 0.1 % of the radius, limited to
/// 0.5 mm.
[[nodiscard]] float allowed_deviation(const ArcTolerance& tolerance, float radius_mm);

/// Returns the difference of the radii at the two ends of an arc, | |end − centre| − |centre| |, in
/// mm. Both vectors are relative to the start.
///
/// With d = end and c = centre, it is computed as |d·(d − 2c)| / (r0 + r1), because r1² − r0² =
/// d·(d − 2c). For large circles, the direct difference of the two radii would consist of rounding
/// errors. The product is computed in integers. The error is at most 1e-6 of the result, plus 2e-8
/// of the radius if the radius exceeds 0.5 m.
/// @pre `centre` is not the start
[[nodiscard]] float radius_deviation(PlaneVector end, PlaneVector centre);

struct CentreByRadius {
  PlaneVector centre;  ///< Vector from the start to the centre.
  /// Length by which the chord exceeds the diameter, mm; 0 if it does not. The error is at most
  /// 1e-8 of the radius, and 0 for radii below 1 m.
  float excess_mm = 0.0F;
};

/// Returns the centre of the arc to `end` with a given radius, relative to the start (RS274/NGC
/// 3.5.3.1). There are two possible centres. A positive radius selects the centre of the shorter
/// arc, and a negative radius the centre of the longer arc. If the chord is longer than the
/// diameter, there is no centre. Then the result is the middle of the chord.
///
/// The error is at most 3e-7 of the radius. The distance of the centre from the perpendicular
/// bisector of the chord has the same bound.
/// @param radius_nm not zero, in the range of a coordinate
/// @pre `end` is not the start
[[nodiscard]] CentreByRadius centre_by_radius(PlaneVector end,
                                              std::int64_t radius_nm,
                                              bool clockwise);

}  // namespace cnc::gcode
