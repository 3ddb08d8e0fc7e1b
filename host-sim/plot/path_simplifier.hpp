#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/plot/path.hpp"

namespace sim {

/// The allowed difference between a path and its simplified form.
struct PathTolerance {
  double distance_mm = 0.01;
  float speed_mm_s = 1.0F;
};

/// Drops points of a stream near which a straight stretch passes.
///
/// The method is that of the opening sector (C. M. Williams, "An efficient algorithm for the
/// piecewise linear approximation of planar curves", Computer Graphics and Image Processing 8,
/// 1978). Each point narrows the sector of directions, seen from the last vertex, that pass near
/// enough to the point. A point outside the sector makes the point before it a vertex. Work and
/// memory for each point are constant.
///
/// Guarantee: every dropped point lies within the distance tolerance of the path, and its speed is
/// within the speed tolerance of its stretch. A change of `move` is always a vertex, unless it is
/// nearer to the last vertex than half of the tolerance. That exception bounds the number of
/// vertices by the length of the path.
class PathSimplifier {
 public:
  explicit PathSimplifier(const PathTolerance& tolerance) : tolerance_{tolerance} {}

  void set_speed_tolerance(float mm_s) { tolerance_.speed_mm_s = mm_s; }

  void push(const PathVertex& point);

  /// Drops vertices until there are at most `most` of them. Each time that there are more, the
  /// distance tolerance is doubled, for these vertices and for later points.
  void thin_to(std::size_t most);

  /// Returns the vertices so far, without the points after the last vertex.
  [[nodiscard]] const std::vector<PathVertex>& vertices() const { return vertices_; }

  /// Ends the path with the last point pushed, returns all vertices, and empties the simplifier.
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

  /// Returns half of the sector's width. With this share of the tolerance each of three errors
  /// stays below the tolerance: that of points near the vertex, next to the sector, and beyond the
  /// end.
  [[nodiscard]] double half_width_mm() const { return 0.5 * tolerance_.distance_mm; }

  PathTolerance tolerance_;
  std::vector<PathVertex> vertices_;
  PathVertex last_;               ///< The last point pushed, where the present stretch ends.
  bool is_stretch_open_ = false;  ///< There are points since the last vertex.
  bool has_sector_ = false;
  Direction right_bound_{};
  Direction left_bound_{};
  double reach_mm_ = 0.0;  ///< The greatest distance of points of the stretch from its start.
};

/// Returns the same path with fewer vertices.
[[nodiscard]] std::vector<PathVertex> simplified(const std::vector<PathVertex>& vertices,
                                                 const PathTolerance& tolerance);

}  // namespace sim
