#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// Follows a machine along its programmed path, position by position.
///
/// It keeps the earliest point of the path at which the machine may be, called the place. From
/// there it looks ahead, piece by piece. It stops where the path is farther away than the nearest
/// point found so far plus a few steps and plus the path's tolerance. The tolerance counts because
/// the corner of a rounded hairpin is farther away than its legs by this much. The place only
/// advances, so that a path that crosses itself or returns over itself is not mistaken for a later
/// or an earlier part of itself. A piece is examined only while the machine is within that distance
/// of it: constant work for each position, unless many pieces lie within a few steps.
///
/// The place may trail the machine by a step or two: of all points nearly as near as the nearest,
/// the earliest is taken, because the path before the place is never examined again. On a curve the
/// place trails farther, by the possible error of the arcs that replace the curve.
class PathFollower {
 public:
  /// Begins at the start of the path, which must outlive the follower.
  /// @param step one step of each axis, mm or degrees
  PathFollower(const ProgrammedPath& path, const Point& step);
  PathFollower(ProgrammedPath&& path, const Point& step) = delete;

  struct Match {
    std::size_t piece = 0;
    Nearest nearest{};
  };

  /// Returns the nearest point of the path ahead, and advances the place. On a path without pieces
  /// the point is the start.
  Match advance(const Point& position);

  /// Returns the axis excess of the position that was last given to `advance`: the minimum over the
  /// points ahead of the greatest |position − point| − half a step of any axis, mm or degrees.
  /// @param enough the search stops at a point whose excess is at most this
  [[nodiscard]] double axis_excess(const Point& position,
                                   double enough = -std::numeric_limits<double>::infinity()) const;

  /// Returns the first piece on which the machine may still be.
  [[nodiscard]] std::size_t piece() const { return piece_; }

 private:
  [[nodiscard]] double excess_at(const Point& position, const Point& place) const;
  [[nodiscard]] double excess_between(
      const Point& position, const Curve& curve, double low, double high, double enough) const;
  [[nodiscard]] double piece_excess(const Point& position, const Match& match, double enough) const;
  /// Fills the window and returns its nearest point.
  [[nodiscard]] Match look_ahead(const Point& position);
  [[nodiscard]] double window(std::size_t index) const;
  [[nodiscard]] double from(std::size_t index) const { return index == piece_ ? fraction_ : 0.0; }
  [[nodiscard]] const Curve& curve(std::size_t index) const { return path_->pieces[index].curve; }
  /// Returns the distance by which the arcs of a controller may be off a curve; 0 for lines and
  /// arcs.
  [[nodiscard]] double arcs_of(std::size_t index) const {
    return path_->pieces[index].tolerance.spline;
  }
  void move_to(const Match& match, const Point& position, double near);
  [[nodiscard]] double earliest_near(const Match& match, const Point& position, double near) const;

  const ProgrammedPath* path_;
  Point step_;
  double step_size_ = 0.0;  ///< Diagonal of one step of all axes that the path moves.
  std::size_t piece_ = 0;
  double fraction_ = 0.0;
  std::size_t latest_ = 0;     ///< The last piece that contained the nearest point.
  std::vector<Match> window_;  ///< The near pieces from the place onwards, in order.
};

}  // namespace sim
