#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/path/blend.hpp"

namespace cnc::path {

/// An element whose corners are not both settled.
struct HeldItem {
  PathItem item{};
  Position start{};      ///< Of what the corner before has left of it.
  float used_mm = 0.0F;  ///< By that corner, in the plane.
  motion::Joint joint = motion::Joint::kStop;
};

/// Rounds the corners of a path, element by element as they come.
///
/// An element is held until both its corners are settled: how much of it a
/// corner may take depends on what the other one needs. Each may have about half
/// of it, and what the other does not want. So the corners of a polygon that
/// approximates a circle meet near the middles of its edges, and the circle that
/// touches all of them is driven, without a piece of line between its arcs.
///
/// A corner lies at the middle of its blend: up to there speed, beam and line
/// are the earlier element's, from there on the later one's, outputs included.
///
/// Pieces given out join exactly. Each joint is smooth or an exact stop.
class CornerRounder {
 public:
  /// @param limits must outlive this.
  explicit CornerRounder(const motion::Limits& limits) : limits_{limits} {}

  /// The next piece, in order, until the next call of anything else; null when there is none
  /// that is settled.
  [[nodiscard]] const PathPiece* next();
  /// All that was settled has been given out: put() or flush() may be called.
  [[nodiscard]] bool has_room() const { return taken_ == ready_count_; }
  /// @pre has_room(), and it begins where the one before ended
  void put(const PathItem& item);
  /// Settles what is held; the path ends here for now. What comes next begins
  /// smoothly if it goes on in the same direction, and else from a stop.
  /// @pre has_room()
  void flush();
  /// What comes next is made of this: a corner that will be a stop anyway need
  /// not be waited for. @pre has_room()
  void expect(const PathItem& item);
  void clear();

  [[nodiscard]] bool empty() const { return !first_ && has_room(); }
  /// What is held is to be driven without a stop before it.
  [[nodiscard]] bool goes_on() const { return first_ && first_->joint == motion::Joint::kSmooth; }
  /// Source line of the oldest element held; 0 for none.
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

  /// The rest of one element, a blend of two, and the one after.
  static constexpr std::size_t kMostReady = 4;

  const motion::Limits& limits_;
  std::optional<HeldItem> first_{};
  std::optional<HeldItem> second_{};  ///< Only where the corner between them is to be rounded.
  Corner corner_{};                   ///< Between the two.
  Corner next_corner_{};              ///< Before the item that is being put.
  std::optional<PathItem> last_{};    ///< The last that was given out without a corner after it.
  std::array<PathPiece, kMostReady> ready_{};
  std::size_t ready_count_ = 0;
  std::size_t taken_ = 0;
  bool stop_left_over_ = false;  ///< Before a piece of which nothing is left.
};

}  // namespace cnc::path
