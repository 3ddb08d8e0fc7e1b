#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "planner/base/coordinate.hpp"
#include "planner/compensation/clearance.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::compensation {

/// Greatest distance, mm, of points that are meant as one point. A point on a slanted line, rounded
/// to three decimals of a millimetre or four of an inch, is up to 1.8 µm off the line.
inline constexpr float kSamePoint = 2.0e-3F;

/// A point in the plane of compensation.
using Place = std::array<Coordinate, 2>;

/// Kinds of raw curve: kParallel is the element at its offset, and kJoin is the arc about the
/// element's end that fills a gap between two offsets.
enum class Kind : std::uint8_t { kParallel, kJoin };
inline constexpr std::size_t kKinds = 2;

/// The part of a raw curve that the tool drives. `live` is false if there is none. Points are in
/// mm, relative to the start of the element of the raw curve.
struct Stretch {
  bool live = false;
  bool exists = true;  ///< For a join: whether the corner opens a gap.
  Vec2 start{0.0F, 0.0F};
  Vec2 end{0.0F, 0.0F};
};

/// A programmed element and its offset.
struct HeldElement {
  Position end{};  ///< End position. The element begins at the end of the element before it.
  float bulge = 0.0F;
  float feed_mm_s = 0.0F;
  motion::BeamCommand beam{};
  path::Tolerance tolerance{};
  motion::SourceLine line{};
  motion::OutputChanges outputs{};
  bool continues = false;
  /// Whether only axes outside the plane move: the element then has no direction and no offset.
  bool stands = false;
  /// Whether the element is part of a lead, which bounds nothing that is to be kept.
  bool waste = false;
  std::array<Stretch, kKinds> stretches{};
};

/// The last elements of a programmed path, and which of them are edges of the part.
///
/// The first element is the entry. The entry and rapids are never edges. If the path returns to the
/// start of an earlier element without a rapid in between, the elements from there on form a closed
/// outline. Then the elements before the outline are its lead-in, if they are at most kLead. Once
/// the path has ended, the elements after the outline are its overlap and lead-out, if they are at
/// most 2 kLead. Leads and overlaps are no edges: leads are in the waste, and an overlap repeats
/// edges of the outline. All other elements are edges. The first points of the path stay known when
/// their elements are forgotten, so an outline of any length is recognized when it closes.
class HeldPath {
 public:
  /// Number of later elements that must be known before an element is given out.
  static constexpr std::size_t kLookAhead = 16;
  /// Greatest number of stored elements. An element that was given out stays stored while a few
  /// more elements follow.
  static constexpr std::size_t kCapacity = kLookAhead + 3;
  /// Greatest number of elements in a lead, without the entry or exit motion.
  static constexpr std::uint32_t kLead = 4;

  void begin(const Position& start, Plane plane);
  /// Appends an element. If the path is full, the oldest element is forgotten.
  /// @return whether the offsets of earlier elements must be recomputed, because some of these
  ///     elements have become waste
  [[nodiscard]] bool append(const HeldElement& added);
  /// Ends the path. @return whether the offsets of earlier elements must be recomputed. @pre size()
  /// > 0
  [[nodiscard]] bool end_path();

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Returns the number of elements that were appended and have been forgotten.
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
  /// Returns the greatest distance between two programmed points that are meant as one point, mm;
  /// at most kSamePoint.
  [[nodiscard]] float rounding() const { return rounding_; }
  /// Returns whether the complete element is below a height, measured along the normal of the
  /// plane.
  [[nodiscard]] bool is_below(std::size_t index, Coordinate height) const {
    return position(index)[axes_.normal] < height && at(index).end[axes_.normal] < height;
  }
  /// Returns the index of the next element that moves in the plane, or of the previous one; size()
  /// if there is none.
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
  std::uint32_t loop_start_ = 0;  ///< First element of the last closed outline; 0 if there is none.
  std::uint32_t loop_end_ = 0;    ///< Last element of the last closed outline.
  std::uint32_t rapid_ = 0;       ///< Number of the last rapid; 0 if there was no rapid.
  float rounding_ = 0.0F;
};

}  // namespace cnc::compensation
