#include "planner/motion/lookahead/arc_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace cnc::motion {
namespace {

/// Least angle between a boundary and an end of the arc, in radians. A nearer boundary is left out.
/// If an axis reverses there, it moves by only R · 5e-11 on an arc of radius R, which is far below
/// a step.
constexpr float kSliver = 1.0e-5F;

constexpr int kGridPerQuarter = ArcGrid::kPerTurn / 4;

/// Computes sin(k · 3.75°) over a quarter turn with Taylor's series, at compile time.
constexpr std::array<float, kGridPerQuarter + 1> make_quarter_sines() {
  std::array<float, kGridPerQuarter + 1> sines{};
  for (int k = 0; k <= kGridPerQuarter; ++k) {
    const long double x = 1.57079632679489661923L * k / kGridPerQuarter;
    long double term = x;
    long double sum = x;
    for (int n = 1; n < 12; ++n) {
      term *= -x * x / static_cast<long double>((2 * n) * (2 * n + 1));
      sum += term;
    }
    sines[static_cast<std::size_t>(k)] = static_cast<float>(sum);
  }
  return sines;
}
constexpr auto kQuarterSines = make_quarter_sines();

SinCos grid_sin_cos(int multiple) {
  const int wrapped = ((multiple % ArcGrid::kPerTurn) + ArcGrid::kPerTurn) % ArcGrid::kPerTurn;
  const auto within = static_cast<std::size_t>(wrapped % kGridPerQuarter);
  return turned_by_quarters({kQuarterSines[within], kQuarterSines[kGridPerQuarter - within]},
                            wrapped / kGridPerQuarter);
}

}  // namespace

ArcGrid ArcGrid::at_multiples(const ArcShape& arc, int split) {
  ArcGrid grid;
  grid.fine_ = split > 1;
  grid.spacing_ = kAngle / static_cast<float>(split);
  grid.first_multiple_ =
      static_cast<int>(std::floor((arc.start_angle() + kSliver) / grid.spacing_)) + 1;
  const int last_multiple =
      static_cast<int>(std::ceil((arc.end_angle() - kSliver) / grid.spacing_)) - 1;
  const int most = grid.fine() ? kMaxFineSpans : kMaxSpans;
  grid.count_ = std::clamp(last_multiple - grid.first_multiple_ + 2, 1, most);
  return grid;
}

ArcGrid ArcGrid::of_equal_spans(const ArcShape& arc) {
  ArcGrid grid;
  grid.equal_spans_ = true;
  grid.count_ = std::max(1, static_cast<int>(std::ceil(arc.sweep() / kAngle)));
  return grid;
}

int ArcGrid::finest_split(const ArcShape& arc, float seconds) {
  constexpr float kMaxSplit = 16.0F;
  constexpr float kShortestSpan = 0.7e-3F;  // Shortest duration of a span, s.
  const float most = std::min(seconds / kShortestSpan, static_cast<float>(kMaxFineSpans - 2));
  constexpr float kRounding = 1.0e-3F;
  const float split = most / std::max(1.0F, arc.sweep() / kAngle) + kRounding;
  return static_cast<int>(std::clamp(split, 1.0F, kMaxSplit));
}

float ArcGrid::angle(const ArcShape& arc, int boundary) const {
  if (boundary <= 0) return arc.start_angle();
  if (boundary >= count_) return arc.end_angle();
  if (equal_spans_) {
    const float share = static_cast<float>(boundary) / static_cast<float>(count_);
    return arc.start_angle() + arc.sweep() * share;
  }
  return static_cast<float>(first_multiple_ + boundary - 1) * spacing_;
}

Place ArcGrid::place(const ArcShape& arc, int boundary) const {
  const bool in_table = !equal_spans_ && !fine() && boundary > 0 && boundary < count_;
  return in_table ? grid_sin_cos(first_multiple_ + boundary - 1) : sin_cos(angle(arc, boundary));
}

}  // namespace cnc::motion
