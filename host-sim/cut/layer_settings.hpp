#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/cut/image_settings.hpp"
#include "host-sim/cut/named_values.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// The position of the beam relative to the drawn lines of a layer.
enum class Side : std::uint8_t {
  kWaste,  ///< Offset from the line by half a kerf, so that the part has the drawn size.
  kOn,     ///< On the line itself, through the sheet. Lines may be open, too.
  kMark,   ///< On the line, which is engraved: the sheet is not cut through.
  /// The beam follows lines across the area of the layer's closed contours, which is engraved.
  kFill,
  /// The beam follows rows of pixels. The pictures of the layer are engraved, but not its contours.
  kImage,
  kSkip,   ///< The beam is not used, because the layer is skipped.
  kStart,  ///< The beam is not used. The shapes of the layer mark starts of the nearest contours.
};

/// Returns whether a side cuts nothing through. It then requires no kerf.
[[nodiscard]] constexpr bool is_engraved(Side side) {
  return side == Side::kMark || side == Side::kFill || side == Side::kImage;
}

/// Returns whether the beam follows contours of this side or burns pictures.
[[nodiscard]] constexpr bool is_driven(Side side) {
  return side == Side::kWaste || side == Side::kOn || is_engraved(side);
}

/// The points of a closed contour at which its cut may begin.
enum class StartAt : std::uint8_t {
  kAny,       ///< Anywhere: on straight lines, on arcs and at corners.
  kStraight,  ///< Only on straight lines and arcs, not at corners.
  kCorner,    ///< Only at corners, if the contour has any.
  kUsual,     ///< Only in the middle of its longest stroke that has free space for the leads.
  /// At the end of a tab; the cut then ends before this tab. Without tabs, the same as kAny.
  kTab,
};

enum class LeadKind : std::uint8_t { kNone, kLine, kArc };

struct Lead {
  LeadKind kind = LeadKind::kNone;
  double length_mm = 0.0;
  /// Whether an option requires this lead; otherwise it is the default lead.
  bool is_asked = false;
  bool operator==(const Lead&) const = default;
};

/// The gas that flows to the cut while the beam is on. Each value has a coolant word of G-code.
enum class Air : std::uint8_t {
  kFlood,  ///< Gas of the flood output, M8.
  kMist,   ///< Gas of the mist output, M7.
  kOff,    ///< No gas, M9.
};

/// The pattern of the lines that fill an area.
enum class FillPattern : std::uint8_t {
  kLines,    ///< Parallel lines across the area.
  kContour,  ///< Lines along the outline of the area.
};

/// Settings for filling an area with lines. Angle and overscan apply only to parallel lines.
struct FillSettings {
  double interval_mm = 0.1;  ///< Distance between adjacent lines.
  double angle_deg = 0.0;    ///< Angle of the lines from the X axis.
  /// Length of the run with the beam off before and after each line. Without a value, it is
  /// computed from the acceleration.
  std::optional<double> overscan_mm{};
  FillPattern pattern = FillPattern::kLines;
  bool operator==(const FillSettings&) const = default;
};

/// Settings by which the contours of a layer are cut or engraved.
struct LayerSettings {
  std::optional<double> power_w{};      ///< Power; without a value it is chosen from the record.
  std::optional<double> feed_mm_min{};  ///< Feed; without a value it is chosen from the record.
  Side side = Side::kWaste;
  Lead lead_in{LeadKind::kArc, 2.0};
  Lead lead_out{};
  double overcut_mm = 0.0;
  /// Width of the material that stays at a tab. The uncut length of the path is one kerf longer.
  double tab_mm = 0.5;
  unsigned tabs = 0;  ///< Number of tabs of each part; holes have no tabs.
  double pierce_s = 0.0;
  double corner_loop_mm = 0.0;  ///< Radius of loops past outer corners; 0: no loops.
  /// Time for which the beam rests with its power off at corners without a loop; 0: no rest.
  double corner_dwell_s = 0.0;
  double corner_angle_deg = 45.0;  ///< Least turn at which a point of the path is a corner.
  /// Greatest gap between two cuts that become one cut; 0: no cuts become one.
  double common_line_mm = 0.0;
  /// Greatest distance by which a cut along the middle of narrow waste may go into the edges of the
  /// waste. Narrow waste is narrower than the kerf. 0: narrow waste is not cut.
  double narrow_mm = 0.0;
  StartAt start = StartAt::kAny;
  /// Rank of the layer. Layers of lower rank are cut first. Without a value, the rank is 0.
  std::optional<unsigned> rank{};
  /// Power as a share. It replaces `power_w` until power_in_watts() is called.
  std::optional<PowerShare> power_share{};
  unsigned passes = 1;  ///< Number of times that each contour of the layer is driven, 1 or more.
  /// Whether each pass goes over all contours of the layer. Otherwise each contour gets all its
  /// passes before the next contour.
  bool passes_by_layer = false;
  double z_step_mm = 0.0;  ///< Distance by which Z moves down with each pass after the first.
  Air air = Air::kFlood;
  bool is_scored = false;  ///< Whether a marked line is reported as scored, not as engraved.
  /// Settings for Side::kFill and, except for the angle, for Side::kImage.
  FillSettings fill{};
  ImageSettings image{};  ///< Settings for Side::kImage.
  bool operator==(const LayerSettings&) const = default;
};

/// Converts powers that are given as shares to watts. Throws std::invalid_argument for an S value
/// above `full_power_s`.
/// @param full_power_w power at `full_power_s`, above 0
void power_in_watts(LayerSettings& settings, double full_power_w, double full_power_s);

/// Sets one setting from its key and value. Throws std::invalid_argument with the reason and the
/// existing keys or values.
void set(LayerSettings& settings, std::string_view key, std::string_view value);

/// A rule: settings for the layers with a certain name or colour. The rule `*` applies to all
/// layers that no other rule names.
using LayerRule = NamedValues;

/// Returns whether a rule names the layer: by the layer's name, by its colour in any notation, or
/// by the name of a colour (see is_colour_named()). The rule `*` names no layer.
[[nodiscard]] bool names(const LayerRule& rule, const drawing::Layer& layer);

/// Reads a rule. Throws std::invalid_argument with the place of the rule for wrong syntax, unknown
/// keys and invalid values.
[[nodiscard]] LayerRule parse_rule(std::string_view text, std::string place);

/// Reads rules, one per line. Blank lines, and lines that begin with `#`, are ignored. Throws
/// std::invalid_argument as parse_rule() does, and for a file without any rule.
[[nodiscard]] std::vector<LayerRule> read_rules(const std::string& text, const std::string& file);

/// Returns all rules that name the layer. If there are none, returns the rules `*`.
[[nodiscard]] std::vector<const LayerRule*> rules_for(const drawing::Layer& layer,
                                                      const std::vector<LayerRule>& rules);

/// Returns the settings of a layer: the common settings, changed by the rules for the layer in
/// their order. The common settings are for cuts. A layer that is engraved or filled has the
/// settings `engraved` instead, and neither leads nor tabs. Throws std::invalid_argument with the
/// place of the rule if a rule gives such a layer leads or tabs. Pictures are skipped unless a rule
/// says kind=image.
/// @param engraved settings that replace the common ones for a layer that is engraved or filled
[[nodiscard]] LayerSettings settings_for(const drawing::Layer& layer,
                                         const LayerSettings& common,
                                         const std::vector<LayerRule>& rules,
                                         const LayerSettings& engraved = {});

}  // namespace sim::cut
