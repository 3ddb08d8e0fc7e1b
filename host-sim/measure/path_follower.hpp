#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// Follows a machine along its programmed path, position by position.
///
/// The follower stores the place: the earliest point of the path at which the machine may be. From
/// the place, it searches ahead, piece by piece. The search ends where the path is too far from the
/// machine: the distance exceeds the smallest distance so far by more than a few steps plus the
/// path's tolerance. The tolerance is included because the corner of a rounded hairpin is farther
/// from the machine than the hairpin's legs by that amount. The place only advances. Therefore the
/// follower does not confuse parts of a path that crosses itself or returns over itself. The work
/// for each position is constant, unless many pieces are within a few steps.
///
/// The place may trail the machine by a step or two. Several points may have nearly the smallest
/// distance from the machine. The follower takes the earliest of them, because it never examines
/// the path before the place again. On a curve, the place trails farther, by the possible error of
/// the arcs that replace the curve.
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

  /// Returns the nearest point of the path from the place on, and advances the place. For a path
  /// without pieces, the result is the start of the path.
  Match advance(const Point& position);

  /// Returns the axis excess of `position`, which must be the last argument of advance(). At each
  /// point of the path ahead, the greatest |position − point| − half a step of all axes counts. The
  /// axis excess is the minimum of these values over all points ahead, mm or degrees.
  /// @param enough the search stops at a point whose excess is at most this
  [[nodiscard]] double axis_excess(const Point& position,
                                   double enough = -std::numeric_limits<double>::infinity()) const;

  /// Returns the index of the first piece on which the machine may still be.
  [[nodiscard]] std::size_t piece() const { return piece_; }

 private:
  [[nodiscard]] double excess_at(const Point& position, const Point& place) const;
  [[nodiscard]] double excess_between(
      const Point& position, const Curve& curve, double low, double high, double enough) const;
  [[nodiscard]] double piece_excess(const Point& position, const Match& match, double enough) const;
  /// Fills the window with the near pieces and returns the nearest point.
  [[nodiscard]] Match look_ahead(const Point& position);
  [[nodiscard]] double window(std::size_t index) const;
  [[nodiscard]] double from(std::size_t index) const { return index == piece_ ? fraction_ : 0.0; }
  [[nodiscard]] const Curve& curve(std::size_t index) const { return path_->pieces[index].curve; }
  /// Returns the greatest distance of a controller's arcs from the curve that they replace; 0 for
  /// lines and arcs.
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
  std::size_t latest_ = 0;     ///< Index of the last piece that contained the nearest point.
  std::vector<Match> window_;  ///< The pieces near the machine from the place on, in order.
};

}  // namespace sim
