#pragma once

#include <cstdint>

#include "planner/contour/contour.hpp"
#include "planner/contour/offset_space.hpp"
#include "planner/pocket/area_list.hpp"

namespace cnc::pocket {

/// A loop while it is being assigned to an area. Working storage, one for each loop.
template <typename Scalar>
struct LoopNote {
  Scalar area{};  ///< mm², negative for holes.
  contour::FlatBox<Scalar> box{};
  std::uint32_t first_hole = contour::kNone;  ///< Of an outline: the last hole found in it.
  std::uint32_t next_hole = contour::kNone;   ///< Of a hole: another hole of the same outline.
};

enum class SplitResult : std::uint8_t {
  kDone,
  kFull,     ///< The notes or the list are full.
  kNoOwner,  ///< A hole lies in no outline: the loops cross each other.
};

inline constexpr double kLeastArea = 1.0e-14;      ///< mm².
inline constexpr double kLeastHoleWidth = 1.0e-9;  ///< mm.

/// Splits loops into connected areas and appends these to `out`. A loop that encloses less than
/// `kLeastArea` is left out, and so is a hole narrower than `kLeastHoleWidth` in the mean: it is
/// rounding, such as the offset of a channel that is narrower than the tool by a last digit, and
/// may lie in no outline.
///
/// Guarantee: a hole belongs to the smallest outline around it.
/// Time: loops times elements where there are several outlines and holes; n for one outline.
/// @pre loops may touch and do not cross, as those of an offset
template <typename Scalar>
[[nodiscard]] SplitResult split_areas(const contour::ContourView<Scalar>& contour,
                                      contour::Slice<LoopNote<Scalar>> notes,
                                      AreaList<Scalar>& out);

}  // namespace cnc::pocket
