#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/base/result.hpp"
#include "planner/contour/contour.hpp"
#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

enum class OffsetFault : std::uint8_t {
  kNotANumber,       ///< A coordinate, a bulge or the distance is no finite number.
  kTooManyElements,  ///< "contour has 513 elements, capacity 512".
  kTooManyMeetings,  ///< Moved elements cross more often than the working storage holds.
  kResultTooLong,    ///< The result's own storage is full.
  kNotClosed,        ///< What is left does not lead back to its start: never seen in tests.
};

struct OffsetError {
  OffsetFault fault{};
  std::size_t elements = 0;  ///< With kTooManyElements: how many there are.
  std::size_t capacity = 0;  ///< Of the storage that is full.
};

/// The curve at a signed distance from closed contours, as lines and arcs: all
/// places that are exactly |distance| from the input, on the right of it where
/// the distance is positive. Material is on the left, so that a positive
/// distance lets outlines grow and holes shrink. Loops are offset together;
/// they split, merge or vanish as they must. Corners become arcs (G1).
///
/// Guarantee: every place of the result is at |distance| from the input within
/// 128 `Tolerance::touch` (3e-8 mm in double for coordinates up to 1 m), and
/// loops touch, but do not cross. Gaps of just twice the distance are closed.
/// Zero-length elements count for nothing, nor does a way out and back along the
/// same line, which encloses no material. Loops must not cross each other.
///
/// Source: paper 1, section 4.2 and equation 3, with all loops removed on arcs.
/// Time: n log n for n elements of which each meets few others. No heap; the
/// view is into `out`, which may not share storage with `input`.
template <typename Scalar>
[[nodiscard]] Result<ContourView<Scalar>, OffsetError> offset(const ContourView<Scalar>& input,
                                                              Scalar distance,
                                                              const OffsetSpace<Scalar>& space,
                                                              ContourWriter<Scalar>& out);

}  // namespace cnc::contour
