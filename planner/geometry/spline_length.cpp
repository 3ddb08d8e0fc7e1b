#include "planner/geometry/spline_length.hpp"

#include <algorithm>
#include <cstdint>

#include "planner/geometry/bezier_view.hpp"

namespace cnc {
namespace {

/// Number of smallest steps into which the parameter range 0 to 1 is divided.
constexpr std::uint32_t kWhole = 1U << 14U;
constexpr std::uint32_t kLongestStep = kWhole / 32U;
/// A step is halved if the two chords of its halves together exceed its own chord by more than this
/// share.
constexpr float kBend = 1.0e-3F;
/// A step is also halved if the chord of one half is more than this many times as long as the chord
/// of the other half. This occurs near a hairpin or a cusp, or if unequal weights make the curve
/// fast.
constexpr float kUneven = 2.0F;

bool is_smooth(float first, float second, float chord) {
  return first + second <= (1.0F + kBend) * chord &&
         std::max(first, second) <= kUneven * std::min(first, second);
}

/// Returns the length of a curve, as the sum of chords over steps of the parameter. The steps are
/// halved where the curve requires it.
float length_of(const BezierView& curve) {
  const auto place_at = [&](std::uint32_t parameter) {
    return curve.at(static_cast<float>(parameter) / static_cast<float>(kWhole)).place;
  };
  float length = 0.0F;
  Vec2 before = place_at(0);
  std::uint32_t step = kLongestStep;
  for (std::uint32_t parameter = 0; parameter < kWhole;) {
    const Vec2 middle = place_at(parameter + step / 2U);
    const Vec2 end = place_at(parameter + step);
    const float first = (middle - before).norm();
    const float second = (end - middle).norm();
    if (step > 2U && !is_smooth(first, second, (end - before).norm())) {
      step /= 2U;
      continue;
    }
    length += first;
    length += second;
    before = end;
    parameter += step;
    while (step < kLongestStep && parameter % (2U * step) == 0U) step *= 2U;
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
