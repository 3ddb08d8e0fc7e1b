#pragma once

#include <cstdint>

#include "planner/base/result.hpp"
#include "planner/contour/offset.hpp"
#include "planner/pocket/clearing_space.hpp"
#include "planner/pocket/passes.hpp"

namespace cnc::pocket {

/// Options for clearing a pocket.
template <typename Scalar>
struct ClearingOptions {
  Scalar tool_radius{};  ///< Tool radius R, mm, positive.
  /// Corner radius r of all passes except the passes at the wall, mm, 0…R / 3.
  Scalar corner_radius{};
  /// Greatest distance between passes, mm, above 0; a value of 2 R or more is no limit.
  Scalar stepover{};
  /// Whether `pocket` is the area in which the tool's centre may be, instead of the area to be
  /// cleared. Then the first pass runs along the contours of `pocket`.
  bool is_locus = false;
};

enum class ClearingFault : std::uint8_t {
  kOptionOutOfRange,  ///< An option is out of its range or not a number.
  kOffset,            ///< An offset failed: see `ClearingError::offset`.
  kTooManyLoops,      ///< The working storage for loops is full.
  kLoopsCross,        ///< A hole is in no outline, because loops cross each other.
  kPassesTooLong,     ///< The storage of the passes is full.
};

struct ClearingError {
  ClearingFault fault{};
  contour::OffsetError offset{};
};

/// Computes the passes that clear a pocket of lines and arcs. They are the dynamic offset of paper
/// 5, made exact for every corner, for arcs, concave walls, necks and islands.
///
/// The first pass is the offset of the wall by R, sharp at convex corners of the pocket. Let A(d)
/// be the part of the pocket that is farther than d from the wall. A pass at the distance D from
/// the wall leaves A(D + R) uncut. Each connected part of A(D + R) has a separate next pass. This
/// pass is at the greatest distance D' at which no point of the part is farther than R + r from
/// A(D' + r). The pass is the boundary of A(D' + r), grown by r and closed so that all its corners
/// become arcs of radius r. A tool along the pass clears the part down to D' + R. Between straight
/// walls with the smallest angle θ the step is R − r + (R + r) sin(θ / 2); with r = 0 this is
/// equation 10 of paper 5.
///
/// Guarantee: every point within R of the centre locus of the tool is within R + 2e-7 mm of a pass.
/// Each pass is in the area that its parent encloses. No pass is nearer to the wall than R by more
/// than the error of contour::offset. Time: a few offsets for each pass. Uses no heap.
/// @param pocket  closed contours with the pocket on their left, islands running clockwise
/// @return the number of passes; 0 if the tool does not fit into the pocket
template <typename Scalar>
[[nodiscard]] Result<std::uint32_t, ClearingError> clear_pocket(
    const contour::ContourView<Scalar>& pocket,
    const ClearingOptions<Scalar>& options,
    const ClearingSpace<Scalar>& space,
    PassList<Scalar>& passes);

}  // namespace cnc::pocket
