#include "host-sim/pocket/depth_writer.hpp"

#include "planner/pocket/loop_measures.hpp"

namespace sim::pocket {

using cnc::WideVec2;
using cnc::pocket::Use;

void DepthWriter::begin_row(const WideVec2& place) {
  end_row();
  out_.points.push_back({place.x(), place.y(), 0.0, 0.0, Use::kEntry});
}

void DepthWriter::begin_row_in_cleared(const WideVec2& place) {
  begin_row(place);
  go(Use::kLink, place, 0.0, z_);
}

void DepthWriter::go_unless_there(Use use, const WideVec2& to) {
  if ((to - place()).norm() > kSamePlaceMm) go(use, to, 0.0, z_);
}

WideVec2 DepthWriter::heading() const {
  const std::size_t row_begin = out_.row_ends.empty() ? 0 : out_.row_ends.back();
  if (out_.points.size() < row_begin + 2) return {0.0, 0.0};
  const auto& from = out_.points[out_.points.size() - 2];
  const auto& to = out_.points.back();
  cnc::contour::Curve<double> curve;
  const bool moves = cnc::pocket::make_curve({from.point(), to.point(), from.bulge}, curve);
  return moves ? curve.end_tangent : WideVec2{0.0, 0.0};
}

void DepthWriter::go(Use use, const WideVec2& to, double bulge, double z) {
  out_.points.back().use = use;
  out_.points.back().bulge = bulge;
  out_.points.push_back({to.x(), to.y(), z, 0.0, use});
}

void DepthWriter::circle(Use use, const WideVec2& centre) {
  const WideVec2 start = place();
  go(use, 2.0 * centre - start, 1.0, z());
  go(use, start, 1.0, z());
}

}  // namespace sim::pocket
