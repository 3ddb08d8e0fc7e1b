#include "host-sim/contour/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/contour/winding_rays.hpp"
#include "planner/contour/cutting.hpp"
#include "planner/contour/loop_writer.hpp"

namespace sim {
namespace {

using cnc::WideVec2;
using cnc::contour::Junction;
using cnc::contour::kNone;
using cnc::contour::Piece;
using cnc::contour::RawCurve;

constexpr std::size_t kFirstMeetings = 64;
constexpr int kMaxRounds = 4;

double reach_of(const cnc::contour::ContourView<double>& loops) {
  double most = 0.0;
  double faults = 0.0;  // Stays 0 if all numbers are finite, and becomes NaN otherwise.
  for (const ContourVertex& vertex : loops.vertices) {
    most = std::max({most, std::abs(vertex.x), std::abs(vertex.y)});
    faults += 0.0 * (vertex.x + vertex.y + vertex.bulge);
  }
  return most + faults;
}

RawCurve<double> reversed(const RawCurve<double>& raw) {
  const cnc::contour::Curve<double>& curve = raw.curve;
  return {{curve.end,
           curve.start,
           WideVec2{-curve.end_tangent},
           WideVec2{-curve.start_tangent},
           -curve.curvature},
          raw.end_node,
          raw.start_node};
}

}  // namespace

bool Arrangement::divide(const cnc::contour::ContourView<double>& loops, double touch_mm) {
  using Tolerance = cnc::contour::Tolerance<double>;
  const double reach = reach_of(loops);
  if (!std::isfinite(reach)) return false;
  tolerance_ = Tolerance::for_coordinates_up_to(reach);
  tolerance_.touch = std::max(tolerance_.touch, touch_mm);
  add_elements(loops);
  std::vector<RawCurve<double>> parts = raw_;
  std::vector<std::uint32_t> elements(raw_.size());
  std::iota(elements.begin(), elements.end(), 0U);
  for (int round = 0; round < kMaxRounds; ++round) {
    if (!cut(parts)) return false;
    const bool is_done = pieces_.size() == parts.size();
    std::vector<std::uint32_t> elements_of_pieces;
    for (Piece& piece : pieces_) elements_of_pieces.push_back(elements[piece.raw]);
    parts = parts_of_pieces(parts);
    elements = std::move(elements_of_pieces);
    if (is_done) break;
  }
  for (std::size_t i = 0; i < pieces_.size(); ++i) pieces_[i].raw = elements[i];
  make_edges();
  return true;
}

/// Divides curves into pieces at the points where they meet. Enlarges the storage until it
/// suffices. Returns false if there are more than kMaxMeetings meetings.
bool Arrangement::cut(const std::vector<RawCurve<double>>& curves) {
  const auto raw_count = static_cast<std::uint32_t>(curves.size());
  const auto node_count = static_cast<std::uint32_t>(nodes_.size());
  std::size_t cuts = raw_count + kFirstMeetings;
  for (;;) {
    space_.grow(raw_count, cuts);
    const auto space = space_.space();
    std::ranges::copy(curves, space.raw.begin());
    std::ranges::copy(nodes_, space.nodes.begin());
    cnc::contour::NodeSet<double> nodes{space.nodes, node_count};
    cnc::contour::Cutting<double> cutting{space, tolerance_, nodes, raw_count};
    if (cutting.find_meetings()) {
      const std::uint32_t pieces = cutting.divide();
      pieces_.assign(space.pieces.begin(), space.pieces.begin() + pieces);
      nodes_.assign(space.nodes.begin(), space.nodes.begin() + nodes.count());
      return true;
    }
    if (cuts >= kMaxMeetings) return false;
    cuts = std::min(4 * cuts, kMaxMeetings);
  }
}

/// Returns the pieces as separate curves. They must be divided again, because a node may have come
/// to lie on a curve that did not meet the curves of this node before.
std::vector<RawCurve<double>> Arrangement::parts_of_pieces(
    const std::vector<RawCurve<double>>& curves) const {
  std::vector<RawCurve<double>> parts;
  parts.reserve(pieces_.size());
  for (const Piece& piece : pieces_) {
    RawCurve<double> part{curves[piece.raw].curve, piece.start_node, piece.end_node};
    const WideVec2 start = place(piece.start_node);
    const WideVec2 end = place(piece.end_node);
    const WideVec2 leaving = part.curve.tangent_at(start);
    part.curve.end_tangent = part.curve.tangent_at(end);
    part.curve.start_tangent = leaving;
    part.curve.start = start;
    part.curve.end = end;
    parts.push_back(part);
  }
  return parts;
}

void Arrangement::add_elements(const cnc::contour::ContourView<double>& loops) {
  raw_.clear();
  nodes_.clear();
  loop_of_raw_.clear();
  for (std::size_t loop = 0; loop < loops.loop_ends.size(); ++loop) add_loop(loops, loop);
}

/// Adds the elements of a loop. Leaves out elements that are shorter than the touch distance. The
/// next element then begins where the last added element ended.
void Arrangement::add_loop(const cnc::contour::ContourView<double>& loops, std::size_t loop) {
  const std::uint32_t first = loops.loop_begin(loop);
  const std::uint32_t end = loops.loop_ends[loop];
  if (first == end) return;
  const std::size_t first_raw = raw_.size();
  WideVec2 from = loops.vertices[first].point();
  for (std::uint32_t i = first; i < end; ++i) {
    const WideVec2 to = loops.vertices[i + 1 < end ? i + 1 : first].point();
    const double bulge = loops.vertices[i].bulge;
    if ((to - from).norm() <= tolerance_.touch) continue;
    if (std::abs(bulge) > 1.0) {
      const WideVec2 middle = 0.5 * (from + to - bulge * cnc::left_normal(WideVec2{to - from}));
      const double half = bulge / (1.0 + std::sqrt(1.0 + bulge * bulge));
      add_element(from, middle, half);
      add_element(middle, to, half);
    } else {
      add_element(from, to, bulge);
    }
    from = to;
  }
  if (raw_.size() < first_raw + 2) {
    raw_.resize(first_raw);
    return;
  }
  // Elements may have been left out at the end of the loop. Together they are shorter than the
  // touch distance, so the last added element can end at the start of the loop.
  raw_.back().curve.end = raw_[first_raw].curve.start;
  for (std::size_t i = first_raw; i < raw_.size(); ++i) {
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({raw_[i].curve.start, node});
    raw_[i].start_node = node;
    if (i > first_raw) raw_[i - 1].end_node = node;
    loop_of_raw_.push_back(static_cast<std::uint32_t>(loop));
  }
  raw_.back().end_node = raw_[first_raw].start_node;
}

void Arrangement::add_element(const WideVec2& from, const WideVec2& to, double bulge) {
  const auto arc = cnc::WideArc::make(from, to, bulge);
  if (arc.ok()) raw_.push_back({cnc::contour::curve_of(arc.value()), kNone, kNone});
}

/// Sorts pieces by the nodes at their ends, and makes one edge of each set of pieces that lie on
/// top of each other.
void Arrangement::make_edges() {
  edges_.clear();
  owners_.clear();
  std::vector<std::uint32_t> order(pieces_.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [this](std::uint32_t i) {
    const auto [low, high] = std::minmax(pieces_[i].start_node, pieces_[i].end_node);
    return std::pair{low, high};
  };
  std::ranges::sort(order, [&key](std::uint32_t a, std::uint32_t b) {
    return std::pair{key(a), a} < std::pair{key(b), b};
  });
  std::vector<std::uint32_t> same_ends;
  for (std::size_t from = 0; from < order.size();) {
    same_ends.clear();
    const auto ends = key(order[from]);
    for (; from < order.size() && key(order[from]) == ends; ++from) {
      same_ends.push_back(order[from]);
    }
    add_edges(same_ends);
  }
  windings_ = WindingRays{edges_, owners_, pieces_, raw_, loop_of_raw_, nodes_}.find_all();
}

/// Adds the edges between two nodes.
/// @param pieces all pieces between these nodes
void Arrangement::add_edges(std::vector<std::uint32_t>& pieces) {
  auto from = pieces.begin();
  while (from != pieces.end()) {
    const Piece first = pieces_[*from];
    const auto apart = std::stable_partition(
        from + 1, pieces.end(), [&](std::uint32_t i) { return coincide(first, pieces_[i]); });
    add_edge(std::span<const std::uint32_t>{from, apart});
    from = apart;
  }
}

/// Adds the edge that stands for some pieces.
/// @param pieces pieces on top of each other
void Arrangement::add_edge(std::span<const std::uint32_t> pieces) {
  const Piece& first = pieces_[pieces.front()];
  const auto number = static_cast<std::uint32_t>(edges_.size());
  ArrangedEdge edge{.raw = first.raw,
                    .from_node = first.start_node,
                    .to_node = first.end_node,
                    .first_owner = static_cast<std::uint32_t>(owners_.size())};
  for (const std::uint32_t i : pieces) {
    const std::uint32_t loop = loop_of_raw_[pieces_[i].raw];
    auto owner = std::find_if(owners_.begin() + edge.first_owner,
                              owners_.end(),
                              [loop](const EdgeOwner& other) { return other.loop == loop; });
    if (owner == owners_.end()) owner = owners_.insert(owners_.end(), {.loop = loop});
    ++(pieces_[i].start_node == edge.from_node ? owner->along : owner->against);
    pieces_[i].next = number;
  }
  edge.end_owner = static_cast<std::uint32_t>(owners_.size());
  edges_.push_back(edge);
}

bool Arrangement::coincide(const Piece& a, const Piece& b) const {
  const WideVec2 middle = raw_[a.raw].curve.middle_between(place(a.start_node), place(a.end_node));
  const cnc::contour::Curve<double>& other = raw_[b.raw].curve;
  return other.faces(middle, tolerance_.touch) &&
         other.from_circle(middle) <= 4.0 * tolerance_.touch;
}

WideVec2 Arrangement::middle(const ArrangedEdge& edge) const {
  return raw_[edge.raw].curve.middle_between(place(edge.from_node), place(edge.to_node));
}

double Arrangement::length_mm(const ArrangedEdge& edge) const {
  const WideVec2& from = place(edge.from_node);
  const WideVec2& to = place(edge.to_node);
  const double bulge = std::abs(raw_[edge.raw].curve.bulge_between(from, to));
  const double chord = (to - from).norm();
  return bulge < 1.0e-6 ? chord : chord * (1.0 + bulge * bulge) / bulge * std::atan(bulge);
}

/// Converts the kept edges to curves without removing any nodes, and writes the curves as loops.
bool Arrangement::write_loops(std::span<const DirectedEdge> kept, Contour& out) {
  if (kept.empty()) return true;
  junctions_.resize(nodes_.size());
  std::vector<RawCurve<double>> curves;
  std::vector<Piece> pieces;
  std::vector<cnc::contour::Run> runs;
  for (const DirectedEdge& directed : kept) {
    const ArrangedEdge& edge = edges_[directed.edge];
    junctions_[edge.from_node] = junctions_[edge.to_node] = {};
    const std::uint32_t from = directed.is_reversed ? edge.to_node : edge.from_node;
    const std::uint32_t to = directed.is_reversed ? edge.from_node : edge.to_node;
    const auto number = static_cast<std::uint32_t>(curves.size());
    curves.push_back(directed.is_reversed ? reversed(raw_[edge.raw]) : raw_[edge.raw]);
    pieces.push_back({.raw = number, .start_node = from, .end_node = to});
    runs.push_back({.first_piece = number, .start_node = from, .end_node = to});
  }
  for (std::uint32_t i = 0; i < runs.size(); ++i) {
    Junction& start = junctions_[runs[i].start_node];
    runs[i].next_out = start.first_out;
    runs[i].standing = cnc::contour::Standing::kKept;
    start.first_out = i;
    ++start.out;
    ++junctions_[runs[i].end_node].in;
  }
  const bool leads_back = std::ranges::all_of(pieces, [this](const Piece& piece) {
    const Junction& end = junctions_[piece.end_node];
    return end.in == end.out;
  });
  if (!leads_back) return false;
  cnc::contour::OffsetSpace<double> space{};
  space.raw = slice_of(curves);
  space.nodes = slice_of(nodes_);
  space.pieces = slice_of(pieces);
  space.runs = slice_of(runs);
  space.junctions = slice_of(junctions_);
  const cnc::contour::NodeSet<double> nodes{space.nodes, 0};
  std::vector<ContourVertex> vertices(pieces.size() + 1);
  std::vector<std::uint32_t> ends(pieces.size() + 1);
  cnc::contour::ContourWriter<double> writer{slice_of(vertices), slice_of(ends)};
  const auto run_count = static_cast<std::uint32_t>(runs.size());
  if (!cnc::contour::LoopWriter<double>{space, nodes, writer}.write(run_count)) return false;
  append_loops(writer.view(), out);
  return true;
}

}  // namespace sim
