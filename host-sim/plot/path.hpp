#pragma once

#include <cstdint>
#include <vector>

namespace sim {

/// The kind of motion of a stretch of the path, which decides how the stretch is drawn.
enum class Move : std::uint8_t {
  kTravel,  ///< Rapid, or motion with the beam off that is not known to be a feed.
  kFeed,    ///< Feed with beam or spindle off.
  kCut,     ///< Feed with beam or spindle on.
};

/// The quantity that the colours of a picture show.
enum class Shown : std::uint8_t {
  kSpeed,  ///< Speed along X, Y and Z together, mm/s.
  /// Depth of the tool below Z0, mm. If all cuts are above Z0, the depth below the highest cut
  /// along X or Y.
  kDepth,
  kPower,  ///< Output as a share of the greatest output, 0…1.
};

/// A point of the path seen from above. The other members belong to the stretch that ends at the
/// point.
struct PathVertex {
  double x_mm = 0.0;
  double y_mm = 0.0;
  /// Speed, mm/s (0 for travel). If the picture shows depth or power: depth, mm, or power, 0…1.
  float speed_mm_s = 0.0F;
  Move move = Move::kTravel;
};

/// The path of a motion as a polyline that can be drawn directly. It is empty if nothing moved.
struct Path {
  std::vector<PathVertex> vertices;
  double duration_s = 0.0;
  Shown shown = Shown::kSpeed;
};

}  // namespace sim
