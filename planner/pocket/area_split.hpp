#pragma once

#include <cstdint>

#include "planner/contour/contour.hpp"
#include "planner/contour/offset_space.hpp"
#include "planner/pocket/area_list.hpp"

namespace cnc::pocket {

/// Data of a loop during its assignment to an area. Working storage; there is one entry for each
/// loop.
template <typename Scalar>
struct LoopNote {
  Scalar area{};  ///< Enclosed area in mm², negative for holes.
  contour::FlatBox<Scalar> box{};
  /// For an outline: index of the hole that was found last in it; kNone without a hole.
  std::uint32_t first_hole = contour::kNone;
  /// For a hole: index of the next hole of the same outline.
  std::uint32_t next_hole = contour::kNone;
};

enum class SplitResult : std::uint8_t {
  kDone,
  kFull,     ///< The capacity of the notes or of the list is exhausted.
  kNoOwner,  ///< A hole is in no outline, because the loops cross each other.
};

/// Least area that a loop must enclose to be kept, mm².
inline constexpr double kMinArea = 1.0e-14;
inline constexpr double kMinHoleWidth = 1.0e-9;  ///< Least mean width of a hole that is kept, mm.

/// Splits loops into connected areas and appends them to `out`. Omits a loop that encloses less
/// than `kMinArea`. Also omits a hole whose mean width is less than `kMinHoleWidth`. Such a hole is
/// an effect of rounding errors: it occurs in the offset of a channel that is hardly narrower than
/// the tool. It may be outside all outlines.
///
/// Guarantee: a hole belongs to the smallest outline around it. Time: proportional to the number of
/// elements if there is one outline; number of loops times number of elements if there are several
/// outlines and holes.
/// @pre loops may touch but do not cross, like the loops of an offset
template <typename Scalar>
[[nodiscard]] SplitResult split_areas(const contour::ContourView<Scalar>& contour,
                                      contour::Slice<LoopNote<Scalar>> notes,
                                      AreaList<Scalar>& out);

}  // namespace cnc::pocket
