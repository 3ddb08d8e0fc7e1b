#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/clip_region.hpp"
#include "host-sim/import/place.hpp"

namespace sim::drawing {

/// The boundary by which an INSERT is clipped (XCLIP).
struct DxfClip {
  std::vector<Place> corners{};  ///< Two are those of a rectangle.
  Transform to_block{};          ///< From their axes to those of the block.
  bool is_in_plan = true;        ///< Its plane is that of the drawing, and it is complete.
  bool has_depths = false;       ///< It clips in front or at the back, too.
};

using DxfClips = std::map<std::string, DxfClip, std::less<>>;

/// Returns the boundaries of a drawing by the handles of the INSERTs that they clip.
[[nodiscard]] DxfClips dxf_clips(std::string_view text);

/// Returns what a boundary shows of a block.
/// @param to_mm from the axes of the block
/// @param insert as messages name it
[[nodiscard]] ClipRegion region_of(const DxfClip& clip,
                                   const Transform& to_mm,
                                   const std::string& insert);

}  // namespace sim::drawing
