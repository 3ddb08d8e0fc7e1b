#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/compensation/fault.hpp"
#include "planner/compensation/held_path.hpp"

namespace cnc::compensation {

/// The last elements of a path, and the curve at an offset from them: raw curves in a row, each
/// driven from where it leaves the one before. Where two do not join they are cut at the first
/// place at which they meet and that is nowhere nearer to an edge than the offset; what lies
/// between is swallowed, as long as it is within four offsets of there.
///
/// A straight entry leads to the point beside its end, or to the corner of both offsets, or, where
/// it is too short for that, to the start of the next element's offset. Where it would cut the
/// corner at its end on the way, and that is an edge's, it leads to a tangent of the circle about
/// the corner and round it. An arc as the entry ends with its programmed tangent.
///
/// A bounded part of a path is known, and all holds within that part. Single precision, places
/// counted from the element that is asked for: right to 5e-5 mm where elements are up to
/// 0.3 m long.
class OffsetChain {
 public:
  /// @param distance_mm signed, positive is the right of the path; not 0
  void begin(const Position& start, Plane plane, float distance_mm);

  /// Appends an element; the oldest one goes where there is no room. @pre its chord is longer
  /// than kTouch or it stands, and the oldest has been given out if there are kCapacity
  void append(const HeldElement& added);
  /// No element follows.
  void finish();

  [[nodiscard]] const HeldPath& path() const { return path_; }
  [[nodiscard]] std::size_t size() const { return path_.size(); }
  [[nodiscard]] const HeldElement& at(std::size_t index) const { return path_.at(index); }
  [[nodiscard]] Place end() const { return path_.start_of(path_.size()); }
  [[nodiscard]] float distance() const { return distance_; }

  /// What is driven of a raw curve, as seen from the start of its element. @pre it is live
  [[nodiscard]] Curve driven(std::size_t index, Kind kind) const;
  /// Whether an element's part of the path is settled, and is nowhere too near to any edge that is
  /// known. @param last nothing follows the last element
  [[nodiscard]] std::optional<Fault> check(std::size_t index, bool last) const;
  /// Whether a straight line to a point, the exit, damages nothing; the join at the end of the
  /// path comes to live where the tool goes round the corner there first. @pre finished, not empty
  /// @param here where the tool is @param rapid it cuts nothing below its way
  [[nodiscard]] std::optional<Fault> leave(const Position& here, const Position& to, bool rapid);
  /// What has been given out stays as it is: the elements before `index`.
  void settle(std::size_t index) { settled_ = index; }
  [[nodiscard]] Fault fault(Reason reason, std::size_t index, std::size_t other) const;

 private:
  /// A raw curve by its place in their row.
  struct Name {
    std::size_t element = 0;
    Kind kind = Kind::kParallel;
    [[nodiscard]] std::size_t order() const {
      return kKinds * element + static_cast<std::size_t>(kind);
    }
  };
  [[nodiscard]] static Name name_at(std::size_t order) {
    return {order / kKinds, static_cast<Kind>(order % kKinds)};
  }
  [[nodiscard]] Stretch& stretch(Name name) {
    return path_.at(name.element).stretches[static_cast<std::size_t>(name.kind)];
  }
  [[nodiscard]] const Stretch& stretch(Name name) const {
    return path_.at(name.element).stretches[static_cast<std::size_t>(name.kind)];
  }
  [[nodiscard]] Curve own_curve(std::size_t index, const Place& origin) const;
  [[nodiscard]] bool has_raw(Name name) const;
  [[nodiscard]] Curve round_about(const Vec2& corner, const Vec2& before, const Vec2& after) const;
  [[nodiscard]] Curve raw(Name name, const Place& origin) const;
  /// Nowhere too near to an edge, or to anything that is known of the path.
  [[nodiscard]] bool is_clear(const Vec2& place, const Place& origin, bool of_all) const;
  [[nodiscard]] Vec2 round(const Vec2& direction, float length, float side) const;
  void aim(std::size_t entry, const Curve& after);
  void extend(std::size_t index);
  void rebuild();
  void add_raw(Name name, bool joins);
  void attach(Name name);
  [[nodiscard]] std::optional<Vec2> first_meeting(Name before, Name after) const;
  void link(Name before, Name after, const Vec2& place);
  void fail(Reason reason, Name before, std::size_t index, std::size_t other);
  [[nodiscard]] bool is_beside(const Vec2& cut, const Place& origin, std::size_t index) const;
  [[nodiscard]] bool could_be_cut(const Vec2& lost, const Vec2& cut, const Place& origin) const;
  [[nodiscard]] std::optional<std::size_t> too_near(const Curve& way,
                                                    const Place& origin,
                                                    std::size_t own,
                                                    Coordinate air) const;
  [[nodiscard]] Coordinate air_below(const Position& start, const Position& end, bool rapid) const;
  /// Nearer to an edge is too near, mm.
  [[nodiscard]] float limit() const;

  HeldPath path_{};
  std::size_t settled_ = 0;
  float distance_ = 0.0F;
  Vec2 entry_tangent_{1.0F, 0.0F};  ///< With which an entry that goes round its end reaches it.
  Vec2 exit_tangent_{1.0F, 0.0F};   ///< With which an exit that goes round its start leaves it.
  bool entry_rounds_ = false;
  bool exit_rounds_ = false;
  std::optional<Fault> trouble_{};   ///< Unless an outline closes that makes a lead of the cause.
  std::uint32_t trouble_after_ = 0;  ///< From this element on, counted from the entry, which is 0.
};

}  // namespace cnc::compensation
