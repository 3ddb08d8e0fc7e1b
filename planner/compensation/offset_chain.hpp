#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/compensation/fault.hpp"
#include "planner/compensation/held_path.hpp"

namespace cnc::compensation {

/// The last elements of a path, and the curve at an offset from them, which the tool drives. The
/// curve consists of consecutive raw curves: each is the offset of an element, or the arc around
/// the corner at its end. If two raw curves do not join, both are cut at their first meeting that
/// is nowhere nearer to an edge than the offset. The raw curves in between are swallowed if they
/// are within four offsets of that meeting.
///
/// A straight entry leads to the end of its own offset. If this offset intersects the offset of the
/// next element, the entry leads to their intersection. If the entry is too short to reach the
/// intersection, it leads to the start of the next element's offset. If the entry would cut into an
/// edge that begins at its end, it leads along a tangent of the circle about its end, and then
/// around this corner. An arc as the entry ends with its programmed tangent.
///
/// Only a bounded number of elements is known, and all checks compare only these elements. The
/// computation is in single precision, with coordinates relative to the element that is computed:
/// errors are at most 5e-5 mm if elements are up to 0.3 m long.
class OffsetChain {
 public:
  /// Begins a path. @param distance_mm signed offset, positive is to the right of the path; not 0
  void begin(const Position& start, Plane plane, float distance_mm);

  /// Appends an element. If the capacity is exhausted, the oldest element is forgotten.
  /// @pre the element's chord is longer than kTouch, or the element does not move in the plane. If
  ///     there are kCapacity elements, the oldest has been given out
  void append(const HeldElement& added);
  /// Ends the path: no element follows.
  void finish();

  [[nodiscard]] const HeldPath& path() const { return path_; }
  [[nodiscard]] std::size_t size() const { return path_.size(); }
  [[nodiscard]] const HeldElement& at(std::size_t index) const { return path_.at(index); }
  [[nodiscard]] Place end() const { return path_.start_of(path_.size()); }
  [[nodiscard]] float distance() const { return distance_; }

  /// Returns the part of a raw curve that the tool drives, relative to the start of the element
  /// `index`.
  /// @param kind the offset of the element, or the arc around the corner at its end
  /// @pre a part of the raw curve is driven (Stretch::live)
  [[nodiscard]] Curve driven(std::size_t index, Kind kind) const;
  /// Returns a fault if the offset of an element cannot be driven, or if it is too near to a known
  /// edge.
  /// @param last whether no element follows the last known element
  [[nodiscard]] std::optional<Fault> check(std::size_t index, bool last) const;
  /// Returns a fault if the exit, a straight line to the point `to`, would cut into the part. If
  /// the tool first goes around the corner at the end of the path, the arc around that corner
  /// becomes part of the driven curve.
  /// @pre finished, not empty
  /// @param here position of the tool, from which the exit begins
  /// @param rapid the exit is a rapid, which cuts nothing below its path
  [[nodiscard]] std::optional<Fault> leave(const Position& here, const Position& to, bool rapid);
  /// Declares that the elements before `index` must not change, because they have been given out.
  void settle(std::size_t index) { settled_ = index; }
  [[nodiscard]] Fault fault(Reason reason, std::size_t index, std::size_t other) const;

 private:
  /// Name of a raw curve: its element and its kind. order() is its index in the sequence of all raw
  /// curves.
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
  /// Returns whether a point is far enough from all edges or, if `of_all`, from all known elements.
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
  /// Returns the least permitted distance from an edge, mm.
  [[nodiscard]] float limit() const;

  HeldPath path_{};
  std::size_t settled_ = 0;
  float distance_ = 0.0F;
  /// Tangent with which an entry that goes around the corner at its end reaches the circle about
  /// this corner.
  Vec2 entry_tangent_{1.0F, 0.0F};
  /// Tangent with which an exit that goes around the corner at its start leaves the circle about
  /// this corner.
  Vec2 exit_tangent_{1.0F, 0.0F};
  bool entry_rounds_ = false;
  bool exit_rounds_ = false;
  /// Fault that check() reports, unless its cause has become part of a lead.
  std::optional<Fault> trouble_{};
  /// Number of the element after which check() reports the fault. The entry has number 0.
  std::uint32_t trouble_after_ = 0;
};

}  // namespace cnc::compensation
