#include "host-sim/pocket/area_clearer.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "host-sim/pocket/axis_entry.hpp"

namespace sim::pocket {

using cnc::WideVec2;
using cnc::pocket::ToolCircle;

AreaClearer::AreaClearer(const OwnedArea& area,
                         const CarveGraph& graph,
                         const AdaptiveOptions& options,
                         CrescentDriver& driver)
    : area_{area},
      graph_{graph},
      options_{options},
      driver_{driver},
      at_node_(graph.nodes.size()),
      is_reached_(graph.nodes.size()),
      is_taken_(graph.pieces.size()) {
  for (std::size_t i = 0; i < graph.pieces.size(); ++i) {
    const CarvePiece& piece = graph.pieces[i];
    at_node_[piece.from].push_back(i);
    if (piece.to != piece.from) at_node_[piece.to].push_back(i);
  }
}

ToolCircle AreaClearer::circle_of(std::uint32_t node) const {
  const AxisPoint& point = graph_.nodes[node];
  return {point.place, point.radius - options_.tool_radius_mm};
}

/// Clears each part, beginning at its first node in this order: nodes whose discs are free of
/// stock, then the other nodes; the widest first among both.
void AreaClearer::clear() {
  std::vector<std::uint32_t> nodes(graph_.nodes.size());
  std::iota(nodes.begin(), nodes.end(), 0U);
  const auto is_wider = [this](std::uint32_t a, std::uint32_t b) {
    const bool is_a_free = driver_.is_free(circle_of(a));
    if (is_a_free != driver_.is_free(circle_of(b))) return is_a_free;
    return graph_.nodes[a].radius > graph_.nodes[b].radius;
  };
  std::stable_sort(nodes.begin(), nodes.end(), is_wider);
  for (const std::uint32_t node : nodes) {
    if (!is_reached_[node] && circle_of(node).radius >= 0.0) clear_part(node);
  }
}

void AreaClearer::clear_part(std::uint32_t start) {
  const ToolCircle circle = circle_of(start);
  if (driver_.is_free(circle)) {
    driver_.take_free_disc(circle);
  } else {
    driver_.open_disc(circle, way_from(start));
  }
  is_reached_[start] = true;
  way_back_.clear();
  std::vector<Frame> frames{{start, circle, {}}};
  while (!frames.empty()) {
    const Frame& frame = frames.back();
    const std::optional<std::size_t> piece = piece_left_at(frame.node);
    if (piece) {
      return_to(frame.circle);
      clear_piece(*piece, frames);
    } else {
      std::ranges::copy(frame.way_back, std::back_inserter(way_back_));
      frames.pop_back();
    }
  }
}

/// Returns the points of a piece in order, beginning at `node`, which is one of its ends.
std::vector<AxisPoint> AreaClearer::points_from(std::uint32_t node, std::size_t piece) const {
  std::vector<AxisPoint> points = graph_.pieces[piece].points;
  if (graph_.pieces[piece].from != node) std::ranges::reverse(points);
  return points;
}

/// Returns the longest path for a ramp from a node along one of its pieces.
std::vector<WideVec2> AreaClearer::way_from(std::uint32_t node) const {
  // The ramp leads forth and then back over the same length.
  const double longest_mm = 0.5 * options_.depth_mm / options_.slope;
  std::vector<WideVec2> best{graph_.nodes[node].place};
  for (const std::size_t piece : at_node_[node]) {
    std::vector<WideVec2> places{best.front()};
    for (const AxisPoint& point : points_from(node, piece)) places.push_back(point.place);
    std::vector<WideVec2> way = fitting_way(places, *area_, options_.tool_radius_mm, longest_mm);
    if (way_length(way) > way_length(best)) best = std::move(way);
  }
  return best;
}

std::optional<std::size_t> AreaClearer::piece_left_at(std::uint32_t node) const {
  for (const std::size_t piece : at_node_[node]) {
    if (!is_taken_[piece]) return piece;
  }
  return std::nullopt;
}

void AreaClearer::clear_piece(std::size_t index, std::vector<Frame>& frames) {
  const CarvePiece& piece = graph_.pieces[index];
  const Frame& frame = frames.back();
  const std::uint32_t end = piece.from == frame.node ? piece.to : piece.from;
  const AxisCourse course{area_, points_from(frame.node, index), options_.tool_radius_mm};
  const bool is_dead_end = at_node_[end].size() == 1 && end != frame.node;
  is_taken_[index] = true;
  CourseDrive done = driver_.drive(course, frame.circle, is_dead_end);
  // If the course leads around an island, the tool is back on the circle from which it started.
  if (done.is_complete && end == frame.node) done.way_back.clear();
  const bool goes_on = done.is_complete && !is_reached_[end];
  // Crescents end before the tip of a corner. The tip must not get its own entry.
  if (done.is_complete || is_dead_end) is_reached_[end] = true;
  if (goes_on) {
    frames.push_back({end, circle_of(end), std::move(done.way_back)});
  } else {
    way_back_ = std::move(done.way_back);
  }
}

/// Drives the pending return (`way_back_`). Lifts the tool instead if the return is too long.
void AreaClearer::return_to(const ToolCircle& circle) {
  std::vector<WideVec2> places;
  for (const ToolCircle& disc : way_back_) places.push_back(disc.centre);
  if (driver_.is_up() && driver_.is_free(circle)) {
    // The tool stays up. It descends before its next cut.
  } else if (driver_.is_up() || way_length(places) > options_.return_limit_mm) {
    driver_.come_down(circle);
  } else if (!way_back_.empty()) {
    way_back_.push_back(circle);
    driver_.drive_back(way_back_);
  }
  way_back_.clear();
}

void split_at_widest(CarveGraph& graph) {
  constexpr double kWider = 1.0e-6;  // mm, above rounding errors.
  const std::size_t count = graph.pieces.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<AxisPoint> points = graph.pieces[i].points;
    const auto widest = std::ranges::max_element(points, {}, &AxisPoint::radius);
    const double ends = std::max(points.front().radius, points.back().radius);
    if (widest->radius <= ends + kWider) continue;
    const auto node = static_cast<std::uint32_t>(graph.nodes.size());
    graph.nodes.push_back(*widest);
    graph.pieces.push_back({node, graph.pieces[i].to, {widest, points.end()}});
    graph.pieces[i].to = node;
    graph.pieces[i].points.assign(points.begin(), widest + 1);
  }
}

}  // namespace sim::pocket
