#pragma once

#include "planner/pocket/loop_place.hpp"
#include "planner/pocket/tool_path.hpp"

namespace cnc::pocket {

/// One revolution around a loop.
template <typename Scalar>
struct LoopDrive {
  Scalar z_from{};  ///< mm, where it begins.
  Scalar z_to{};    ///< mm, where it ends; z changes in proportion to the length.
  Use use = Use::kPass;
};

/// Returns the length of a loop, mm.
template <typename Scalar>
[[nodiscard]] Scalar loop_length(const contour::ContourView<Scalar>& contour, std::size_t loop);

/// Appends a revolution around a loop from a place on it. Its end, which is the same place, begins
/// the next element and is not appended. False when the storage is full.
template <typename Scalar>
[[nodiscard]] bool drive_loop(const contour::ContourView<Scalar>& contour,
                              const LoopPlace<Scalar>& place,
                              Milling milling,
                              const LoopDrive<Scalar>& drive,
                              ToolPathWriter<Scalar>& out);

}  // namespace cnc::pocket
