#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/plot/path.hpp"

namespace sim {

/// What a simplified path may differ by.
struct PathTolerance {
  double distance_mm = 0.01;
  float speed_mm_s = 1.0F;
};

/// Drops the points of a stream that a straight stretch passes closely enough.
///
/// Opening-sector method (C. M. Williams, "An efficient algorithm for the
/// piecewise linear approximation of planar curves", Computer Graphics and
/// Image Processing 8, 1978): each point narrows the sector of directions, seen
/// from the last vertex, that pass it closely enough; a point outside the
/// sector makes the point before it a vertex. Constant work and memory per point.
///
/// Guarantee: every dropped point lies within the distance tolerance of the
/// path, and its speed within the speed tolerance of its stretch. A change of
/// `move` is always a vertex, unless it comes closer to the last vertex than
/// half of the tolerance, which bounds the vertices by the length of the path.
class PathSimplifier {
 public:
  explicit PathSimplifier(const PathTolerance& tolerance) : tolerance_{tolerance} {}

  void set_speed_tolerance(float mm_s) { tolerance_.speed_mm_s = mm_s; }

  void push(const PathVertex& point);

  /// Drops vertices, with twice the distance tolerance for these and for what
  /// comes as often as there are more than `most`.
  void thin_to(std::size_t most);

  /// The vertices so far, but not the points since the last of them.
  [[nodiscard]] const std::vector<PathVertex>& vertices() const { return vertices_; }

  /// Ends the path with the last point pushed, and empties the simplifier.
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

  /// Each of three errors (points near the vertex, beside the sector, behind
  /// the end) stays below the tolerance when the sector uses this share of it.
  [[nodiscard]] double half_width_mm() const { return 0.5 * tolerance_.distance_mm; }

  PathTolerance tolerance_;
  std::vector<PathVertex> vertices_;
  PathVertex last_;               ///< The last point pushed; ends the stretch.
  bool is_stretch_open_ = false;  ///< There are points since the last vertex.
  bool has_sector_ = false;
  Direction right_bound_{};
  Direction left_bound_{};
  double reach_mm_ = 0.0;  ///< The greatest distance of the stretch from its start.
};

/// The same path with fewer vertices.
[[nodiscard]] std::vector<PathVertex> simplified(const std::vector<PathVertex>& vertices,
                                                 const PathTolerance& tolerance);

}  // namespace sim
