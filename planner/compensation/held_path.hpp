#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/base/coordinate.hpp"
#include "planner/compensation/clearance.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::compensation {

/// Points at most this far apart, in mm, are meant as one point: rounded to three decimals of a
/// millimetre or four of an inch, a point on a slanted line is up to 1.8 µm off the line.
inline constexpr float kSamePoint = 2.0e-3F;

/// A point in the plane of compensation.
using Place = std::array<Coordinate, 2>;

/// kParallel is the element at its offset; kJoin is the arc about its end where the offsets leave a
/// gap.
enum class Kind : std::uint8_t { kParallel, kJoin };
inline constexpr std::size_t kKinds = 2;

/// The driven part of a raw curve, in mm from the start of its element.
struct Stretch {
  bool live = false;
  bool exists = true;  ///< For a join: the corner opens a gap.
  Vec2 start{0.0F, 0.0F};
  Vec2 end{0.0F, 0.0F};
};

/// A programmed element and its offset.
struct HeldElement {
  Position end{};  ///< End position. The element begins at the end of the one before.
  float bulge = 0.0F;
  float feed_mm_s = 0.0F;
  motion::BeamCommand beam{};
  path::Tolerance tolerance{};
  motion::SourceLine line{};
  motion::OutputChanges outputs{};
  bool continues = false;
  /// Only axes outside the plane move: the element has no direction and no offset.
  bool stands = false;
  bool waste = false;  ///< The element is part of a lead: it bounds nothing that is to be kept.
  std::array<Stretch, kKinds> stretches{};
};

/// The last elements of a programmed path, and which of them are edges of the part.
///
/// The first element is the entry and never an edge; neither are rapids. If the path comes back to
/// a point at which an earlier element began, without a rapid between, the elements between form a
/// closed outline. Then up to kLead elements before the outline are its lead-in. Once the path has
/// ended, up to twice as many elements after the outline are its overlap and lead-out. These
/// elements lie in the waste, or bound nothing but the outline. Without a closed outline all
/// elements are edges. The first points of the path stay known when their elements are forgotten,
/// so an outline of any length is recognized when it closes.
class HeldPath {
 public:
  /// Number of elements that must be known ahead of an element before it is given out.
  static constexpr std::size_t kLookAhead = 16;
  /// Number of elements that are known: elements that were given out stay known while a few more
  /// follow.
  static constexpr std::size_t kCapacity = kLookAhead + 3;
  /// Greatest number of elements of a lead; the entry or exit motion comes in addition.
  static constexpr std::uint32_t kLead = 4;

  void begin(const Position& start, Plane plane);
  /// Appends an element. The oldest one is forgotten if the path is full.
  /// @return whether earlier elements have to be offset once more, because some have become waste
  [[nodiscard]] bool append(const HeldElement& added);
  /// Ends the path. @return whether earlier elements have to be offset once more. @pre size() > 0
  [[nodiscard]] bool end_path();

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Number of elements that were appended and have been forgotten.
  [[nodiscard]] std::uint32_t forgotten() const { return forgotten_; }
  [[nodiscard]] bool full() const { return size_ == kCapacity; }
  [[nodiscard]] HeldElement& at(std::size_t index) {
    return elements_[(first_ + index) % kCapacity];
  }
  [[nodiscard]] const HeldElement& at(std::size_t index) const {
    return elements_[(first_ + index) % kCapacity];
  }
  [[nodiscard]] const Position& position(std::size_t index) const {
    return index == 0 ? start_ : at(index - 1).end;
  }
  [[nodiscard]] Place start_of(std::size_t index) const { return place_of(position(index)); }
  [[nodiscard]] Place place_of(const Position& position) const {
    return {position[axes_.first], position[axes_.second]};
  }
  [[nodiscard]] const PlaneAxes& axes() const { return axes_; }

  [[nodiscard]] bool is_entry(std::size_t index) const { return forgotten_ + index == 0; }
  /// Returns whether an element bounds the part.
  [[nodiscard]] bool is_edge(std::size_t index) const {
    const HeldElement& held = at(index);
    return !is_entry(index) && !held.stands && !held.waste && held.feed_mm_s > 0.0F;
  }
  /// Returns how far apart points are that are driven twice, at most kSamePoint, mm.
  [[nodiscard]] float rounding() const { return rounding_; }
  /// Returns whether all of an element lies below a height above the plane.
  [[nodiscard]] bool is_below(std::size_t index, Coordinate height) const {
    return position(index)[axes_.normal] < height && at(index).end[axes_.normal] < height;
  }
  /// Returns the next element that moves in the plane, or the previous one; size() if there is
  /// none.
  [[nodiscard]] std::size_t next(std::size_t index) const;
  [[nodiscard]] std::size_t previous(std::size_t index) const;

  /// Returns the vector from one point to another, mm.
  [[nodiscard]] static Vec2 from(const Place& origin, const Place& place);
  /// Returns an element as a curve relative to a point. @pre the element moves in the plane
  [[nodiscard]] Curve curve(std::size_t index, const Place& origin) const;

 private:
  [[nodiscard]] std::uint32_t newest() const {
    return forgotten_ + static_cast<std::uint32_t>(size_) - 1;
  }
  [[nodiscard]] std::uint32_t start_of_loop() const;
  [[nodiscard]] bool passes(const Place& node) const;
  [[nodiscard]] bool discard(std::uint32_t end);
  void measure_rounding();

  std::array<HeldElement, kCapacity> elements_{};
  std::array<Place, kLead + 1> first_nodes_{};  ///< Start points of the elements 1 to kLead + 1.
  Position start_{};
  PlaneAxes axes_{axes_of(Plane::kXY)};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  std::uint32_t forgotten_ = 0;
  // Numbers of elements, counted from the entry, which is 0.
  std::uint32_t loop_start_ = 0;  ///< First element of the last outline; 0 if none has closed.
  std::uint32_t loop_end_ = 0;    ///< Last element of the last closed outline.
  std::uint32_t rapid_ = 0;       ///< The last rapid; 0 if there has been no rapid.
  float rounding_ = 0.0F;
};

}  // namespace cnc::compensation
