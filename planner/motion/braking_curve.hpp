#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include "planner/motion/braking.hpp"

namespace cnc::motion {

/// What of a BrakingPoint counts without a time window.
struct PlainBraking {
  float end_square = 0.0F;    ///< v² at the end of the span.
  float deceleration = 0.0F;  ///< mm/s², towards it.
  float cap_square = 0.0F;    ///< v² within the span.
};

/// The BrakingPoints of the spans of one block. Without a time window three numbers of each are
/// all that counts, so there is room for more of them.
class BrakingCurve {
 public:
  /// Nothing is known of any span. @param filters under a time window
  void begin(bool filters);

  void keep(int span, const BrakingPoint& point);

  /// @pre kept
  [[nodiscard]] BrakingPoint at(int span) const;

  /// Who comes with v² = `speed_square` can neither speed up on the span nor has to brake on it.
  /// @pre no time window
  [[nodiscard]] bool stays_level(int span, float speed_square) const;

 private:
  using Filtered = std::array<BrakingPoint, Spans::kMostSpans>;
  using Plain = std::array<PlainBraking, Spans::kMostFineSpans>;

  std::variant<Plain, Filtered> points_{};
};

}  // namespace cnc::motion
