#include "host-sim/cut/written_path.hpp"

#include <algorithm>
#include <cmath>

#include "planner/geometry/arc_elements.hpp"

namespace sim::cut {

using cnc::gcode::GridPlace;

namespace {

/// Returns the point in the middle of an arc.
Place apex_of(const Place& from, const Place& to, double bulge) {
  return 0.5 * (from + to) + 0.5 * bulge * right_of(to - from);
}

}  // namespace

WrittenPath::WrittenPath(cnc::gcode::PrintGrid grid, const Place& from)
    : grid_{grid}, here_{on_grid(from)} {}

GridPlace WrittenPath::on_grid(const Place& place) const {
  const auto digits = [this](double mm) {
    constexpr double kFarthest = cnc::gcode::kFarthestOnGrid;
    const double value = std::clamp(mm * grid_.per_mm(), -kFarthest, kFarthest);
    return static_cast<std::int32_t>(cnc::gcode::rounded(value));
  };
  return {digits(place.x()), digits(place.y())};
}

cnc::Position WrittenPath::position_of(GridPlace place) const {
  const std::int64_t nanometres = 1'000'000 / grid_.per_mm();
  cnc::Position position{};
  position[0] = cnc::Coordinate{place.x * nanometres};
  position[1] = cnc::Coordinate{place.y * nanometres};
  return position;
}

void WrittenPath::add_line(GridPlace to) {
  if (to == here_) return;
  elements_.push_back({.start = position_of(here_), .end = position_of(to)});
  here_ = to;
}

/// Adds an arc of at most half a turn, by the same rules as cnc::gcode::ProgramWriter.
void WrittenPath::add_arc(const Place& from, const Place& to, double bulge) {
  const GridPlace end = on_grid(to);
  const GridPlace chord = end - here_;
  const double length = std::hypot(chord.x, chord.y);
  const double size = std::abs(bulge);
  if (size * length < 0.5) return add_line(end);
  if (length * (1.0 + size * size) < 4.0 * size * cnc::gcode::kMinRadiusOnGrid) {
    add_line(on_grid(apex_of(from, to, bulge)));
    return add_line(end);
  }
  const auto centre = cnc::gcode::centre_on_grid(chord, bulge);
  if (!centre) return add_line(end);
  const cnc::Position start = position_of(here_);
  const std::int64_t nanometres = 100'000 / grid_.per_mm();
  const cnc::ArcElements arc{{.start = start,
                              .end = position_of(end),
                              .centre = {start[0] + cnc::Coordinate{centre->x * nanometres},
                                         start[1] + cnc::Coordinate{centre->y * nanometres}},
                              .clockwise = bulge < 0.0}};
  for (std::uint32_t i = 0; i < arc.count(); ++i) elements_.push_back(arc.element(i));
  here_ = end;
}

const std::vector<cnc::PathElement>& WrittenPath::next(const Stroke& stroke) {
  elements_.clear();
  if (stroke.bulge == 0.0) {
    add_line(on_grid(stroke.to));
  } else if (std::abs(stroke.bulge) <= 1.0) {
    add_arc(stroke.from, stroke.to, stroke.bulge);
  } else {
    const Place apex = apex_of(stroke.from, stroke.to, stroke.bulge);
    const double half = stroke.bulge / (1.0 + std::sqrt(1.0 + stroke.bulge * stroke.bulge));
    add_arc(stroke.from, apex, half);
    add_arc(apex, stroke.to, half);
  }
  return elements_;
}

}  // namespace sim::cut
