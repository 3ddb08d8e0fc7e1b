#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/path/circle_fit.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Welds chains of short lines into arcs and lines, as few as it can find:
/// LinuxCNC's naive-CAM tolerance (G64 Q), with arcs.
///
/// A chain is of lines of X Y Z with the same feed, beam and tolerance and no outputs
/// between them. As long as they lie in a coordinate plane, their arcs do, too; where they
/// leave it, arcs of any plane begin. Each arc or line begins and ends in
/// a programmed point, so ends are met exactly, and goes on as far as the
/// points stay within the tolerance: the set of all circles that do (CircleFit)
/// shrinks with each point, so that points need not be kept and each costs the
/// same. The arc goes on in the direction of the one before where that takes it
/// at least half as far as it could get.
///
/// Guarantees: no point of the chain is farther than the tolerance from what is
/// driven, and no driven point farther than that from the chain. Where the
/// chain turns by more than kSharpTurn it is not welded: that is a corner, but for lines that are
/// shorter than the tolerance.
class Welder {
 public:
  static constexpr std::size_t kMostHeld = 40;

  /// Whether the item can be welded to what is held, or begin a chain.
  [[nodiscard]] bool takes(const PathItem& item) const;
  /// @pre takes(item), has_room()
  void put(const PathItem& item);
  [[nodiscard]] bool has_room() const { return count_ < kMostHeld && !closing_; }
  /// Nothing more will be welded to what is held. False when that was known.
  bool close() {
    const bool news = !closing_;
    closing_ = true;
    return news;
  }
  /// What is held is given out as far as it has been looked at.
  void hurry() { hurries_ = !empty(); }

  /// The next arc or line, until the next call of anything else; null when there is none
  /// yet. Looks at kMostLooks points at most.
  [[nodiscard]] const PathItem* next();
  void clear();

  [[nodiscard]] bool empty() const { return count_ == 0 && !fitting_; }
  /// Source line of the oldest line held; 0 for none.
  [[nodiscard]] motion::SourceLine line() const { return empty() ? motion::SourceLine{} : line_; }

 private:
  /// An end of a line.
  struct Point {
    std::array<Coordinate, kLinearAxisCount> place{};
    float aside_mm = 0.0F;  ///< As PathItem has it.
    motion::SourceLine line{};
  };
  /// An end that could be reached.
  struct Reach {
    std::size_t points = 0;  ///< From the start of the fit; 0 for none.
    std::size_t index = 0;   ///< Of those held, how many it goes past.
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
  /// Returns whether no place of a line of this length can leave the tolerance.
  [[nodiscard]] bool is_short(float mm) const { return mm <= chain_.tolerance.weld_mm; }
  [[nodiscard]] const Point& point(std::size_t index) const {
    return points_[(oldest_ + index) % kMostHeld];
  }
  [[nodiscard]] Vec3 way_to(const Point& point) const;
  [[nodiscard]] Position place_of(const Point& point) const;

  static constexpr int kMostLooks = 8;

  PathItem chain_{};        ///< What all have in common; the piece given out last.
  bool given_out_ = false;  ///< One was: the outputs before the chain went with it.
  std::array<Point, kMostHeld> points_{};
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  motion::SourceLine line_{};  ///< Of the oldest line held.
  bool closing_ = false;
  bool hurries_ = false;

  // The fit, from `from_` in the direction `ahead_`.
  Position from_{};
  Vec3 ahead_{1.0F, 0.0F, 0.0F};
  Vec3 towards_{0.0F, 0.0F, 0.0F};  ///< As the piece before bent; null where it did not.
  bool known_direction_ = false;    ///< `ahead_` is where the piece before ended.
  bool fitting_ = false;
  std::optional<Plane> plane_{};  ///< Holds all points of the fit; empty in space.
  CircleFit fit_{};
  std::size_t looked_at_ = 0;  ///< Of the points held.
  std::size_t points_fitted_ = 0;
  Vec3 last_{0.0F, 0.0F, 0.0F};
  Vec3 last_chord_{0.0F, 0.0F, 0.0F};  ///< That was not short; null for none.
  float reached_mm_ = 0.0F;            ///< From the start, by any point so far.
  float aside_mm_ = 0.0F;              ///< As PathItem has it, for the line at the start.
  Reach farthest_{};
  Reach smooth_{};  ///< In the direction of the piece before.
};

}  // namespace cnc::path
