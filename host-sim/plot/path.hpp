#pragma once

#include <cstdint>
#include <vector>

namespace sim {

/// How a stretch of the path is driven and drawn.
enum class Move : std::uint8_t {
  kTravel,  ///< Rapid, or the beam is off and nobody said that it is a feed.
  kFeed,    ///< Feed with beam or spindle off.
  kCut,     ///< Feed with beam or spindle on.
};

/// The quantity that the colours of a picture show.
enum class Shown : std::uint8_t {
  kSpeed,  ///< Along X, Y and Z together, mm/s.
  kDepth,  ///< Of the tool, mm: below Z0, or below the highest cut along X or Y where all are above
           ///< it.
  kPower,  ///< Share of the greatest output, 0…1.
};

/// A point of the path seen from above, and how the stretch that ends in it was driven.
struct PathVertex {
  double x_mm = 0.0;
  double y_mm = 0.0;
  float speed_mm_s = 0.0F;  ///< 0 for travel. In a path of depth or power, that instead.
  Move move = Move::kTravel;
};

/// A polyline through the motion, ready to be drawn. Empty when nothing moved.
struct Path {
  std::vector<PathVertex> vertices;
  double duration_s = 0.0;
  Shown shown = Shown::kSpeed;
};

}  // namespace sim
