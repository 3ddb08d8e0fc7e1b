// Where spans begin and end, which is asked for at each span of each block that is planned.

#include <array>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/lookahead/spans.hpp"

namespace cnc::motion {
namespace {

constexpr int kGridPerQuarter = Spans::kGridPerTurn / 4;

/// sin(k · 3.75°) for a quarter turn, by Taylor's series at compile time.
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

SinCos grid_sin_cos(int index) {
  const int wrapped = ((index % Spans::kGridPerTurn) + Spans::kGridPerTurn) % Spans::kGridPerTurn;
  const auto within = static_cast<std::size_t>(wrapped % kGridPerQuarter);
  return turned_by_quarters({kQuarterSines[within], kQuarterSines[kGridPerQuarter - within]},
                            wrapped / kGridPerQuarter);
}

}  // namespace

/// How many edges of zones come before a boundary.
int Spans::edges_before(int index) const {
  int before = 0;
  while (before < edge_count_ && edge_indices_[static_cast<std::size_t>(before)] < index) ++before;
  return before;
}

bool Spans::is_edge(int index) const {
  const int before = edges_before(index);
  return before < edge_count_ && edge_indices_[static_cast<std::size_t>(before)] == index;
}

/// At a boundary that the arc itself asks for.
float Spans::own_angle(int own) const {
  if (own <= 0) return start_angle_;
  if (own >= own_count_) return start_angle_ + sweep_;
  if (uniform_) {
    return start_angle_ + sweep_ * (static_cast<float>(own) / static_cast<float>(own_count_));
  }
  return static_cast<float>(first_grid_ + own - 1) * grid_angle_;
}

/// @pre within an arc
float Spans::own_boundary(int own) const {
  return (own_angle(own) - start_angle_) * mm_per_radian_;
}

float Spans::angle_of(int index) const {
  if (edge_count_ == 0) return own_angle(index);
  if (is_edge(index)) return start_angle_ + boundary(index) / mm_per_radian_;
  return own_angle(index - edges_before(index));
}

float Spans::boundary(int index) const {
  if (index <= 0) return 0.0F;
  if (index >= count_) return length_;
  if (edge_count_ == 0) return own_boundary(index);
  const int before = edges_before(index);
  return is_edge(index) ? edges_[static_cast<std::size_t>(before)] : own_boundary(index - before);
}

Place Spans::place_at_boundary(int index) const {
  if (sweep_ <= 0.0F) return {};
  const bool off_grid = uniform_ || split_ > 1 || index <= 0 || index >= count_ || is_edge(index);
  if (off_grid) return sin_cos(angle_of(index));
  return grid_sin_cos(first_grid_ + index - edges_before(index) - 1);
}

Place Spans::place_at(float distance) const {
  if (sweep_ <= 0.0F) return {};
  return sin_cos(start_angle_ + distance / mm_per_radian_);
}

}  // namespace cnc::motion
