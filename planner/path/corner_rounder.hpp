#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/path/blend.hpp"

namespace cnc::path {

/// An element with at least one corner that is not settled.
struct HeldItem {
  PathItem item{};
  Position start{};      ///< Start of the part that the previous corner has left.
  float used_mm = 0.0F;  ///< Length that the previous corner has taken from the element, mm.
  motion::Joint joint = motion::Joint::kStop;
};

/// Rounds the corners of a path, one element after the other.
///
/// An element is held until both of its corners are settled, because the length that one corner may
/// take depends on the length that the other one requires. Each corner may take about half of the
/// element, and also the part that the other corner does not require. So the corners of a polygon
/// that approximates a circle join near the middles of its edges. Then the machine drives the
/// circle that touches all edges, without lines between its arcs.
///
/// A corner is at the middle of its blend. The first half of the blend has the speed, the beam and
/// the source line of the earlier element. The second half has those of the later element, and its
/// outputs.
///
/// Consecutive pieces of the result join exactly. Each joint is smooth or an exact stop.
class CornerRounder {
 public:
  /// @param limits must outlive this object
  explicit CornerRounder(const motion::Limits& limits) : limits_{limits} {}

  /// Returns the next settled piece in order, or null if there is none. The piece is valid until
  /// the next call of any member.
  [[nodiscard]] const PathPiece* next();
  /// Returns whether next() has returned all settled pieces, so that put() or flush() may be
  /// called.
  [[nodiscard]] bool has_room() const { return taken_ == ready_count_; }
  /// Adds an element. @pre has_room(), and the element begins at the end of the element before
  void put(const PathItem& item);
  /// Settles the held elements, because no further element is known. The next element begins
  /// smoothly if it continues in the same direction. Otherwise it begins from a stop.
  /// @pre has_room()
  void flush();
  /// Announces the kind of the next element. If the corner before it will be a stop in any case,
  /// the held elements are settled now. @pre has_room()
  void expect(const PathItem& item);
  void clear();

  [[nodiscard]] bool empty() const { return !first_ && has_room(); }
  /// Returns whether the motion continues into the held path without a stop.
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

  /// Greatest number of settled pieces: the rest of an element, a blend of two arcs, and the next
  /// element.
  static constexpr std::size_t kMaxReady = 4;

  const motion::Limits& limits_;
  std::optional<HeldItem> first_{};
  /// Held only if the corner between `first_` and `second_` is to be rounded.
  std::optional<HeldItem> second_{};
  Corner corner_{};       ///< Corner between `first_` and `second_`.
  Corner next_corner_{};  ///< Corner before the item that is being added.
  /// The last element before a flush, while no later element is held.
  std::optional<PathItem> last_{};
  std::array<PathPiece, kMaxReady> ready_{};
  std::size_t ready_count_ = 0;
  std::size_t taken_ = 0;
  bool stop_left_over_ = false;  ///< True if there was a stop before a piece that was omitted.
};

}  // namespace cnc::path
