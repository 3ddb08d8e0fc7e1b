#pragma once

#include <cstdint>
#include <vector>

namespace sim {

/// How a stretch of the path is driven and drawn.
enum class Move : std::uint8_t {
  kTravel,  ///< Rapid, or motion with the beam off that is not known to be a feed.
  kFeed,    ///< Feed with beam or spindle off.
  kCut,     ///< Feed with beam or spindle on.
};

/// The quantity that the colours of a picture show.
enum class Shown : std::uint8_t {
  kSpeed,  ///< Speed along X, Y and Z together, mm/s.
  kDepth,  ///< Depth of the tool, mm: below Z0, or below the highest cut along X or Y if all cuts
           ///< are above Z0.
  kPower,  ///< Share of the greatest output, 0…1.
};

/// A point of the path seen from above. The other members belong to the stretch that ends at the
/// point.
struct PathVertex {
  double x_mm = 0.0;
  double y_mm = 0.0;
  float speed_mm_s = 0.0F;  ///< Speed (0 for travel), or the depth or power if that is shown.
  Move move = Move::kTravel;
};

/// A polyline along the motion, ready to be drawn. It is empty if nothing moved.
struct Path {
  std::vector<PathVertex> vertices;
  double duration_s = 0.0;
  Shown shown = Shown::kSpeed;
};

}  // namespace sim
