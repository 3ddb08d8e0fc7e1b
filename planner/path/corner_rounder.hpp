#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/path/blend.hpp"

namespace cnc::path {

/// An element of which at least one corner is not settled.
struct HeldItem {
  PathItem item{};
  Position start{};      ///< Start of the part that the previous corner has left of the element.
  float used_mm = 0.0F;  ///< Length that the previous corner takes of the element, mm in the plane.
  motion::Joint joint = motion::Joint::kStop;
};

/// Rounds the corners of a path, element by element as they come.
///
/// An element is held until both its corners are settled, because the length that one corner may
/// take depends on the need of the other. Each corner may take about half of the element, and also
/// the part that the other corner does not need. So the corners of a polygon that approximates a
/// circle meet near the middles of its edges. The circle that touches all edges is then driven,
/// without pieces of line between its arcs.
///
/// A corner lies at the middle of its blend. Up to there speed, beam and source line are those of
/// the earlier element; from there on they are those of the later one, outputs included.
///
/// Consecutive pieces of the result join exactly. Each joint is smooth or an exact stop.
class CornerRounder {
 public:
  /// @param limits must outlive this.
  explicit CornerRounder(const motion::Limits& limits) : limits_{limits} {}

  /// Returns the next piece in order, or null when none is settled. The piece is valid until the
  /// next call of any member.
  [[nodiscard]] const PathPiece* next();
  /// Returns whether all settled pieces have been taken: put() or flush() may be called.
  [[nodiscard]] bool has_room() const { return taken_ == ready_count_; }
  /// Takes an element. @pre has_room(), and the element begins where the one before ended
  void put(const PathItem& item);
  /// Settles the held elements; the path ends here for now. The next element begins smoothly if it
  /// continues in the same direction, and otherwise from a stop.
  /// @pre has_room()
  void flush();
  /// Announces the kind of the next element: a corner that will be a stop anyway need not wait for
  /// it. @pre has_room()
  void expect(const PathItem& item);
  void clear();

  [[nodiscard]] bool empty() const { return !first_ && has_room(); }
  /// Returns whether the held path is to be driven without a stop before it.
  [[nodiscard]] bool goes_on() const { return first_ && first_->joint == motion::Joint::kSmooth; }
  /// Returns the source line of the oldest held element; 0 if none is held.
  [[nodiscard]] motion::SourceLine line() const;

 private:
  [[nodiscard]] const PathItem* newest() const;
  void meet(const PathItem& item);
  void settle(float allowance_mm);
  void blend(float trim_mm, bool in_halves);
  void give_blend(const Blend& blend, motion::Joint joint, float trim_mm, bool in_halves);
  [[nodiscard]] float granted(float allowance_mm) const;
  [[nodiscard]] float without_crumbs(float trim_mm) const;
  [[nodiscard]] bool is_stop_sooner_than(float trim_mm) const;
  void give_rest(const HeldItem& held, const Position& end, float left_mm);
  [[nodiscard]] motion::MotionRequest& begin_giving(const HeldItem& held);
  void give(motion::Joint joint);

  /// Greatest number of pieces at a time: the rest of one element, a blend of two, and the element
  /// after.
  static constexpr std::size_t kMaxReady = 4;

  const motion::Limits& limits_;
  std::optional<HeldItem> first_{};
  std::optional<HeldItem> second_{};  ///< Held only if the corner between the two is to be rounded.
  Corner corner_{};                   ///< Corner between `first_` and `second_`.
  Corner next_corner_{};              ///< Corner before the item that is being put.
  /// The last element that was given out without a corner after it.
  std::optional<PathItem> last_{};
  std::array<PathPiece, kMaxReady> ready_{};
  std::size_t ready_count_ = 0;
  std::size_t taken_ = 0;
  bool stop_left_over_ = false;  ///< There was a stop before a piece of which nothing is left.
};

}  // namespace cnc::path
