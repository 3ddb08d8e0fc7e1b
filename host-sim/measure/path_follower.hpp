#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// Follows a machine along its programmed path, position by position.
///
/// It holds the earliest place on the path where the machine may be and looks
/// ahead from there, piece by piece, until the path has gone farther away than
/// the nearest point found so far plus a few steps and the path's tolerance, by which
/// the corner of a rounded hairpin is farther than its legs. The place only advances. So
/// a path that crosses itself or returns over itself is not mistaken for a
/// later or an earlier part of itself, and a piece is looked at only while the
/// machine is as near as that to it: constant work per position, unless many
/// pieces lie within a few steps.
///
/// The place may trail the machine by a step or two: of points nearly as near
/// as the nearest, the earliest is taken, because a place once passed is
/// never looked at again. On a curve it trails by as much more as the arcs in
/// place of the curve may be off.
class PathFollower {
 public:
  /// `path` must outlive the follower. `step` is one step of each axis, mm or degrees.
  PathFollower(const ProgrammedPath& path, const Point& step);
  PathFollower(ProgrammedPath&& path, const Point& step) = delete;

  struct Match {
    std::size_t piece = 0;
    Nearest nearest{};
  };

  /// The nearest point of the path ahead; moves the place on. On a path without
  /// pieces it is the start.
  Match advance(const Point& position);

  /// For the position last given to `advance`: the least over the points ahead of the
  /// greatest |position − point| − half a step of any axis, mm or degrees. Stops
  /// at a point that is no more than `enough` off.
  [[nodiscard]] double axis_excess(const Point& position,
                                   double enough = -std::numeric_limits<double>::infinity()) const;

  /// The first piece on which the machine may still be.
  [[nodiscard]] std::size_t piece() const { return piece_; }

 private:
  [[nodiscard]] double excess_at(const Point& position, const Point& place) const;
  [[nodiscard]] double excess_between(
      const Point& position, const Curve& curve, double low, double high, double enough) const;
  [[nodiscard]] double piece_excess(const Point& position, const Match& match, double enough) const;
  /// Fills the window; returns its nearest point.
  [[nodiscard]] Match look_ahead(const Point& position);
  [[nodiscard]] double window(std::size_t index) const;
  [[nodiscard]] double from(std::size_t index) const { return index == piece_ ? fraction_ : 0.0; }
  [[nodiscard]] const Curve& curve(std::size_t index) const { return path_->pieces[index].curve; }
  /// By how much the arcs of a controller may be off a curve; 0 for lines and arcs.
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
  std::size_t latest_ = 0;     ///< The last piece that had the nearest point.
  std::vector<Match> window_;  ///< The near pieces ahead of the place, in order.
};

}  // namespace sim
