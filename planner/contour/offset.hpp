#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/base/result.hpp"
#include "planner/contour/contour.hpp"
#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

enum class OffsetFault : std::uint8_t {
  kNotANumber,  ///< A coordinate, a bulge or the distance is not a finite number.
  /// The contour has more elements than the capacity: "contour has 513 elements, capacity 512".
  kTooManyElements,
  kTooManyMeetings,  ///< Moved elements cross more often than the working storage can hold.
  kResultTooLong,    ///< The storage of the result is full.
  /// The kept curves do not lead back to their start. No test has produced this fault.
  kNotClosed,
};

struct OffsetError {
  OffsetFault fault{};
  std::size_t elements = 0;  ///< Number of elements of the input, for kTooManyElements.
  std::size_t capacity = 0;  ///< Capacity of the storage that is full.
};

/// Computes the curve at a signed distance from closed contours, as lines and arcs. The curve
/// consists of all points that are exactly |distance| from the input, on the right of the input if
/// the distance is positive. Material is on the left, so a positive distance enlarges outlines and
/// shrinks holes. All loops are offset together. They split, merge or vanish as necessary. Corners
/// become arcs (G1).
///
/// Guarantee: every point of the result is at |distance| from the input within 128
/// `Tolerance::touch` (3e-8 mm in double for coordinates up to 1 m). Loops may touch, but do not
/// cross. A gap of exactly twice the distance is closed. Elements of zero length have no effect. A
/// path out and back along the same line has no effect either, because it encloses no material.
/// Loops of the input must not cross each other.
///
/// Source: paper 1, section 4.2 and equation 3, with all loops removed on arcs. Time: n log n for n
/// elements, if each element intersects few others. Uses no heap. The returned view refers to
/// `out`, which may not share storage with `input`.
template <typename Scalar>
[[nodiscard]] Result<ContourView<Scalar>, OffsetError> offset(const ContourView<Scalar>& input,
                                                              Scalar distance,
                                                              const OffsetSpace<Scalar>& space,
                                                              ContourWriter<Scalar>& out);

}  // namespace cnc::contour
