#include "host-sim/measure/path_items.hpp"

#include <array>
#include <cmath>

namespace sim {
namespace {

constexpr double kNanometresPerMm = 1.0e6;

Point to_mm(const cnc::Position& place) {
  Point mm{};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    mm[axis] = static_cast<double>(place[axis].nanometres()) / kNanometresPerMm;
  }
  return mm;
}

cnc::Position to_position(const Point& mm) {
  cnc::Position place;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    place[axis] = cnc::Coordinate{std::llround(mm[axis] * kNanometresPerMm)};
  }
  return place;
}

cnc::PathElement element_of(const Curve& curve) {
  cnc::PathElement element{.start = to_position(curve.start()), .end = to_position(curve.end())};
  if (const auto& circle = curve.circle()) {
    element.plane = circle->plane;
    element.bulge = static_cast<float>(std::tan(0.25 * circle->sweep));
  }
  return element;
}

constexpr float kDutyPerSpeed = 0x1.0p-20F;

/// Returns the beam of a piece. As in the product, beams differ by their duty, and by whether the
/// power follows the speed.
cnc::motion::BeamCommand beam_of(const PathPiece& piece) {
  if (piece.travel == Travel::kRapid || piece.spindle == SpindleState::kOff) return {};
  return {.duty = static_cast<float>(piece.spindle_speed) * kDutyPerSpeed,
          .follows_speed = piece.spindle == SpindleState::kDynamic};
}

cnc::path::Tolerance tolerance_of(const PathPiece& piece) {
  return {.corner_mm = static_cast<float>(piece.tolerance.corner),
          .weld_mm = static_cast<float>(piece.tolerance.weld)};
}

}  // namespace

/// A bulge b means that the centre is to the left of the chord, at a distance of (1 − b²) / 4b
/// chord lengths.
PathPiece piece_of(const cnc::PathElement& element, float feed_mm_s, bool stop_before) {
  const Point start = to_mm(element.start);
  const Point end = to_mm(element.end);
  const auto bulge = static_cast<double>(element.bulge);
  const PlaneVectors plane{element.plane};
  const auto [start_x, start_y] = plane.seen(start);
  const auto [x, y] = plane.seen(end - start);
  const double aside = bulge == 0.0 ? 0.0 : (1.0 - bulge * bulge) / (4.0 * bulge);
  const std::array centre{start_x + x / 2.0 - aside * y, start_y + y / 2.0 + aside * x};
  return {.curve = bulge == 0.0 ? Curve::line(start, end)
                                : Curve::arc(start, end, element.plane, centre, bulge < 0.0),
          .travel = feed_mm_s > 0.0F ? Travel::kFeed : Travel::kRapid,
          .feed = static_cast<double>(feed_mm_s),
          .stop_before = stop_before};
}

void set_beam(PathPiece& piece, const cnc::motion::BeamCommand& beam) {
  piece.spindle_speed = static_cast<double>(beam.duty / kDutyPerSpeed);
  if (beam.duty <= 0.0F) return;
  piece.spindle = beam.follows_speed ? SpindleState::kDynamic : SpindleState::kConstant;
}

cnc::path::PathItem item_of(const PathPiece& piece) {
  cnc::path::PathItem item{.tolerance = tolerance_of(piece), .continues = piece.continues};
  item.request.element = element_of(piece.curve);
  item.request.feed_mm_s = piece.travel == Travel::kRapid ? 0.0F : static_cast<float>(piece.feed);
  item.request.beam = beam_of(piece);
  item.request.line = static_cast<std::uint32_t>(piece.line);
  return item;
}

}  // namespace sim
