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

/// A point of the path seen from above, and how the stretch that ends in it was driven.
struct PathVertex {
  double x_mm = 0.0;
  double y_mm = 0.0;
  float speed_mm_s = 0.0F;  ///< Along X, Y and Z together; 0 for travel.
  Move move = Move::kTravel;
};

/// A polyline through the motion, ready to be drawn. Empty when nothing moved.
struct Path {
  std::vector<PathVertex> vertices;
  double duration_s = 0.0;
};

}  // namespace sim
