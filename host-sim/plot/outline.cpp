#include "host-sim/plot/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host-sim/measure/program_line.hpp"
#include "host-sim/measure/programmed_arc.hpp"
#include "host-sim/measure/programmed_spline.hpp"
#include "host-sim/plot/path_simplifier.hpp"

namespace sim {
namespace {

using cnc::gcode::Action;
using cnc::gcode::ActionKind;

// Greatest number of points of an outline, the same as for the recorded path. A page can draw this
// many points at every change.
constexpr std::size_t kMaxVertices = 50'000;
constexpr std::size_t kLongestReason = 160;
constexpr double kMillimetresPerNanometre = 1.0e-6;

double to_mm(cnc::Coordinate place) {
  return static_cast<double>(place.nanometres()) * kMillimetresPerNanometre;
}

Point to_point(const cnc::Position& place) {
  Point point{};
  for (std::size_t axis = 0; axis < point.size(); ++axis) point[axis] = to_mm(place[axis]);
  return point;
}

/// Returns the number of equal chords into which a circle or arc must be divided. Each chord is
/// then within the tolerance of the curve.
double chord_count(const Curve& curve) {
  const Circle& circle = curve.circle().value();
  const double cosine = std::max(-1.0, 1.0 - PathTolerance{}.distance_mm / circle.radius);
  return std::ceil(std::abs(circle.sweep) / (2.0 * std::acos(cosine)));
}

/// Appends the motions of G-code actions to a path.
class OutlinePen {
 public:
  OutlinePen(const Point& start, std::size_t max_points) : at_{start}, max_points_{max_points} {
    push(start, Move::kTravel);
  }

  /// Appends the motion of an action. Returns false if the path would have too many points.
  [[nodiscard]] bool draw(const Action& action) {
    switch (action.kind) {
      case ActionKind::kRapid:
        return go_to(to_point(action.end), Move::kTravel);
      case ActionKind::kLine:
      case ActionKind::kProbe:
        return go_to(to_point(action.end), feed_move());
      case ActionKind::kArc:
        return follow(pieces_of(arc_of(action)));
      case ActionKind::kSpline:
        return follow(pieces_of(spline_of(*action.spline)));
      case ActionKind::kSpindle:
        on_ = action.spindle != cnc::gcode::SpindleMode::kOff;
        return true;
      case ActionKind::kSpindleSpeed:
        speed_ = action.value;
        return true;
      case ActionKind::kEnd:
        on_ = false;
        return true;
      default:
        return true;
    }
  }

  void set_output(const cnc::gcode::ModalState& state) {
    on_ = state.spindle != cnc::gcode::SpindleMode::kOff;
    speed_ = state.spindle_speed;
  }

  [[nodiscard]] std::vector<PathVertex> finish() { return simplifier_.finish(); }

 private:
  [[nodiscard]] Move feed_move() const { return on_ && speed_ > 0.0F ? Move::kCut : Move::kFeed; }

  void push(const Point& point, Move move) {
    simplifier_.push({.x_mm = point[0], .y_mm = point[1], .move = move});
    ++points_;
    simplifier_.thin_to(kMaxVertices);
  }

  [[nodiscard]] bool go_to(const Point& end, Move move) {
    if (points_ >= max_points_) return false;
    push(end, move);
    at_ = end;
    return true;
  }

  [[nodiscard]] ProgrammedArc arc_of(const Action& arc) const {
    return {.start = at_,
            .end = to_point(arc.end),
            .plane = arc.plane,
            .centre = {to_mm(arc.centre[0]), to_mm(arc.centre[1])},
            .clockwise = arc.clockwise,
            .turns = arc.turns};
  }

  [[nodiscard]] ProgrammedSpline spline_of(const cnc::Spline& spline) const {
    ProgrammedSpline programmed{.start = at_, .points = {}, .weights = {}, .order = spline.order()};
    for (std::size_t i = 0; i < spline.size(); ++i) {
      const cnc::ControlPoint& point = spline.point(i);
      programmed.points.push_back({at_[0] + to_mm(cnc::Coordinate{point.place.x}),
                                   at_[1] + to_mm(cnc::Coordinate{point.place.y})});
      programmed.weights.push_back(static_cast<double>(point.weight));
    }
    return programmed;
  }

  [[nodiscard]] bool follow(const std::vector<Curve>& pieces) {
    for (const Curve& piece : pieces) {
      const double chords = piece.circle() ? chord_count(piece) : 1.0;
      for (double chord = 1.0; chord < chords; ++chord) {
        if (!go_to(piece.point_at(chord / chords), feed_move())) return false;
      }
      if (!go_to(piece.end(), feed_move())) return false;
    }
    return true;
  }

  PathSimplifier simplifier_{PathTolerance{}};
  Point at_;
  std::size_t max_points_;
  std::size_t points_ = 0;
  bool on_ = false;  ///< True if beam or spindle is on.
  float speed_ = 0.0F;
};

bool is_statement(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] == '$';
}

Refusal refusal_of(const cnc::gcode::Fault& fault, std::size_t line) {
  std::array<char, kLongestReason> words{};
  const std::size_t count = cnc::gcode::describe(fault, words);
  return {.line = line,
          .column = fault.column,
          .number = static_cast<int>(fault.code()),
          .reason = {words.data(), count}};
}

}  // namespace

ProgramOutline program_outline_of(std::string_view program,
                                  cnc::gcode::Interpreter reader,
                                  std::size_t max_points) {
  OutlinePen pen{to_point(reader.position()), max_points};
  pen.set_output(reader.state());
  std::optional<Refusal> refused;
  for (std::size_t number = 1; !program.empty() && !refused; ++number) {
    const std::string_view line = take_line(program);
    if (is_statement(line)) continue;
    const auto actions = reader.interpret(line);
    if (!actions.ok()) {
      refused = refusal_of(actions.error(), number);
      break;
    }
    const bool drawn = std::ranges::all_of(
        actions.value(), [&pen](const Action& action) { return pen.draw(action); });
    if (!drawn) refused = Refusal{.line = number, .reason = "the outline is too long to be drawn"};
  }
  return {pen.finish(), std::move(refused)};
}

}  // namespace sim
