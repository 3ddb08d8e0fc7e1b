#pragma once

#include <cstdint>

#include "planner/base/result.hpp"
#include "planner/contour/offset.hpp"
#include "planner/pocket/clearing_space.hpp"
#include "planner/pocket/passes.hpp"

namespace cnc::pocket {

/// How a pocket is cleared.
template <typename Scalar>
struct ClearingOptions {
  Scalar tool_radius{};    ///< R, mm, positive.
  Scalar corner_radius{};  ///< r of the corners of all passes but those at the wall, 0…R / 3, mm.
  Scalar stepover{};       ///< Greatest distance between passes, mm, above 0; 2 R bounds nothing.
  /// The pocket is where the tool's centre may be, in place of what is to be cleared: the first
  /// pass goes along its contours.
  bool is_locus = false;
};

enum class ClearingFault : std::uint8_t {
  kOptionOutOfRange,  ///< An option is out of its range or not a number.
  kOffset,            ///< See `offset`.
  kTooManyLoops,      ///< The working storage for loops is full.
  kLoopsCross,        ///< A hole lies in no outline.
  kPassesTooLong,     ///< The storage of the passes is full.
};

struct ClearingError {
  ClearingFault fault{};
  contour::OffsetError offset{};
};

/// The passes that clear a pocket of lines and arcs: the dynamic offset of paper 5 made exact for
/// every corner, for arcs, concave walls, necks and islands.
///
/// The first pass is the offset of the wall by R, sharp at convex corners of the pocket. A pass at
/// the distance D from the wall leaves the area at D + R. Each connected part of it has a next
/// pass of its own, at the greatest distance D' at which no point of the part is farther than R + r
/// from the area at D' + r: then a tool along the boundary of that area, grown by r and closed so
/// that all its corners become arcs of radius r, clears the part down to D' + R. Between straight
/// walls with the smallest angle θ the step is R − r + (R + r) sin(θ / 2), with r = 0 paper 5,
/// equation 10.
///
/// Guarantee: of all points within R of the centre locus of the tool none is left that is farther
/// than R + 2e-7 mm from all passes. Each pass lies within the area that its parent encloses.
/// No pass is nearer to the wall than R by more than the error of contour::offset.
/// Returns the number of passes; 0 if the tool does not fit into the pocket.
/// Time: a few offsets for each pass. No heap.
/// @param pocket  closed contours with the pocket on their left, islands running clockwise
template <typename Scalar>
[[nodiscard]] Result<std::uint32_t, ClearingError> clear_pocket(
    const contour::ContourView<Scalar>& pocket,
    const ClearingOptions<Scalar>& options,
    const ClearingSpace<Scalar>& space,
    PassList<Scalar>& passes);

}  // namespace cnc::pocket
