#include "host-sim/pocket/round_return.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::ToolCircle;
using cnc::pocket::Use;

constexpr double kHalfTurn = std::numbers::pi;
/// Radians: a turn that is almost a loop would be longer than the line that it smooths.
constexpr double kNearlyALoop = 1.5 * kHalfTurn;
/// Radians: what turns by less is straight.
constexpr double kNoTurn = 1.0e-6;
/// Radians: corners at which the way nearly turns back stay corners.
constexpr double kNearlyBack = 0.95 * kHalfTurn;
constexpr double kRoundingMm = 1.0e-9;

/// The turn to the left from one direction to another, 0 to 2 π.
double turn_between(const WideVec2& from, const WideVec2& to) {
  const double angle = std::atan2(cnc::cross(from, to), from.dot(to));
  return angle < 0.0 ? angle + 2.0 * kHalfTurn : angle;
}

bool is_in(const WideVec2& place, const ToolCircle& disc) {
  return (place - disc.centre).norm() <= disc.radius + kRoundingMm;
}

/// A vector turned to the left, by radians.
WideVec2 turned(const WideVec2& vector, double angle) {
  return std::cos(angle) * vector + std::sin(angle) * cnc::left_normal(vector);
}

/// Arcs of more than half a turn are written in two halves.
void write_arc(
    DepthWriter& writer, Use use, const WideVec2& centre, double turn, const WideVec2& end) {
  const WideVec2 start = writer.place();
  if (start == end) return;
  const double z = writer.floor_z();
  if (turn < kNoTurn) return writer.go(use, end, 0.0, z);
  if (turn <= kHalfTurn) return writer.go(use, end, std::tan(0.25 * turn), z);
  const double bulge = std::tan(0.125 * turn);
  writer.go(use, centre + turned(start - centre, 0.5 * turn), bulge, z);
  writer.go(use, end, bulge, z);
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
    const bool has_line = along_ != WideVec2{0.0, 0.0};
    return has_line && first_turn_ <= kNearlyALoop && last_turn_ <= kNearlyALoop &&
           away + radius_mm_ <= disc.radius + kRoundingMm && is_in(line_end(), disc) &&
           is_in(last_centre_ + radius_mm_ * middle_of_last(), disc);
  }

  void write(DepthWriter& writer) const {
    write_arc(writer, Use::kReturn, first_centre_, first_turn_, line_start());
    writer.go_back(line_end());
    write_arc(writer, Use::kReturn, last_centre_, last_turn_, to_.place);
  }

 private:
  [[nodiscard]] WideVec2 outwards() const { return -cnc::left_normal(along_); }
  [[nodiscard]] WideVec2 line_start() const { return first_centre_ + radius_mm_ * outwards(); }
  [[nodiscard]] WideVec2 line_end() const { return last_centre_ + radius_mm_ * outwards(); }
  [[nodiscard]] WideVec2 middle_of_last() const { return turned(outwards(), 0.5 * last_turn_); }

  CutStart to_;
  double radius_mm_;
  WideVec2 first_centre_;
  WideVec2 last_centre_;
  WideVec2 along_;
  double first_turn_;
  double last_turn_;
};

/// The discs through whose centres the tool goes: it leaves out what lies in the disc that it is
/// in.
std::vector<ToolCircle> shortened(const std::vector<ToolCircle>& way) {
  std::vector<ToolCircle> short_way;
  std::size_t disc = 0;
  while (disc + 1 < way.size()) {
    std::size_t next = disc;
    while (next + 1 < way.size() && is_in(way[next + 1].centre, way[disc])) ++next;
    if (next == disc) {
      if (short_way.empty()) short_way.push_back(way[disc]);
      ++next;
    }
    short_way.push_back(way[next]);
    disc = next;
  }
  if (short_way.empty()) short_way.push_back(way.back());
  return short_way;
}

/// The first arc of a way to a place in the same disc: out of the direction of travel.
void turn_towards(DepthWriter& writer,
                  const ToolCircle& disc,
                  const WideVec2& target,
                  double turn_mm) {
  const WideVec2 heading = writer.heading();
  if (turn_mm < kLeastTurnMm || heading == WideVec2{0.0, 0.0}) return;
  const WideVec2 centre = writer.place() + turn_mm * cnc::left_normal(heading);
  if ((centre - disc.centre).norm() + turn_mm > disc.radius + kRoundingMm) return;
  const WideVec2 way = target - centre;
  const double away = way.norm();
  if (away <= turn_mm) return;
  const WideVec2 along = turned(way / away, std::asin(turn_mm / away));
  const double turn = turn_between(heading, along);
  if (turn > kNearlyALoop) return;
  write_arc(writer, Use::kReturn, centre, turn, centre - turn_mm * cnc::left_normal(along));
}

/// A line towards the centre of a disc, and there an arc into the direction of the next.
void round_corner(DepthWriter& writer,
                  const ToolCircle& corner,
                  const WideVec2& next,
                  double turn_mm) {
  const WideVec2 before = corner.centre - writer.place();
  const WideVec2 after = next - corner.centre;
  const double trim = std::min({turn_mm, corner.radius, 0.5 * before.norm(), 0.5 * after.norm()});
  const double turn = std::atan2(cnc::cross(before, after), before.dot(after));
  const bool is_corner = trim < kLeastTurnMm || std::abs(turn) > kNearlyBack;
  if (is_corner || std::abs(turn) < kNoTurn) return writer.go_back(corner.centre);
  writer.go_back(corner.centre - trim * before.normalized());
  const WideVec2 end = corner.centre + trim * after.normalized();
  writer.go(Use::kReturn, end, std::tan(0.25 * turn), writer.floor_z());
}

}  // namespace

void go_through_round(DepthWriter& writer, const std::vector<ToolCircle>& way, double turn_mm) {
  const std::vector<ToolCircle> discs = shortened(way);
  turn_towards(writer,
               way.front(),
               discs.front().centre,
               std::min(turn_mm, kTurnOfCircle * way.front().radius));
  for (std::size_t i = 0; i + 1 < discs.size(); ++i) {
    round_corner(writer, discs[i], discs[i + 1].centre, turn_mm);
  }
  writer.go_back(discs.back().centre);
}

Approach approach_from(const WideVec2& place, const CutStart& next, double radius_mm) {
  const WideVec2 centre = next.place + radius_mm * cnc::left_normal(next.direction);
  const WideVec2 way = centre - place;
  const double away = way.norm();
  if (away <= radius_mm) return {};
  const WideVec2 along = turned(way / away, -std::asin(radius_mm / away));
  const double turn = turn_between(along, next.direction);
  if (turn >= kHalfTurn) return {};
  return {centre, centre - radius_mm * cnc::left_normal(along), turn, true};
}

double Approach::bulge() const { return std::tan(0.25 * turn); }

WideVec2 Approach::place_at(double share) const {
  return centre + turned(arc_start - centre, share * turn);
}

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
