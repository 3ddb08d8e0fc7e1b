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
  std::vector<Place> corners{};  ///< Corners of the boundary. Two corners define a rectangle.
  Transform to_block{};          ///< Maps the axes of the corners to the axes of the block.
  /// True if the boundary is complete and lies in the plane of the drawing.
  bool is_in_plan = true;
  /// True if the boundary also clips by height, at its front or at its back.
  bool has_depths = false;
};

using DxfClips = std::map<std::string, DxfClip, std::less<>>;

/// Returns the boundaries of a drawing, keyed by the handles of the INSERTs that they clip.
[[nodiscard]] DxfClips dxf_clips(std::string_view text);

/// Returns the region of a block that a boundary leaves visible.
/// @param to_mm maps the axes of the block to mm
/// @param insert name of the INSERT in messages
[[nodiscard]] ClipRegion region_of(const DxfClip& clip,
                                   const Transform& to_mm,
                                   const std::string& insert);

}  // namespace sim::drawing
