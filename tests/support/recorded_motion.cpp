#include "tests/support/recorded_motion.hpp"

#include <cmath>

namespace proof {
namespace {

/// Returns the curve of a block, from its ends and from its centre, to which the curvature vector
/// at the start points.
sim::Curve curve_of_block(const ExactBlock& block) {
  const Vector start = block.place_at(0.0);
  const Vector end = block.place_at(1.0);
  if (!block.turns()) return sim::Curve::line(start, end);
  const sim::PlaneVectors plane{block.plane()};
  const auto bend = plane.seen(block.bend_at(0.0));
  const auto tangent = plane.seen(block.tangent_at(0.0));
  const double reach = block.radius() / std::hypot(bend[0], bend[1]);
  auto centre = plane.seen(start);
  for (std::size_t i = 0; i < centre.size(); ++i) centre[i] += reach * bend[i];
  const double side = tangent[0] * bend[1] - tangent[1] * bend[0];
  return sim::Curve::arc(start, end, block.plane(), centre, side < 0.0);
}

sim::PathPiece piece_of(const PlannedBlock& block) {
  sim::PathPiece piece{.curve = curve_of_block(block.exact)};
  const auto feed = static_cast<double>(block.block.feed);
  piece.travel = feed > 0.0 ? sim::Travel::kFeed : sim::Travel::kRapid;
  piece.feed = feed * block.exact.feed_length() / block.exact.length();
  piece.stop_before = block.from_rest;
  return piece;
}

}  // namespace

RecordedMotion motion_of(const RecordedPlan& plan) {
  constexpr double kWhole = 4294967296.0;
  RecordedMotion motion;
  std::vector<double> starts;
  double length = 0.0;
  for (const PlannedBlock& block : plan.blocks) {
    motion.path.pieces.push_back(piece_of(block));
    starts.push_back(length);
    length += motion.path.pieces.back().curve.length();
  }
  for (const TimedSlice& timed : plan.slices) {
    const cnc::motion::Slice& slice = timed.slice;
    const double fraction = static_cast<double>(slice.from_fraction) / kWhole;
    motion.pieces.push_back(
        {.duration = static_cast<double>(slice.duration),
         .place = starts[slice.block] + fraction * plan.blocks[slice.block].exact.length(),
         .speed = static_cast<double>(slice.start_speed),
         .acceleration = static_cast<double>(slice.acceleration)});
  }
  return motion;
}

}  // namespace proof
