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
  bool is_output = true;        ///< False where the project does not send it to the laser.
  bool has_sub_layers = false;  ///< It is done more than once, with other settings each time.
};

/// Returns what a CutSetting of a project, or of a library of materials, says; numbers that are
/// out of their range are left out.
[[nodiscard]] OfferedSettings offered_by(const pugi::xml_node& setting);

/// Returns a note that the kerf offset of a setting is left out.
[[nodiscard]] std::string note_of_kerf_offset(double offset_mm);

/// What the settings of a layer are for.
enum class LbrnUse : std::uint8_t { kLines, kPictures };

/// Returns the layers of a project by their index, as CutSetting and CutSetting_Img have them: of
/// an index with both, the settings that are for the use.
[[nodiscard]] std::map<int, LbrnLayer> lbrn_layers(const pugi::xml_node& project, LbrnUse use);

/// Returns the layer of an index that the project does not describe.
[[nodiscard]] LbrnLayer lbrn_layer_without_settings(int index);

}  // namespace sim::drawing
