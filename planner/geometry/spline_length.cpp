#include "planner/geometry/spline_length.hpp"

#include "planner/geometry/bezier_view.hpp"

namespace cnc {
namespace {

float length_of(const BezierView& curve) {
  constexpr int kChords = 64;
  float length = 0.0F;
  Vec2 before = curve.at(0.0F).place;
  for (int i = 1; i <= kChords; ++i) {
    const Vec2 place = curve.at(static_cast<float>(i) / kChords).place;
    length += (place - before).norm();
    before = place;
  }
  return length;
}

BezierView seen_from_its_start(const Bezier& bezier) {
  return {bezier, bezier.start(), {1.0F, 0.0F}};
}

}  // namespace

float length_of(const Spline& spline) {
  float length = 0.0F;
  for (std::size_t segment = 0; segment < spline.segment_count(); ++segment) {
    length += length_of(seen_from_its_start(spline.segment(segment)));
  }
  return length;
}

}  // namespace cnc
