#pragma once

#include <cstdint>

#include "planner/contour/contour.hpp"
#include "planner/contour/offset_space.hpp"
#include "planner/pocket/area_list.hpp"

namespace cnc::pocket {

/// Notes about a loop while it is being assigned to an area. Working storage; each loop has one.
template <typename Scalar>
struct LoopNote {
  Scalar area{};  ///< mm², negative for holes.
  contour::FlatBox<Scalar> box{};
  std::uint32_t first_hole = contour::kNone;  ///< For an outline: the last hole found in it.
  std::uint32_t next_hole = contour::kNone;   ///< For a hole: another hole of the same outline.
};

enum class SplitResult : std::uint8_t {
  kDone,
  kFull,     ///< The notes or the list are full.
  kNoOwner,  ///< A hole lies in no outline: the loops cross each other.
};

inline constexpr double kMinArea = 1.0e-14;      ///< mm².
inline constexpr double kMinHoleWidth = 1.0e-9;  ///< mm.

/// Splits loops into connected areas and appends them to `out`. Omits a loop that encloses less
/// than `kMinArea`. Omits also a hole whose mean width is less than `kMinHoleWidth`: such a
/// hole is rounding, as in the offset of a channel that is narrower than the tool by a last digit,
/// and it may lie in no outline.
///
/// Guarantee: a hole belongs to the smallest outline around it.
/// Time: number of loops times number of elements with several outlines and holes; proportional to
/// the number of elements with one outline.
/// @pre loops may touch but do not cross, like those of an offset
template <typename Scalar>
[[nodiscard]] SplitResult split_areas(const contour::ContourView<Scalar>& contour,
                                      contour::Slice<LoopNote<Scalar>> notes,
                                      AreaList<Scalar>& out);

}  // namespace cnc::pocket
