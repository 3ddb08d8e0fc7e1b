#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/contour/offset_space.hpp"
#include "planner/pocket/area_split.hpp"

namespace cnc::pocket {

/// Capacities that the passes of a pocket require. `elements` and `cuts` are those of OffsetSizes
/// for the offset of the pocket. `loops` is the greatest number of loops of one offset.
struct ClearingSizes {
  std::size_t elements;
  std::size_t cuts;
  std::size_t loops;

  [[nodiscard]] constexpr contour::OffsetSizes offset() const { return {elements, cuts}; }
};

/// Storage for loops that are computed temporarily: `elements` vertices and `loops` loop ends (see
/// ClearingSizes).
template <typename Scalar>
struct LoopSpace {
  contour::Slice<contour::Vertex<Scalar>> vertices;
  contour::Slice<std::uint32_t> loop_ends;

  [[nodiscard]] contour::ContourWriter<Scalar> writer() const { return {vertices, loop_ends}; }
};

/// Storage of an AreaList. The comment of each span names the member of ClearingSizes that gives
/// its size.
template <typename Scalar>
struct AreaSpace {
  contour::Slice<contour::Vertex<Scalar>> vertices;  ///< elements
  contour::Slice<std::uint32_t> loop_ends;           ///< loops
  contour::Slice<AreaRange> ranges;                  ///< loops

  [[nodiscard]] AreaList<Scalar> list() const { return {vertices, loop_ends, ranges}; }
};

/// Working storage of the passes. Its content does not outlive the call.
template <typename Scalar>
struct ClearingSpace {
  contour::OffsetSpace<Scalar> offset;
  LoopSpace<Scalar> loops;  ///< Result of the last offset, which is split into areas.
  LoopSpace<Scalar> inner;  ///< The goal of a trial: the area moved inwards.
  /// The area that a tool along the boundary of the goal clears. While a pass is computed: the goal
  /// grown by twice the corner radius.
  LoopSpace<Scalar> grown;
  AreaSpace<Scalar> left;                  ///< Areas that a pass leaves uncut.
  AreaSpace<Scalar> goals;                 ///< Areas that the next pass surrounds.
  contour::Slice<LoopNote<Scalar>> notes;  ///< loops
};

/// Working storage of the passes, with its capacity in the type.
template <typename Scalar, std::size_t kElements, std::size_t kCuts, std::size_t kLoops>
class BoundedClearingSpace {
 public:
  [[nodiscard]] ClearingSpace<Scalar> space() {
    return {offset_.space(),
            loops_.slices(),
            inner_.slices(),
            grown_.slices(),
            left_.slices(),
            goals_.slices(),
            notes_};
  }

 private:
  struct Loops {
    std::array<contour::Vertex<Scalar>, kElements> vertices{};
    std::array<std::uint32_t, kLoops> loop_ends{};

    [[nodiscard]] LoopSpace<Scalar> slices() { return {vertices, loop_ends}; }
  };
  struct Areas {
    std::array<contour::Vertex<Scalar>, kElements> vertices{};
    std::array<std::uint32_t, kLoops> loop_ends{};
    std::array<AreaRange, kLoops> ranges{};

    [[nodiscard]] AreaSpace<Scalar> slices() { return {vertices, loop_ends, ranges}; }
  };

  contour::BoundedOffsetSpace<Scalar, kElements, kCuts> offset_;
  Loops loops_;
  Loops inner_;
  Loops grown_;
  Areas left_;
  Areas goals_;
  std::array<LoopNote<Scalar>, kLoops> notes_{};
};

}  // namespace cnc::pocket
