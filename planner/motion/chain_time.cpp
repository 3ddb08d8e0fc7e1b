#include "planner/motion/chain_time.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/turning.hpp"

namespace cnc::motion {
namespace {

/// What holds so many mm further.
struct Reach {
  float acceleration = 0.0F;
  float length = 0.0F;
};

/// On an arc of radius R speed keeps v²/R = A and v³/R² = J.
PiecePace pace_of(const ChainPiece& piece, float window_s, float peak) {
  PiecePace pace{.cap = piece.speed,
                 .acceleration = std::min(piece.acceleration, piece.jerk * window_s)};
  if (piece.bend > 0.0F) {
    const float by_acceleration = std::sqrt(pace.acceleration / piece.bend);
    const float cube = pace.acceleration / (window_s * square(piece.bend));
    const float by_jerk = cube_root(std::clamp(cube, 1.0e-25F, 1.0e25F));
    pace.cap = std::min({pace.cap, by_acceleration, by_jerk});
    /// Of the greatest speed: what turning leaves there is about what it leaves on the way.
    constexpr float kShare = 0.7F;
    const float usual = kShare * std::min(pace.cap, peak);
    const Turning turning = Turning::of(piece.bend, pace.acceleration);
    pace.acceleration = turning.within_jerk(pace.acceleration, square(usual), window_s);
  }
  return pace;
}

/// A slower piece whose speed holds for so many mm yet.
struct Hold {
  float speed = 0.0F;
  float length = 0.0F;

  void pass(float cap, float way, float window_s) {
    length -= way;
    if (length <= 0.0F || cap <= speed) *this = {.speed = cap, .length = 0.5F * cap * window_s};
  }
};

/// What is asked for ahead of a place in a piece.
struct Ahead {
  float end_square = 0.0F;   ///< v² at its end.
  float tail_speed = 0.0F;   ///< mm/s, for …
  float tail_length = 0.0F;  ///< … so many mm before its end.
};

/// v² from which braking by `acceleration` over `length` meets the one at its end.
float before(float end_square, float acceleration, float length, float cap) {
  return std::min(square(cap), end_square + 2.0F * acceleration * length);
}

/// Drives stretches of one cap from both ends' speeds, and counts the time.
class Stopwatch {
 public:
  explicit Stopwatch(float window_s) : window_s_{window_s} {}

  [[nodiscard]] float seconds() const { return seconds_ + window_s_; }

  void drive(float length, const PiecePace& pace, float end_square) {
    if (length <= 0.0F) return;
    const float a = pace.acceleration;
    const float start = std::sqrt(square_);
    // Of a ramp up, a window and a ramp down, as long as the stretch.
    const float lead = 0.5F * a * window_s_;
    const float sum = a * length + 0.5F * (square_ + end_square);
    const float ramps = sum / (std::sqrt(square(lead) + sum) + lead);
    const float most = std::min(pace.cap, std::sqrt(square_ + 2.0F * a * length));
    const float least = std::max(start, std::min(std::sqrt(end_square), most));
    const float peak = std::max(least, std::min(most, ramps));
    const float end = std::min(std::sqrt(end_square), peak);
    const float ramp_way = (2.0F * square(peak) - square_ - square(end)) / (2.0F * a);
    seconds_ += (2.0F * peak - start - end) / a + std::max(0.0F, length - ramp_way) / peak;
    square_ = square(end);
  }

 private:
  float window_s_;
  float seconds_ = 0.0F;
  float square_ = 0.0F;  ///< v².
};

bool alike(float a, float b) {
  constexpr float kShare = 0.1F;
  return std::abs(a - b) <= kShare * std::max(a, b);
}

bool alike(const ChainPiece& a, const ChainPiece& b) {
  return alike(a.speed, b.speed) && alike(a.acceleration, b.acceleration) &&
         alike(a.jerk, b.jerk) && alike(a.bend, b.bend);
}

}  // namespace

void ChainTime::add(const ChainPiece& piece) {
  if (count_ > 0 && alike(pieces_[count_ - 1], piece)) {
    pieces_[count_ - 1].length += piece.length;
    return;
  }
  if (count_ < kMostPieces) pieces_[count_++] = piece;
}

/// mm/s that a single move of this length would come to.
float ChainTime::peak_of(float window_s) const {
  float length = 0.0F;
  float most = 0.0F;
  for (std::size_t i = 0; i < count_; ++i) {
    length += pieces_[i].length;
    most = std::max(most, std::min(pieces_[i].acceleration, pieces_[i].jerk * window_s));
  }
  const float lead = 0.5F * most * window_s;
  return std::sqrt(square(lead) + most * length) - lead;
}

/// As each piece is driven: what turning leaves of the acceleration holds for half a window
/// around it, as its speed does.
ChainTime::Paces ChainTime::paces(float window_s) const {
  const float peak = peak_of(window_s);
  Paces paces{};
  for (std::size_t i = 0; i < count_; ++i) paces[i] = pace_of(pieces_[i], window_s, peak);
  Paces spread = paces;
  const auto spread_from = [&](Reach& reach, std::size_t i) {
    if (reach.length > 0.5F * pieces_[i].length) {
      spread[i].acceleration = std::min(spread[i].acceleration, reach.acceleration);
    }
    reach.length -= pieces_[i].length;
    if (reach.length > 0.0F && reach.acceleration < paces[i].acceleration) return;
    reach = {paces[i].acceleration, 0.5F * std::min(peak, paces[i].cap) * window_s};
  };
  Reach behind;
  for (std::size_t i = 0; i < count_; ++i) spread_from(behind, i);
  Reach ahead;
  for (std::size_t i = count_; i-- > 0;) spread_from(ahead, i);
  return spread;
}

float ChainTime::seconds(float window_s) const {
  const Paces all = paces(window_s);
  std::array<Ahead, kMostPieces> ahead{};
  Hold behind;
  float square_ahead = 0.0F;
  for (std::size_t i = count_; i-- > 0;) {
    const ChainPiece& piece = pieces_[i];
    const auto [cap, acceleration] = all[i];
    const float tail = std::clamp(behind.length, 0.0F, piece.length);
    const float tail_speed = tail > 0.0F ? std::min(cap, behind.speed) : cap;
    ahead[i] = {std::min(square_ahead, square(tail_speed)), tail_speed, tail};
    const float at_tail = before(square_ahead, acceleration, tail, tail_speed);
    square_ahead = before(at_tail, acceleration, piece.length - tail, cap);
    behind.pass(cap, piece.length, window_s);
  }
  Stopwatch watch{window_s};
  Hold held;
  for (std::size_t i = 0; i < count_; ++i) {
    const ChainPiece& piece = pieces_[i];
    const PiecePace pace = all[i];
    const PiecePace held_pace{std::min(pace.cap, held.speed), pace.acceleration};
    const PiecePace tail_pace{ahead[i].tail_speed, pace.acceleration};
    const float head = std::clamp(held.length, 0.0F, piece.length);
    const float tail = std::min(ahead[i].tail_length, piece.length - head);
    const float rest = piece.length - head - tail;
    const float at_tail = before(ahead[i].end_square, pace.acceleration, tail, tail_pace.cap);
    const float at_rest = before(at_tail, pace.acceleration, rest, pace.cap);
    watch.drive(head, held_pace, at_rest);
    watch.drive(rest, pace, at_tail);
    watch.drive(tail, tail_pace, ahead[i].end_square);
    held.pass(pace.cap, piece.length, window_s);
  }
  return watch.seconds();
}

}  // namespace cnc::motion
