#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/path/circle_fit.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Welds chains of short lines into arcs and lines, as few as it can find. This is LinuxCNC's
/// naive-CAM tolerance (G64 Q), extended by arcs.
///
/// A chain consists of lines in X Y Z with the same feed, beam and tolerance and without outputs
/// between them. As long as the lines lie in a coordinate plane, their arcs do, too; where they
/// leave it, arcs of any plane begin. Each arc or line begins and ends in a programmed point, so
/// ends are met exactly. It continues as far as the points stay within the tolerance. The set of
/// all circles that pass the points (CircleFit) shrinks with each point, so that points need not be
/// kept and each costs the same. An arc continues in the direction of the arc before where it then
/// reaches at least half as far as it could otherwise.
///
/// Guarantees: no point of the chain is farther than the tolerance from the driven path, and no
/// point of the driven path is farther than the tolerance from the chain. Where the chain turns by
/// more than 45° it is not welded: that is a corner, except at lines that are shorter than the
/// tolerance.
class Welder {
 public:
  static constexpr std::size_t kMaxHeld = 40;

  /// Returns whether the item can be welded to what is held, or can begin a chain.
  [[nodiscard]] bool takes(const PathItem& item) const;
  /// Takes a line. @pre takes(item), has_room()
  void put(const PathItem& item);
  [[nodiscard]] bool has_room() const { return count_ < kMaxHeld && !closing_; }
  /// Closes the chain: nothing more will be welded to it. Returns false if it was already closed.
  bool close() {
    const bool news = !closing_;
    closing_ = true;
    return news;
  }
  /// Releases the chain as far as its points have been fitted.
  void hurry() { hurries_ = !empty(); }

  /// Returns the next arc or line; null when there is none yet. The item is valid until the next
  /// call of any member. Evaluates kMaxLooks points at most.
  [[nodiscard]] const PathItem* next();
  void clear();

  [[nodiscard]] bool empty() const { return count_ == 0 && !fitting_; }
  /// Returns the source line of the oldest held line; 0 if none is held.
  [[nodiscard]] motion::SourceLine line() const { return empty() ? motion::SourceLine{} : line_; }

 private:
  /// End point of a line.
  struct Point {
    std::array<Coordinate, kLinearAxisCount> place{};
    float aside_mm = 0.0F;  ///< As in PathItem.
    motion::SourceLine line{};
  };
  /// An end point that an arc or line of the present fit can reach.
  struct Reach {
    std::size_t points = 0;  ///< Number of points from the start of the fit; 0 if none was reached.
    std::size_t index = 0;   ///< Number of held points that it passes.
    Point end{};
    Vec3 seen{0.0F, 0.0F, 0.0F};
    FitCircle circle{};
  };

  void begin_fit();
  [[nodiscard]] bool look();
  void choose_plane(const Vec3& way);
  [[nodiscard]] bool goes_on(const Vec3& here, const Vec3& chord) const;
  void note_reach(const Vec3& here);
  void finish();
  [[nodiscard]] PathElement element_to(const Reach& reach) const;
  void go_to(const Reach& reach);
  void forget_points();
  void forget_first(std::size_t count);
  [[nodiscard]] bool alike(const PathItem& item) const;
  [[nodiscard]] float tolerance_of(const Point& point, const Vec3& here) const;
  /// Returns whether a line of this length is too short to leave the tolerance.
  [[nodiscard]] bool is_short(float mm) const { return mm <= chain_.tolerance.weld_mm; }
  [[nodiscard]] const Point& point(std::size_t index) const {
    return points_[(oldest_ + index) % kMaxHeld];
  }
  [[nodiscard]] Vec3 way_to(const Point& point) const;
  [[nodiscard]] Position place_of(const Point& point) const;

  static constexpr int kMaxLooks = 8;

  /// Properties that all lines of the chain share; also the piece given out last.
  PathItem chain_{};
  bool given_out_ = false;  ///< A piece was given out: the outputs before the chain went with it.
  std::array<Point, kMaxHeld> points_{};
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  motion::SourceLine line_{};  ///< Source line of the oldest held line.
  bool closing_ = false;
  bool hurries_ = false;

  // The present fit, which begins at `from_` in the direction `ahead_`.
  Position from_{};
  Vec3 ahead_{1.0F, 0.0F, 0.0F};
  /// Direction in which the piece before bent; null where it was straight.
  Vec3 towards_{0.0F, 0.0F, 0.0F};
  bool known_direction_ = false;  ///< `ahead_` is the direction in which the piece before ended.
  bool fitting_ = false;
  std::optional<Plane> plane_{};  ///< Plane that contains all points of the fit; empty in space.
  CircleFit fit_{};
  std::size_t looked_at_ = 0;  ///< Number of held points that have been fitted.
  std::size_t points_fitted_ = 0;
  Vec3 last_{0.0F, 0.0F, 0.0F};
  Vec3 last_chord_{0.0F, 0.0F, 0.0F};  ///< Last chord that was not short; null if there is none.
  float reached_mm_ = 0.0F;            ///< Greatest distance of any point so far from the start.
  float aside_mm_ = 0.0F;              ///< `PathItem::aside_mm` of the line at the start.
  Reach farthest_{};
  Reach smooth_{};  ///< Farthest reach that begins in the direction of the piece before.
};

}  // namespace cnc::path
