#include "planner/geometry/spline_length.hpp"

#include "planner/geometry/curve_ahead.hpp"

namespace cnc {

float length_of(const Spline& spline) {
  constexpr int kChords = 64;
  CurveAhead ahead{spline};
  float length = 0.0F;
  for (std::size_t segment = 0; segment < spline.segment_count(); ++segment) {
    Vec2 before{0.0F, 0.0F};
    for (int i = 1; i <= kChords; ++i) {
      const Vec2 place = ahead.at(static_cast<float>(i) / kChords).place;
      length += (place - before).norm();
      before = place;
    }
    ahead.advance(1.0F);
  }
  return length;
}

}  // namespace cnc
