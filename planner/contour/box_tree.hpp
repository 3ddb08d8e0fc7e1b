#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "planner/contour/curve.hpp"
#include "planner/contour/slice.hpp"

namespace cnc::contour {

/// Hierarchy of boxes over a sequence of curves. Each box of a higher level contains eight
/// consecutive boxes of the level below. Neighbours on a contour are neighbours in the plane, so no
/// sorting is needed. In addition to the boxes that it finds, a search visits O(log n) boxes.
template <typename Scalar>
class BoxTree {
 public:
  static constexpr std::uint32_t kFan = 8;
  /// Number of levels. It suffices for all 32-bit counts, because 8^11 is greater than 2^32.
  // NOLINTNEXTLINE(bugprone-dynamic-static-initializers): constant in each instantiation.
  static constexpr std::uint32_t kLevels = 11;

  /// Returns the number of boxes that `count` curves require.
  [[nodiscard]] static constexpr std::size_t size_for(std::size_t count) {
    return count + count / (kFan - 1) + kLevels + 1;
  }

  /// @pre `boxes` has at least size_for(count) boxes.
  explicit BoxTree(Slice<FlatBox<Scalar>> boxes) : boxes_{boxes} {}

  /// Returns the box of curve `index`. The caller must write this box before it calls build().
  [[nodiscard]] FlatBox<Scalar>& leaf(std::uint32_t index) { return boxes_[index]; }

  void build(std::uint32_t count) {
    first_[0] = 0;
    count_[0] = count;
    top_ = 0;
    while (count_[top_] > kFan && top_ + 1 < kLevels) add_level();
  }

  /// Calls `visit(index)` for each curve with an index of at least `from` whose box overlaps `box`,
  /// in the order of the indices, until a call returns false.
  template <typename Visit>
  void search(const FlatBox<Scalar>& box, std::uint32_t from, Visit&& visit) const {
    search_where([&box](const FlatBox<Scalar>& other) { return other.meets(box); }, from, visit);
  }

  /// Calls `visit(index)` as search() does, for each curve whose boxes on all levels satisfy
  /// `holds(box)`. During the search `holds` may change so that it accepts fewer boxes.
  template <typename Holds, typename Visit>
  void search_where(const Holds& holds, std::uint32_t from, Visit&& visit) const {
    std::uint32_t level = top_;
    std::uint32_t index = from >> (kShift * level);
    while (index < count_[level]) {
      if (holds(boxes_[first_[level] + index])) {
        if (level > 0) {
          --level;
          index = std::max(index * kFan, from >> (kShift * level));
          continue;
        }
        if (!visit(index)) return;
      }
      ++index;
      while (level < top_ && (index % kFan == 0 || index >= count_[level])) {
        index = (index + kFan - 1) / kFan;
        ++level;
      }
    }
  }

  /// Descends on each level into the box for which `measure(box)` is least. Returns the index of a
  /// curve that is near, but not always nearest.
  /// @pre The tree has at least one curve.
  template <typename Measure>
  [[nodiscard]] std::uint32_t descend(const Measure& measure) const {
    std::uint32_t best = 0;
    for (std::uint32_t level = top_;; --level) {
      const std::uint32_t begin = level == top_ ? 0 : best * kFan;
      const std::uint32_t end = level == top_ ? count_[level] : begin + kFan;
      best = begin;
      for (std::uint32_t i = begin + 1; i < std::min(end, count_[level]); ++i) {
        const FlatBox<Scalar>* const row = boxes_.begin() + first_[level];
        if (measure(row[i]) < measure(row[best])) best = i;
      }
      if (level == 0) return best;
    }
  }

 private:
  // NOLINTNEXTLINE(bugprone-dynamic-static-initializers): constant in each instantiation.
  static constexpr std::uint32_t kShift = 3;

  void add_level() {
    const std::uint32_t below = first_[top_];
    const std::uint32_t count = count_[top_];
    ++top_;
    first_[top_] = below + count;
    count_[top_] = (count + kFan - 1) / kFan;
    for (std::uint32_t i = 0; i < count_[top_]; ++i) {
      FlatBox<Scalar> box = boxes_[below + i * kFan];
      const std::uint32_t end = std::min(count, (i + 1) * kFan);
      for (std::uint32_t j = i * kFan + 1; j < end; ++j) box.include(boxes_[below + j]);
      boxes_[first_[top_] + i] = box;
    }
  }

  Slice<FlatBox<Scalar>> boxes_;
  std::array<std::uint32_t, kLevels> first_{};
  std::array<std::uint32_t, kLevels> count_{};
  std::uint32_t top_ = 0;
};

}  // namespace cnc::contour
