#include "host-sim/pocket/round_return.hpp"

#include <cmath>
#include <numbers>

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::ToolCircle;
using cnc::pocket::Use;

constexpr double kHalfTurn = std::numbers::pi;
/// Radians: a turn that is almost a loop would be longer than the line that it smooths.
constexpr double kNearlyALoop = 1.5 * kHalfTurn;
constexpr double kRoundingMm = 1.0e-9;

/// The turn to the left from one direction to another, 0 to 2 π.
double turn_between(const WideVec2& from, const WideVec2& to) {
  const double angle = std::atan2(cnc::cross(from, to), from.dot(to));
  return angle < 0.0 ? angle + 2.0 * kHalfTurn : angle;
}

bool is_in(const WideVec2& place, const ToolCircle& disc) {
  return (place - disc.centre).norm() <= disc.radius + kRoundingMm;
}

/// Two arcs of one radius to the left, and the line between them that both have for a tangent.
class RoundWay {
 public:
  RoundWay(const CutStart& from, const CutStart& to, double radius_mm)
      : to_{to},
        radius_mm_{radius_mm},
        first_centre_{from.place + radius_mm * cnc::left_normal(from.direction)},
        last_centre_{to.place + radius_mm * cnc::left_normal(to.direction)},
        along_{(last_centre_ - first_centre_).normalized()},
        first_turn_{turn_between(from.direction, along_)},
        last_turn_{turn_between(along_, to.direction)} {}

  /// The first arc touches or stays away from the disc's circle if all of its own does. The last
  /// one is in the disc on its way to the circle, which it crosses once.
  [[nodiscard]] bool stays_in(const ToolCircle& disc) const {
    const double away = (first_centre_ - disc.centre).norm();
    return first_turn_ <= kNearlyALoop && last_turn_ <= kNearlyALoop &&
           away + radius_mm_ <= disc.radius + kRoundingMm && is_in(line_end(), disc) &&
           is_in(last_centre_ + radius_mm_ * middle_of_last(), disc);
  }

  void write(DepthWriter& writer) const {
    write_arc(writer, first_centre_, first_turn_, line_start());
    writer.go_back(line_end());
    write_arc(writer, last_centre_, last_turn_, to_.place);
  }

 private:
  [[nodiscard]] WideVec2 outwards() const { return -cnc::left_normal(along_); }
  [[nodiscard]] WideVec2 line_start() const { return first_centre_ + radius_mm_ * outwards(); }
  [[nodiscard]] WideVec2 line_end() const { return last_centre_ + radius_mm_ * outwards(); }
  [[nodiscard]] WideVec2 middle_of_last() const { return turned(outwards(), 0.5 * last_turn_); }

  [[nodiscard]] static WideVec2 turned(const WideVec2& vector, double angle) {
    return std::cos(angle) * vector + std::sin(angle) * cnc::left_normal(vector);
  }

  /// Arcs of more than half a turn are written in two halves.
  static void write_arc(DepthWriter& writer,
                        const WideVec2& centre,
                        double turn,
                        const WideVec2& end) {
    const WideVec2 start = writer.place();
    if (start == end) return;
    const double z = writer.floor_z();
    if (turn <= kHalfTurn) return writer.go(Use::kReturn, end, std::tan(0.25 * turn), z);
    const double bulge = std::tan(0.125 * turn);
    writer.go(Use::kReturn, centre + turned(start - centre, 0.5 * turn), bulge, z);
    writer.go(Use::kReturn, end, bulge, z);
  }

  CutStart to_;
  double radius_mm_;
  WideVec2 first_centre_;
  WideVec2 last_centre_;
  WideVec2 along_;
  double first_turn_;
  double last_turn_;
};

}  // namespace

void go_back_round(DepthWriter& writer,
                   const ToolCircle& disc,
                   const CutStart& next,
                   double turn_mm) {
  const WideVec2 heading = writer.heading();
  if (turn_mm >= kLeastTurnMm && heading != WideVec2{0.0, 0.0}) {
    const RoundWay way{{writer.place(), heading}, next, turn_mm};
    if (way.stays_in(disc)) return way.write(writer);
  }
  writer.go_back(next.place);
}

}  // namespace sim::pocket
