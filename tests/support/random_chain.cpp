#include "tests/support/random_chain.hpp"

#include <cmath>

namespace proof {
namespace {

/// End of the chain so far.
struct ChainEnd {
  sim::Point place{};
  double heading = 0.0;  ///< Direction of travel, radians.

  sim::Curve line(double length) {
    const sim::Point start = place;
    place[0] += length * std::cos(heading);
    place[1] += length * std::sin(heading);
    return sim::Curve::line(start, place);
  }

  sim::Curve arc(double length, double sweep) {
    const sim::Point start = place;
    const double radius = length / sweep;  // Radius with a sign: positive for an arc to the left.
    const double x = start[0] - radius * std::sin(heading);
    const double y = start[1] + radius * std::cos(heading);
    heading += sweep;
    place[0] = x + radius * std::sin(heading);
    place[1] = y - radius * std::cos(heading);
    return sim::Curve::arc(start, place, cnc::Plane::kXY, {x, y}, sweep < 0.0);
  }
};

}  // namespace

sim::ProgrammedPath random_chain(Random& random, const ChainShape& shape) {
  sim::ProgrammedPath path;
  ChainEnd end;
  end.heading = random.between(-3.0, 3.0);
  for (std::size_t i = 0; i < shape.pieces; ++i) {
    const double length = random.magnitude(shape.min_length, shape.max_length);
    const double sweep = random.signed_magnitude(0.1, 3.0);
    const double feed = random.magnitude(5.0, 500.0);
    sim::PathPiece piece{.curve = random.chance(0.4) ? end.line(length) : end.arc(length, sweep)};
    piece.travel = shape.feeds ? sim::Travel::kFeed : sim::Travel::kRapid;
    piece.feed = feed;
    piece.stop_before = i == 0;
    path.pieces.push_back(piece);
  }
  path.end = end.place;
  return path;
}

}  // namespace proof
