#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/path/circle_fit.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Welds chains of short lines into as few arcs and lines as it can find. This corresponds to
/// LinuxCNC's naive-CAM tolerance (G64 Q), extended by arcs.
///
/// A chain consists of lines in X Y Z with the same feed, beam and tolerance and without outputs
/// between them. While the lines are in one coordinate plane, their arcs are, too. After the lines
/// leave this plane, arcs may be in any plane. Each arc or line begins and ends at a programmed
/// point. It continues as long as all points stay within the tolerance. CircleFit keeps the set of
/// all circles that pass the points. This set shrinks with each point, so points need not be kept,
/// and each point costs the same. An arc continues in the direction of the arc before it if it then
/// reaches at least half as many points as it could otherwise.
///
/// Guarantees: no point of the chain is farther than the tolerance from the driven path, and no
/// point of the driven path is farther than the tolerance from the chain. A turn of more than 45°
/// is a corner, where an arc or line ends, unless a line at it is shorter than the tolerance.
class Welder {
 public:
  static constexpr std::size_t kMaxHeld = 40;

  /// Returns whether the item can be welded to the held chain, or can begin a chain.
  [[nodiscard]] bool takes(const PathItem& item) const;
  /// Adds a line. @pre takes(item), has_room()
  void put(const PathItem& item);
  [[nodiscard]] bool has_room() const { return count_ < kMaxHeld && !closing_; }
  /// Closes the chain, so that nothing more is welded to it. Returns false if it was already
  /// closed.
  bool close() {
    const bool news = !closing_;
    closing_ = true;
    return news;
  }
  /// Releases the part of the chain whose points have been fitted.
  void hurry() { hurries_ = !empty(); }

  /// Returns the next arc or line, or null if there is none yet. It is valid until the next call of
  /// any member. Each call evaluates at most kMaxLooks points.
  [[nodiscard]] const PathItem* next();
  void clear();

  [[nodiscard]] bool empty() const { return count_ == 0 && !fitting_; }
  /// Returns the source line of the oldest held line; 0 if none is held.
  [[nodiscard]] motion::SourceLine line() const { return empty() ? motion::SourceLine{} : line_; }

 private:
  /// The end point of a line.
  struct Point {
    std::array<Coordinate, kLinearAxisCount> place{};
    float aside_mm = 0.0F;  ///< See PathItem::aside_mm.
    motion::SourceLine line{};
  };
  /// An end point that an arc or line of the present fit can have.
  struct Reach {
    /// Number of points from the start of the fit to this end; 0 if there is no such end.
    std::size_t points = 0;
    std::size_t index = 0;  ///< Number of held points up to this end.
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
  /// Returns whether a line of this length, in mm, is too short to leave the tolerance.
  [[nodiscard]] bool is_short(float mm) const { return mm <= chain_.tolerance.weld_mm; }
  [[nodiscard]] const Point& point(std::size_t index) const {
    return points_[(oldest_ + index) % kMaxHeld];
  }
  [[nodiscard]] Vec3 way_to(const Point& point) const;
  [[nodiscard]] Position place_of(const Point& point) const;

  static constexpr int kMaxLooks = 8;

  /// The properties that all lines of the chain share. Also the piece that was returned last.
  PathItem chain_{};
  /// True if a piece of the chain was returned. That piece had the outputs that come before the
  /// chain.
  bool given_out_ = false;
  std::array<Point, kMaxHeld> points_{};
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  motion::SourceLine line_{};  ///< Source line of the oldest held line.
  bool closing_ = false;
  bool hurries_ = false;

  // State of the present fit, which begins at `from_` in the direction `ahead_`.
  Position from_{};
  Vec3 ahead_{1.0F, 0.0F, 0.0F};
  /// Direction in which the piece before the fit bends; null if that piece is straight.
  Vec3 towards_{0.0F, 0.0F, 0.0F};
  /// True if `ahead_` is the direction at the end of the piece before the fit.
  bool known_direction_ = false;
  bool fitting_ = false;
  /// Coordinate plane that contains all points of the fit; empty if there is none.
  std::optional<Plane> plane_{};
  CircleFit fit_{};
  std::size_t looked_at_ = 0;  ///< Number of held points that are in the fit.
  std::size_t points_fitted_ = 0;
  Vec3 last_{0.0F, 0.0F, 0.0F};
  Vec3 last_chord_{0.0F, 0.0F, 0.0F};  ///< Last chord that is not short; null if there is none.
  /// Greatest distance of any point of the fit from its start.
  float reached_mm_ = 0.0F;
  float aside_mm_ = 0.0F;  ///< `PathItem::aside_mm` of the line at the start.
  Reach farthest_{};
  Reach smooth_{};  ///< Farthest end with an arc that begins in the direction of the piece before.
};

}  // namespace cnc::path
