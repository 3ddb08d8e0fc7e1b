#include "host-sim/pocket/zigzag_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host-sim/pocket/depth_writer.hpp"
#include "host-sim/pocket/wall_ramp.hpp"
#include "host-sim/pocket/zigzag_approach.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::Use;

/// Greatest length of a path along a wall from one line to the next, as a multiple of the distance
/// between lines.
constexpr double kLongestWay = 10.0;
/// Length below which a stretch is not driven, mm, because the neighbouring lines clear it.
constexpr double kMinStretchMm = 1.0e-6;

Side opposite(Side side) { return side == Side::kRight ? Side::kLeft : Side::kRight; }

/// Drives the lines of an area, from the lowest upwards.
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
        if (is_worth_a_line(stretch, y)) line.push_back({stretch, false});
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
  /// A line of the next level, with the turn that leads to it.
  struct Next {
    Line* line = nullptr;
    ZigzagTurn turn;
  };
  /// Beginning of a row.
  struct RowStart {
    Side side = Side::kRight;  ///< Side towards which the tool drives the first line of the row.
    double from_x = 0.0;
    bool is_beside = false;  ///< Whether the row begins next to the stock.
    std::optional<ZigzagApproach> approach{};
  };

  /// Returns whether a stretch is long enough and touches stock.
  [[nodiscard]] bool is_worth_a_line(const Stretch& stretch, double y) const {
    if (stretch.to_x - stretch.from_x <= kMinStretchMm) return false;
    if (!options_.stock) return true;
    const StockBox& stock = *options_.stock;
    const double middle = 0.5 * (stock.x0 + stock.x1);
    const double nearest_x = std::clamp(middle, stretch.from_x, stretch.to_x);
    return !is_idle(stock, {nearest_x, y}, options_.tool_radius_mm);
  }

  /// Returns the undriven line of a level whose left end is nearest to the tool in X; null if all
  /// lines of the level are driven.
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

  /// Returns the undriven line above to which the shortest turn leads, with this turn. Its line is
  /// null if no turn fits.
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
      if ((side == Side::kRight ? way : -way) < kMinStretchMm) continue;
      least = std::abs(turn->meets_at_x - turn->leaves_at_x);
      next = {&above, std::move(*turn)};
    }
    return next;
  }

  /// Finds the beginning of a row, if possible next to the stock: at an end of the row's first
  /// line, or with an approach along the wall.
  [[nodiscard]] RowStart start_of(const Stretch& line, double y) const {
    RowStart best{Side::kRight, line.from_x};
    if (!options_.stock) return best;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const double x = end_of(line, side);
      if (is_beside(*options_.stock, {x, y}, options_.tool_radius_mm)) {
        return {opposite(side), x, true};
      }
    }
    std::vector<RowStart> starts;
    for (const Side side : {Side::kLeft, Side::kRight}) {
      auto approach =
          approach_along_wall(space_, *options_.stock, options_.tool_radius_mm, line, y, side);
      if (!approach) continue;
      const double meets_at_x = approach->meets_at_x;
      starts.push_back({opposite(side), meets_at_x, true, std::move(approach)});
    }
    if (starts.empty()) return best;
    return *std::ranges::min_element(
        starts, {}, [](const RowStart& start) { return start.approach->length_mm; });
  }

  void drive_row(std::size_t level, Line& first) {
    Line* line = &first;
    const RowStart start = start_of(first.stretch, lines_[level].y);
    Side side = start.side;  // Side towards which the tool drives the line.
    double from_x = start.from_x;
    for (bool is_first = true; line != nullptr; is_first = false, ++level) {
      line->is_driven = true;
      Next next = next_of(level, *line, from_x, side);
      const double to_x =
          next.line != nullptr ? next.turn.leaves_at_x : end_of(line->stretch, side);
      const double y = lines_[level].y;
      if (is_first) begin_row(start, {from_x, y}, {to_x, y});
      writer_.pass({to_x, y});
      for (const WayElement& element : next.turn.way) writer_.pass(element.to, element.bulge);
      from_x = next.turn.meets_at_x;
      line = next.line;
      side = opposite(side);
    }
    at_ = writer_.place();
  }

  /// Moves the tool to the beginning of a row. @param to the end of the row's first line
  void begin_row(const RowStart& start, const WideVec2& from, const WideVec2& to) {
    if (!start.is_beside) return sink(from, to);
    if (!start.approach) return writer_.begin_row_in_cleared(from);
    writer_.begin_row_in_cleared(start.approach->from);
    for (const WayElement& element : start.approach->way) {
      writer_.pass(element.to, element.bulge);
    }
  }

  /// Descends at the beginning of a row forth and back along the row's first line, or plunges.
  void sink(const WideVec2& from, const WideVec2& to) {
    writer_.begin_row(from);
    if (options_.plunges) return writer_.go(Use::kEntry, from, 0.0, writer_.floor_z());
    const double pairs = legs_of_ramp(
        {.depth_mm = options_.depth_mm, .slope = options_.slope}, 2.0 * (to - from).norm(), from);
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

void drive_lines(const TurnSpace& space, const ZigzagOptions& options, Zigzag& out) {
  LineDriver{space, options, out}.drive_all();
}

}  // namespace sim::pocket
