#pragma once

#include "planner/pocket/loop_place.hpp"
#include "planner/pocket/tool_path.hpp"

namespace cnc::pocket {

/// One revolution around a loop.
template <typename Scalar>
struct LoopDrive {
  Scalar z_from{};  ///< Height at the beginning, mm.
  Scalar z_to{};    ///< Height at the end, mm; z changes in proportion to the length.
  Use use = Use::kPass;
};

/// Returns the length of a loop, mm.
template <typename Scalar>
[[nodiscard]] Scalar loop_length(const contour::ContourView<Scalar>& contour, std::size_t loop);

/// Appends a revolution around a loop from `place`. The end of the revolution, which is also
/// `place`, is not appended, because the next element begins with it. Returns false if the storage
/// is full.
template <typename Scalar>
[[nodiscard]] bool drive_loop(const contour::ContourView<Scalar>& contour,
                              const LoopPlace<Scalar>& place,
                              Milling milling,
                              const LoopDrive<Scalar>& drive,
                              ToolPathWriter<Scalar>& out);

}  // namespace cnc::pocket
