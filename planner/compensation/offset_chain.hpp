#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/base/coordinate.hpp"
#include "planner/compensation/clearance.hpp"
#include "planner/compensation/fault.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::compensation {

/// A place in the plane of compensation.
using Place = std::array<Coordinate, 2>;

/// The element moved aside, and the arc about its end where that opens a gap.
enum class Kind : std::uint8_t { kParallel, kJoin };
inline constexpr std::size_t kKinds = 2;

/// A raw curve's part that is driven; mm from the start of its element.
struct Stretch {
  bool live = false;
  bool exists = true;  ///< Of a join: the corner opens a gap.
  Vec2 start{0.0F, 0.0F};
  Vec2 end{0.0F, 0.0F};
};

/// A programmed element and what becomes of it.
struct HeldElement {
  Place end{};  ///< It begins where the one before ends.
  float bulge = 0.0F;
  float feed_mm_s = 0.0F;
  motion::BeamCommand beam{};
  path::Tolerance tolerance{};
  motion::SourceLine line{};
  motion::OutputChanges outputs{};
  bool continues = false;
  std::array<Stretch, kKinds> stretches{};
};

/// The last elements of a path, and the curve at an offset from them: raw curves in a row, each
/// driven from where it leaves the one before. Where two do not join they are cut at the first
/// place at which they meet and that is nowhere nearer to the path than the offset; what lies
/// between is swallowed, as long as it is within four offsets of there. The first element of all
/// is the entry, of which nothing is to be kept.
///
/// A bounded part of a path is known, and all holds within that part. Single precision, places
/// counted from the element that is asked for: right to 5e-5 mm where elements are up to
/// 0.3 m long.
class OffsetChain {
 public:
  /// A stop before 16 elements ahead are known would be none of a look-ahead.
  static constexpr std::size_t kLookAhead = 16;
  /// What is given out stays known for some elements.
  static constexpr std::size_t kCapacity = kLookAhead + 3;

  /// @param distance_mm signed, positive is the right of the path; not 0
  void begin(const Place& start, float distance_mm);

  /// Appends an element; the oldest one goes where there is no room. @pre its chord is longer
  /// than kTouch, and the oldest has been given out if there are kCapacity
  [[nodiscard]] std::optional<Fault> append(const HeldElement& added);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Of the elements appended, how many have been forgotten.
  [[nodiscard]] std::uint32_t forgotten() const { return forgotten_; }
  [[nodiscard]] HeldElement& at(std::size_t index) {
    return elements_[(first_ + index) % kCapacity];
  }
  [[nodiscard]] const HeldElement& at(std::size_t index) const {
    return elements_[(first_ + index) % kCapacity];
  }
  [[nodiscard]] const Place& start_of(std::size_t index) const {
    return index == 0 ? start_ : at(index - 1).end;
  }
  [[nodiscard]] const Place& end() const { return start_of(size_); }
  [[nodiscard]] bool is_entry(std::size_t index) const { return forgotten_ + index == 0; }
  [[nodiscard]] float distance() const { return distance_; }

  /// What is driven of a raw curve, as seen from the start of its element. @pre it is live
  [[nodiscard]] Curve driven(std::size_t index, Kind kind) const;
  /// Whether an element's part of the path is settled, and is nowhere too near to any element
  /// that is known. @param last nothing follows the last element
  [[nodiscard]] std::optional<Fault> check(std::size_t index, bool last) const;
  /// The same of a straight line from the end of the last element's part to a place.
  [[nodiscard]] std::optional<Fault> check_exit(const Place& to) const;
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
    return at(name.element).stretches[static_cast<std::size_t>(name.kind)];
  }
  [[nodiscard]] const Stretch& stretch(Name name) const {
    return at(name.element).stretches[static_cast<std::size_t>(name.kind)];
  }
  [[nodiscard]] static Vec2 from(const Place& origin, const Place& place);
  [[nodiscard]] Curve element(std::size_t index, const Place& origin) const;
  [[nodiscard]] bool has_raw(Name name) const;
  [[nodiscard]] Curve raw(Name name, const Place& origin) const;
  [[nodiscard]] bool is_clear(const Vec2& place, const Place& origin) const;
  [[nodiscard]] std::optional<Fault> add_raw(Name name, bool joins);
  [[nodiscard]] std::optional<Fault> attach(Name name);
  [[nodiscard]] std::optional<Vec2> first_meeting(Name before, Name after) const;
  [[nodiscard]] std::optional<Fault> link(Name before, Name after, const Vec2& place);
  [[nodiscard]] bool is_beside(const Vec2& cut, const Place& origin, std::size_t index) const;
  [[nodiscard]] bool could_be_cut(const Vec2& lost, const Vec2& cut, const Place& origin) const;
  [[nodiscard]] std::optional<std::size_t> too_near(const Curve& way,
                                                    const Place& origin,
                                                    std::size_t own) const;
  [[nodiscard]] std::optional<std::size_t> too_near_aslant(const Curve& way,
                                                           const Place& origin,
                                                           std::size_t touched,
                                                           const Vec2& corner) const;

  std::array<HeldElement, kCapacity> elements_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  std::size_t settled_ = 0;
  std::uint32_t forgotten_ = 0;
  Place start_{};
  float distance_ = 0.0F;
};

}  // namespace cnc::compensation
