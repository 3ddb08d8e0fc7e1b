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
  Scalar tool_radius{};  ///< R, mm, positive.
  /// r, mm, 0…R / 3: corner radius of all passes except those at the wall.
  Scalar corner_radius{};
  /// Greatest distance between passes, mm, above 0; 2 R or more is no limit.
  Scalar stepover{};
  /// True if `pocket` is the area that the tool's centre may be in, instead of the area to be
  /// cleared. Then the first pass runs along its contours.
  bool is_locus = false;
};

enum class ClearingFault : std::uint8_t {
  kOptionOutOfRange,  ///< An option is out of its range or not a number.
  kOffset,            ///< An offset failed: see `ClearingError::offset`.
  kTooManyLoops,      ///< The working storage for loops is full.
  kLoopsCross,        ///< A hole lies in no outline.
  kPassesTooLong,     ///< The storage of the passes is full.
};

struct ClearingError {
  ClearingFault fault{};
  contour::OffsetError offset{};
};

/// Computes the passes that clear a pocket of lines and arcs. They are the dynamic offset of paper
/// 5, made exact for every corner, for arcs, concave walls, necks and islands.
///
/// The first pass is the offset of the wall by R, sharp at convex corners of the pocket. A pass at
/// the distance D from the wall leaves the area at D + R. Each connected part of this area has a
/// next pass of its own. The pass lies at the greatest distance D' at which no point of the part is
/// farther than R + r from the area at D' + r. The pass is the boundary of the area at D' + r,
/// grown by r and closed so that all its corners become arcs of radius r; a tool along it clears
/// the part down to D' + R. Between straight walls with the smallest angle θ the step is R − r + (R
/// + r) sin(θ / 2); with r = 0 this is equation 10 of paper 5.
///
/// Guarantee: of all points within R of the centre locus of the tool, none that is farther than R +
/// 2e-7 mm from all passes is left. Each pass lies within the area that its parent encloses. No
/// pass is nearer to the wall than R by more than the error of contour::offset.
/// Time: a few offsets for each pass. Uses no heap.
/// @param pocket  closed contours with the pocket on their left, islands running clockwise
/// @return the number of passes; 0 if the tool does not fit into the pocket
template <typename Scalar>
[[nodiscard]] Result<std::uint32_t, ClearingError> clear_pocket(
    const contour::ContourView<Scalar>& pocket,
    const ClearingOptions<Scalar>& options,
    const ClearingSpace<Scalar>& space,
    PassList<Scalar>& passes);

}  // namespace cnc::pocket
