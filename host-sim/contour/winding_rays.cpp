#include "host-sim/contour/winding_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sim {
namespace {

using cnc::WideVec2;
using cnc::contour::kNone;
using cnc::contour::Piece;

/// Returns a vector, rotated by a quarter turn if the ray goes upwards. Computations can then
/// assume that all rays go along x.
WideVec2 turned(const WideVec2& way, bool upwards) {
  return upwards ? WideVec2{way.y(), -way.x()} : way;
}

/// Returns the crossing of a ray along x, which begins at `from`, with a part of a curve that only
/// rises or only falls: +1 if the part rises, -1 if it falls, 0 if the ray misses it.
/// @param curvature curvature of the part in its direction of travel
/// @param side side of `from` as returned by Curve::side()
int crossing_of_part(const WideVec2& start,
                     const WideVec2& end,
                     const WideVec2& from,
                     double curvature,
                     double side) {
  const bool rises = start.y() <= from.y();
  if (rises == (end.y() <= from.y())) return 0;
  const WideVec2& low = rises ? start : end;
  const WideVec2& high = rises ? end : start;
  const bool left_of_chord = cnc::cross(WideVec2{high - low}, WideVec2{from - low}) > 0.0;
  bool left = left_of_chord;
  if (curvature != 0.0) {
    const bool inside = curvature > 0.0 ? side < 0.0 : side > 0.0;
    // A rising curve that turns left is on the right of its chord.
    const bool lies_right = (curvature > 0.0) == rises;
    if (lies_right && !left_of_chord) left = inside;
    if (!lies_right && left_of_chord) left = !inside;
  }
  if (!left) return 0;
  return rises ? 1 : -1;
}

void add_turns(Windings& windings, std::uint32_t loop, int turns) {
  const auto at = std::ranges::lower_bound(windings, loop, {}, &LoopTurns::loop);
  if (at != windings.end() && at->loop == loop) {
    at->turns += turns;
  } else {
    windings.insert(at, {loop, turns});
  }
}

void drop_zeros(Windings& windings) {
  std::erase_if(windings, [](const LoopTurns& turns) { return turns.turns == 0; });
}

}  // namespace

WindingRays::WindingRays(std::vector<ArrangedEdge>& edges,
                         std::span<const EdgeOwner> owners,
                         std::span<const Piece> pieces,
                         std::span<const cnc::contour::RawCurve<double>> raw,
                         std::span<const std::uint32_t> loop_of_raw,
                         std::span<const cnc::contour::Node<double>> nodes)
    : edges_{edges},
      owners_{owners},
      pieces_{pieces},
      raw_{raw},
      loop_of_raw_{loop_of_raw},
      nodes_{nodes},
      boxes_(cnc::contour::BoxTree<double>::size_for(pieces.size())),
      tree_{{boxes_.data(), boxes_.size()}},
      degree_(nodes.size(), 0),
      ends_(nodes.size(), {kNone, kNone}) {}

std::vector<Windings> WindingRays::find_all() {
  index_pieces();
  link_edges();
  for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
    if (edges_[edge].left != kNone) continue;
    find(edge);
    follow(edge, true);
    follow(edge, false);
  }
  return std::move(windings_);
}

void WindingRays::index_pieces() {
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    cnc::contour::Curve<double> part = raw_[pieces_[i].raw].curve;
    const WideVec2 start = nodes_[pieces_[i].start_node].place;
    const WideVec2 end = nodes_[pieces_[i].end_node].place;
    part.start_tangent = part.tangent_at(start);
    part.end_tangent = part.tangent_at(end);
    part.start = start;
    part.end = end;
    tree_.leaf(i) = part.box();
  }
  tree_.build(static_cast<std::uint32_t>(pieces_.size()));
}

void WindingRays::link_edges() {
  for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
    for (const std::uint32_t node : {edges_[edge].from_node, edges_[edge].to_node}) {
      if (degree_[node] < 2) ends_[node].at(degree_[node]) = edge;
      ++degree_[node];
    }
  }
}

void WindingRays::find(std::uint32_t number) {
  ArrangedEdge& edge = edges_[number];
  const cnc::contour::Curve<double>& curve = raw_[edge.raw].curve;
  const WideVec2 middle =
      curve.middle_between(nodes_[edge.from_node].place, nodes_[edge.to_node].place);
  const WideVec2 tangent = curve.tangent_at(middle);
  const bool upwards = std::abs(tangent.x()) > std::abs(tangent.y());
  const bool rises = turned(tangent, upwards).y() > 0.0;
  Windings left = turns_beside(number, middle, upwards);
  Windings right = left;
  for (std::uint32_t i = edge.first_owner; i < edge.end_owner; ++i) {
    const EdgeOwner& owner = owners_[i];
    if (rises) {
      add_turns(left, owner.loop, owner.step());
    } else {
      add_turns(right, owner.loop, -owner.step());
    }
  }
  drop_zeros(left);
  drop_zeros(right);
  edge.left = static_cast<std::uint32_t>(windings_.size());
  edge.right = edge.left + 1;
  windings_.push_back(std::move(left));
  windings_.push_back(std::move(right));
}

/// Copies the windings of an edge to the edges that follow it, up to the next node at which loops
/// meet.
void WindingRays::follow(std::uint32_t number, bool forwards) {
  for (std::size_t bound = 0; bound < edges_.size(); ++bound) {
    const ArrangedEdge& edge = edges_[number];
    const std::uint32_t node = forwards ? edge.to_node : edge.from_node;
    if (degree_[node] != 2) return;
    const std::uint32_t next = ends_[node][0] == number ? ends_[node][1] : ends_[node][0];
    ArrangedEdge& other = edges_[next];
    if (other.left != kNone) return;
    const bool goes_on = forwards == (other.from_node == node);
    other.left = goes_on ? edge.left : edge.right;
    other.right = goes_on ? edge.right : edge.left;
    forwards = other.from_node == node;
    number = next;
  }
}

Windings WindingRays::turns_beside(std::uint32_t edge, const WideVec2& from, bool upwards) {
  cnc::contour::FlatBox<double> ray{from.x(), from.y(), from.x(), from.y()};
  (upwards ? ray.y1 : ray.x1) = std::numeric_limits<double>::infinity();
  Windings windings;
  tree_.search(ray, 0, [&](std::uint32_t i) {
    const Piece& piece = pieces_[i];
    if (piece.next == edge) return true;
    const int turns = crossing(piece, from, upwards);
    if (turns != 0) add_turns(windings, loop_of_raw_[piece.raw], turns);
    return true;
  });
  drop_zeros(windings);
  return windings;
}

/// Returns the sum of the crossings of a ray with a piece. The piece is divided at its highest or
/// lowest point, if it has one between its ends.
int WindingRays::crossing(const Piece& piece, const WideVec2& from, bool upwards) const {
  const cnc::contour::Curve<double>& curve = raw_[piece.raw].curve;
  const WideVec2 start_place = nodes_[piece.start_node].place;
  const WideVec2 end_place = nodes_[piece.end_node].place;
  const WideVec2 start = turned(start_place, upwards);
  const WideVec2 end = turned(end_place, upwards);
  const WideVec2 place = turned(from, upwards);
  if (curve.curvature == 0.0) return crossing_of_part(start, end, place, 0.0, 0.0);
  const double side = curve.side(from);
  const WideVec2 leaving = turned(curve.tangent_at(start_place), upwards);
  const WideVec2 arriving = turned(curve.tangent_at(end_place), upwards);
  if (leaving.y() * arriving.y() >= 0.0) {
    return crossing_of_part(start, end, place, curve.curvature, side);
  }
  // Cosine of the direction of travel at the dividing point: 1 or -1, because the curve is level
  // there.
  const double cosine = curve.curvature * leaving.y() > 0.0 ? -1.0 : 1.0;
  const double same = cosine * leaving.x();
  const double rise =
      same > 0.0 ? -cosine * leaving.y() * leaving.y() / (1.0 + same) : leaving.x() - cosine;
  const WideVec2 turning{start.x() - leaving.y() / curve.curvature,
                         start.y() + rise / curve.curvature};
  return crossing_of_part(start, turning, place, curve.curvature, side) +
         crossing_of_part(turning, end, place, curve.curvature, side);
}

}  // namespace sim
