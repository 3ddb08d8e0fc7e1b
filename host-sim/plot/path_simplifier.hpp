#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/plot/path.hpp"

namespace sim {

/// The greatest allowed differences between a path and its simplified form.
struct PathTolerance {
  double distance_mm = 0.01;
  float speed_mm_s = 1.0F;
};

/// Simplifies a path that arrives point by point: drops points that are near a straight stretch.
///
/// The method is that of the opening sector (C. M. Williams, "An efficient algorithm for the
/// piecewise linear approximation of planar curves", Computer Graphics and Image Processing 8,
/// 1978). Each point narrows the sector of directions, seen from the last vertex, that pass near
/// enough to the point. If a point is outside the sector, the point before it becomes a vertex.
/// Work and memory for each point are constant.
///
/// Guarantee: every dropped point is within the distance tolerance of the path, and its speed is
/// within the speed tolerance of its stretch. A change of `move` is always a vertex, unless it is
/// nearer to the last vertex than half of the tolerance. This exception bounds the number of
/// vertices by the length of the path.
class PathSimplifier {
 public:
  explicit PathSimplifier(const PathTolerance& tolerance) : tolerance_{tolerance} {}

  void set_speed_tolerance(float mm_s) { tolerance_.speed_mm_s = mm_s; }

  void push(const PathVertex& point);

  /// Drops vertices until there are at most `most` of them, by doubling the distance tolerance as
  /// often as necessary. The new tolerance also applies to later points.
  void thin_to(std::size_t most);

  /// Returns the vertices so far. The points after the last vertex are not included.
  [[nodiscard]] const std::vector<PathVertex>& vertices() const { return vertices_; }

  /// Ends the path at the last point that was pushed, returns all vertices, and empties the
  /// simplifier.
  [[nodiscard]] std::vector<PathVertex> finish();

 private:
  struct Direction {
    double x;
    double y;
  };

  [[nodiscard]] bool continues_stretch(const PathVertex& point) const;
  [[nodiscard]] bool is_driven_alike(const PathVertex& point) const;
  [[nodiscard]] bool is_in_sector(Direction direction) const;
  void narrow_sector(const PathVertex& point);
  void make_vertex(const PathVertex& point);

  /// Returns half of the width of the sector at a point: half of the tolerance. With this value,
  /// three errors stay below the tolerance: those of points near the vertex, of points beside the
  /// sector, and of points beyond the end of a stretch.
  [[nodiscard]] double half_width_mm() const { return 0.5 * tolerance_.distance_mm; }

  PathTolerance tolerance_;
  std::vector<PathVertex> vertices_;
  PathVertex last_;  ///< The last point that was pushed, at which the present stretch ends.
  bool is_stretch_open_ = false;  ///< True if points were pushed since the last vertex.
  bool has_sector_ = false;
  Direction right_bound_{};
  Direction left_bound_{};
  /// Greatest distance of a point of the present stretch from the start of the stretch.
  double reach_mm_ = 0.0;
};

/// Returns a path with fewer vertices, which is within the tolerance of the given path.
[[nodiscard]] std::vector<PathVertex> simplified(const std::vector<PathVertex>& vertices,
                                                 const PathTolerance& tolerance);

}  // namespace sim
