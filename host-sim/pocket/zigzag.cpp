#include "host-sim/pocket/zigzag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "host-sim/pocket/depth_writer.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "host-sim/pocket/wall_ramp.hpp"
#include "host-sim/pocket/zigzag_turn.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::Use;

/// Of the distance of lines: the way along a wall from one to the next one, at most.
constexpr double kLongestWay = 10.0;
/// Of the distance of lines: the radius of turns, at most.
constexpr double kWidestTurn = 0.25;
/// mm: a shorter stretch is cleared by what is beside it.
constexpr double kLeastStretchMm = 1.0e-6;

void check(const ZigzagOptions& options) {
  const auto require = [](bool is_right, const char* what, double value) {
    if (!is_right) throw std::invalid_argument{fmt::format("{} {:g} is out of range", what, value)};
  };
  const double radius = options.tool_radius_mm;
  require(radius > 0.0 && std::isfinite(radius), "radius of the tool in mm", radius);
  require(options.stepover_mm > 0.0 && options.stepover_mm <= 2.0 * radius,
          "distance of lines in mm",
          options.stepover_mm);
  require(options.turn_radius_mm >= 0.0 && std::isfinite(options.turn_radius_mm),
          "radius of turns in mm",
          options.turn_radius_mm);
  require(
      options.depth_mm > 0.0 && std::isfinite(options.depth_mm), "depth in mm", options.depth_mm);
  require(options.slope > 0.0 && options.slope <= 1.0, "slope", options.slope);
}

/// The radius of turns: a line ends by up to twice as much before the wall, which clears what the
/// line leaves on both sides of its end.
double turn_radius(const ZigzagOptions& options) {
  const double reach = options.tool_radius_mm - 0.5 * options.stepover_mm;
  const double most = std::min(kWidestTurn * options.stepover_mm, 0.5 * reach);
  constexpr double kLeast = 1.0e-4;  // mm.
  return most < kLeast ? 0.0 : std::min(options.turn_radius_mm, most);
}

WallDrive wall_drive_of(const ZigzagOptions& options) {
  return {.depth_mm = options.depth_mm, .slope = options.slope, .plunges = options.plunges};
}

/// Drives the lines of an area, from the lowest one upwards.
class LineDriver {
 public:
  LineDriver(const TurnSpace& space, const ZigzagOptions& options, Zigzag& out)
      : space_{space}, options_{options}, writer_{out, options.depth_mm} {
    const auto box = box_of(space.rounded);
    const double gaps = std::ceil((box.y1 - box.y0) / options.stepover_mm);
    step_mm_ = (box.y1 - box.y0) / std::max(1.0, gaps);
    for (double k = 1.0; k < gaps; k += 1.0) {
      const double y = box.y0 + k * step_mm_;
      std::vector<Line> line;
      for (const Stretch& stretch : stretches_at(space.rounded, y)) {
        if (stretch.to_x - stretch.from_x > kLeastStretchMm) line.push_back({stretch, false});
      }
      out.lines += static_cast<std::uint32_t>(line.size());
      lines_.push_back({y, std::move(line)});
    }
  }

  void drive_all() {
    for (std::size_t level = 0; level < lines_.size(); ++level) {
      while (Line* const line = nearest_left(level)) drive_row(level, *line);
    }
    writer_.end_row();
  }

 private:
  struct Line {
    Stretch stretch;
    bool is_driven = false;
  };
  struct Level {
    double y = 0.0;
    std::vector<Line> lines;
  };
  /// The turn to a line of the level above.
  struct Next {
    Line* line = nullptr;
    ZigzagTurn turn;
  };

  /// Of the lines of a level that are not driven the one that begins nearest to the tool.
  [[nodiscard]] Line* nearest_left(std::size_t level) {
    Line* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (Line& line : lines_[level].lines) {
      const double away = std::abs(line.stretch.from_x - at_.x());
      if (line.is_driven || away >= least) continue;
      best = &line;
      least = away;
    }
    return best;
  }

  /// The turn to the line above that begins nearest to the end of this one.
  [[nodiscard]] Next next_of(std::size_t level, const Line& line, double from_x, Side side) {
    Next next;
    if (level + 1 == lines_.size()) return next;
    double least = std::numeric_limits<double>::infinity();
    for (Line& above : lines_[level + 1].lines) {
      if (above.is_driven) continue;
      auto turn = turn_between(space_,
                               {line.stretch, above.stretch, lines_[level].y, step_mm_},
                               side,
                               kLongestWay * step_mm_);
      if (!turn || std::abs(turn->meets_at_x - turn->leaves_at_x) >= least) continue;
      const double way = turn->leaves_at_x - from_x;
      if ((side == Side::kRight ? way : -way) < kLeastStretchMm) continue;
      least = std::abs(turn->meets_at_x - turn->leaves_at_x);
      next = {&above, std::move(*turn)};
    }
    return next;
  }

  void drive_row(std::size_t level, Line& first) {
    Line* line = &first;
    Side side = Side::kRight;  // Towards which the line is driven.
    double from_x = first.stretch.from_x;
    for (bool is_first = true; line != nullptr; is_first = false, ++level) {
      line->is_driven = true;
      Next next = next_of(level, *line, from_x, side);
      const double to_x =
          next.line != nullptr ? next.turn.leaves_at_x : end_of(line->stretch, side);
      const double y = lines_[level].y;
      if (is_first) sink({from_x, y}, {to_x, y});
      writer_.pass({to_x, y});
      for (const WayElement& element : next.turn.way) writer_.pass(element.to, element.bulge);
      from_x = next.turn.meets_at_x;
      line = next.line;
      side = side == Side::kRight ? Side::kLeft : Side::kRight;
    }
    at_ = writer_.place();
  }

  /// Goes down at the beginning of a row: forth and back along its first line.
  void sink(const WideVec2& from, const WideVec2& to) {
    writer_.begin_row(from);
    if (options_.plunges) return writer_.go(Use::kEntry, from, 0.0, writer_.floor_z());
    const double pairs = legs_of_ramp(wall_drive_of(options_), 2.0 * (to - from).norm(), from);
    const double floor = writer_.floor_z();
    for (double pair = 1.0; pair <= pairs; pair += 1.0) {
      writer_.go(Use::kEntry, to, 0.0, floor * (pair - 0.5) / pairs);
      writer_.go(Use::kEntry, from, 0.0, pair == pairs ? floor : floor * pair / pairs);
    }
  }

  TurnSpace space_;
  ZigzagOptions options_;
  DepthWriter writer_;
  double step_mm_ = 0.0;
  std::vector<Level> lines_;
  WideVec2 at_{0.0, 0.0};
};

}  // namespace

Zigzag zigzag_path(const cnc::contour::ContourView<double>& area, const ZigzagOptions& options) {
  check(options);
  ContourOffset offsetter;
  const Contour locus = copy_of(offsetter.offset(area, -options.tool_radius_mm));
  if (locus.loop_ends.empty()) {
    throw NoPocketPath{"the tool fits nowhere into it; choose a smaller one with --tool"};
  }
  const double turn_mm = turn_radius(options);
  const Contour centres = copy_of(offsetter.offset(locus.view(), -turn_mm));
  // Parts that grow together have corners between them, which are filled.
  const Contour wide = copy_of(offsetter.offset(centres.view(), 2.0 * turn_mm));
  const Contour rounded = copy_of(offsetter.offset(wide.view(), -turn_mm));
  Zigzag path;
  if (!rounded.loop_ends.empty()) {
    const OwnedArea rounded_area{rounded.view()};
    const OwnedArea centre_area{centres.view()};
    LineDriver{{rounded_area, centre_area, turn_mm}, options, path}.drive_all();
  }
  for (std::size_t loop = 0; loop < locus.loop_ends.size(); ++loop) {
    ramp_along_wall(locus.view(), loop, wall_drive_of(options), path);
  }
  return path;
}

}  // namespace sim::pocket
