#pragma once

#include <cstdint>
#include <map>
#include <pugixml.hpp>
#include <string>

#include "host-sim/import/drawing.hpp"

namespace sim::drawing {

/// A layer of a project of LightBurn.
struct LbrnLayer {
  Layer layer;
  bool is_output = true;  ///< False if the project does not send the layer to the laser.
  /// True if the layer is cut more than once, with different settings each time.
  bool has_sub_layers = false;
};

/// Returns the values of a CutSetting of a project or of a library of materials. Leaves out values
/// that are out of range.
[[nodiscard]] OfferedSettings offered_by(const pugi::xml_node& setting);

/// Returns the text of a note that the kerf offset of a setting is not applied.
[[nodiscard]] std::string note_of_kerf_offset(double offset_mm);

/// The content for which the settings of a layer are used.
enum class LbrnUse : std::uint8_t { kLines, kPictures };

/// Returns the layers of a project by their index, from CutSetting and CutSetting_Img. If an index
/// has both, the settings for `use` are returned.
[[nodiscard]] std::map<int, LbrnLayer> lbrn_layers(const pugi::xml_node& project, LbrnUse use);

/// Returns the layer for an index that the project does not describe.
[[nodiscard]] LbrnLayer lbrn_layer_without_settings(int index);

}  // namespace sim::drawing
