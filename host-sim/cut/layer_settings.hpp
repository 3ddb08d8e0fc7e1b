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

/// The position of the beam relative to a drawn line.
enum class Side : std::uint8_t {
  kWaste,  ///< At an offset of half a kerf from the line, so that the part has the drawn size.
  kOn,     ///< On the line itself, through the sheet; also for open lines.
  kMark,   ///< On the line, which is engraved. Nothing is cut through.
  kFill,   ///< Along lines across the area of the layer's closed contours, which is engraved.
  kImage,  ///< In rows of pixels: the layer's pictures are engraved, its contours are not.
  kSkip,   ///< Nowhere: the layer is skipped.
  kStart,  ///< Nowhere: the layer's shapes mark the start of the nearest contour.
};

/// Returns whether a side cuts nothing through, so that it needs no kerf.
[[nodiscard]] constexpr bool is_engraved(Side side) {
  return side == Side::kMark || side == Side::kFill || side == Side::kImage;
}

/// Returns whether the beam follows lines of this side, or burns pictures.
[[nodiscard]] constexpr bool is_driven(Side side) {
  return side == Side::kWaste || side == Side::kOn || is_engraved(side);
}

/// Where along its path a closed contour may begin.
enum class StartAt : std::uint8_t {
  kAny,       ///< On straight lines, on arcs and at corners.
  kStraight,  ///< On straight lines and arcs.
  kCorner,    ///< At corners, if the contour has any.
  kUsual,     ///< Only in the middle of its longest stroke that has free space for the leads.
  /// If the contour has tabs, at the end of one of them, before which the cut ends; otherwise as
  /// kAny.
  kTab,
};

enum class LeadKind : std::uint8_t { kNone, kLine, kArc };

struct Lead {
  LeadKind kind = LeadKind::kNone;
  double length_mm = 0.0;
  bool is_asked = false;  ///< An option requires the lead; false for the default lead.
  bool operator==(const Lead&) const = default;
};

/// The gas that flows to the cut while the beam is on.
enum class Air : std::uint8_t {
  kFlood,  ///< Flood, M8.
  kMist,   ///< Mist, M7.
  kOff,    ///< Off, M9.
};

/// The pattern of the lines of a filled area.
enum class FillPattern : std::uint8_t {
  kLines,    ///< Parallel lines across the area.
  kContour,  ///< Lines along the outline of the area.
};

/// Settings for filling an area with lines. Angle and overscan apply to parallel lines.
struct FillSettings {
  double interval_mm = 0.1;  ///< Distance from line to line.
  double angle_deg = 0.0;    ///< Direction of the lines; 0 is along X.
  /// Length of the run before and after each line; nothing: computed from the acceleration.
  std::optional<double> overscan_mm{};
  FillPattern pattern = FillPattern::kLines;
  bool operator==(const FillSettings&) const = default;
};

/// Settings for cutting the contours of a layer.
struct LayerSettings {
  std::optional<double> power_w{};      ///< Power; nothing: chosen from the record.
  std::optional<double> feed_mm_min{};  ///< Feed; nothing: chosen from the record.
  Side side = Side::kWaste;
  Lead lead_in{LeadKind::kArc, 2.0};
  Lead lead_out{};
  double overcut_mm = 0.0;
  /// Width of the material that stays at a tab; the uncut path is one kerf longer.
  double tab_mm = 0.5;
  unsigned tabs = 0;  ///< Number of tabs of each part; holes have no tabs.
  double pierce_s = 0.0;
  double corner_loop_mm = 0.0;  ///< Radius of loops past outer corners; 0: none.
  /// Rest with the beam off at corners that have no loop; 0: none.
  double corner_dwell_s = 0.0;
  double corner_angle_deg = 45.0;  ///< Least turn of a corner.
  /// Greatest distance of two neighbouring cuts that become one cut; 0: no cuts do.
  double common_line_mm = 0.0;
  /// Greatest distance by which a cut along the middle of narrow waste may go into the edges of the
  /// waste. Waste is narrow if it is narrower than the kerf. 0: there are no such cuts.
  double narrow_mm = 0.0;
  StartAt start = StartAt::kAny;
  /// Layers of lower rank are cut first; nothing: no order by rank.
  std::optional<unsigned> rank{};
  /// Power as a share, used instead of power_w until power_in_watts() is called.
  std::optional<PowerShare> power_share{};
  unsigned passes = 1;  ///< Number of times that each contour is cut.
  /// Each pass goes over all contours of the layer; otherwise each contour gets all its passes at
  /// once.
  bool passes_by_layer = false;
  double z_step_mm = 0.0;  ///< Distance by which Z moves down with each pass after the first.
  Air air = Air::kFlood;
  bool is_scored = false;  ///< A marked line is reported as scored, not as engraved.
  FillSettings fill{};     ///< Used by Side::kFill, and, except for the angle, by Side::kImage.
  ImageSettings image{};   ///< Used by Side::kImage.
  bool operator==(const LayerSettings&) const = default;
};

/// Converts a power that is given as a share to watts. Throws std::invalid_argument for a value of
/// S above `full_power_s`.
/// @param full_power_w power at `full_power_s`, above 0
void power_in_watts(LayerSettings& settings, double full_power_w, double full_power_s);

/// Sets one setting from `key=value`. Throws std::invalid_argument, which says what is wrong and
/// which keys or values exist.
void set(LayerSettings& settings, std::string_view key, std::string_view value);

/// A rule: the settings of a layer or colour with a certain name. The rule `*` is for all layers
/// that no other rule names.
using LayerRule = NamedValues;

/// Returns whether a rule names the layer: by the layer's name, by its colour in any notation, or
/// by the name of a colour (see is_colour_named()). The rule `*` names no layer.
[[nodiscard]] bool names(const LayerRule& rule, const drawing::Layer& layer);

/// Reads a rule. Throws std::invalid_argument, which names the place, also for unknown keys and
/// invalid values.
[[nodiscard]] LayerRule parse_rule(std::string_view text, std::string place);

/// Reads rules, one per line. Blank lines, and lines that begin with `#`, do not count. Throws
/// std::invalid_argument as parse_rule() does, and for a file without any rule.
[[nodiscard]] std::vector<LayerRule> read_rules(const std::string& text, const std::string& file);

/// Returns every rule that names the layer. If none does, returns the rules `*`.
[[nodiscard]] std::vector<const LayerRule*> rules_for(const drawing::Layer& layer,
                                                      const std::vector<LayerRule>& rules);

/// Returns the common settings with the rules for the layer applied, later rules last. The common
/// settings are for cuts. A layer that is engraved or filled takes nothing from them, and has
/// neither leads nor tabs. Throws std::invalid_argument, which names the place of the rule, if a
/// rule gives such a layer leads or tabs. Pictures are skipped unless a rule says kind=image.
/// @param engraved settings that replace the common ones for a layer that is engraved or filled
[[nodiscard]] LayerSettings settings_for(const drawing::Layer& layer,
                                         const LayerSettings& common,
                                         const std::vector<LayerRule>& rules,
                                         const LayerSettings& engraved = {});

}  // namespace sim::cut
