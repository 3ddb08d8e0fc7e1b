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

/// On which side of a drawn line the beam goes.
enum class Side : std::uint8_t {
  kWaste,  ///< Half a kerf beside it, so that the part has the drawn size.
  kOn,     ///< On the line itself, through the sheet; open lines, too.
  kMark,   ///< On the line, which is engraved: nothing is cut through.
  kFill,   ///< In lines across the area of its closed contours, which is engraved.
  kImage,  ///< In rows of pixels: its pictures are engraved, its contours nothing.
  kSkip,   ///< Nowhere.
  kStart,  ///< Nowhere: what is drawn marks where the nearest contour is begun.
};

/// Returns whether nothing is cut through, so that no kerf is needed.
[[nodiscard]] constexpr bool is_engraved(Side side) {
  return side == Side::kMark || side == Side::kFill || side == Side::kImage;
}

/// Returns whether the beam goes along lines of this side, or burns pictures, at all.
[[nodiscard]] constexpr bool is_driven(Side side) {
  return side == Side::kWaste || side == Side::kOn || is_engraved(side);
}

/// Where along its path a closed contour may be begun.
enum class StartAt : std::uint8_t {
  kAny,       ///< On straights, rounds and at corners.
  kStraight,  ///< On straights and rounds.
  kCorner,    ///< At corners, where it has any.
  kUsual,     ///< In the middle of its longest stroke with room for the leads, nowhere else.
  kTab,       ///< As kAny, but behind one of its tabs, before which it ends; where it has any.
};

enum class LeadKind : std::uint8_t { kNone, kLine, kArc };

struct Lead {
  LeadKind kind = LeadKind::kNone;
  double length_mm = 0.0;
  bool is_asked = false;  ///< By an option, unlike the lead that a cut has without one.
  bool operator==(const Lead&) const = default;
};

/// The gas that blows at the cut while the beam is on.
enum class Air : std::uint8_t {
  kFlood,  ///< M8.
  kMist,   ///< M7.
  kOff,    ///< M9.
};

/// How the lines of a filled area lie.
enum class FillPattern : std::uint8_t {
  kLines,    ///< Parallel, across the area.
  kContour,  ///< Along its outline.
};

/// How an area is filled with lines. Angle and overscan are those of parallel lines.
struct FillSettings {
  double interval_mm = 0.1;             ///< From line to line.
  double angle_deg = 0.0;               ///< Direction of the lines; 0 is along X.
  std::optional<double> overscan_mm{};  ///< Before and after each line; none: from acceleration.
  FillPattern pattern = FillPattern::kLines;
  bool operator==(const FillSettings&) const = default;
};

/// How the contours of a layer are cut.
struct LayerSettings {
  std::optional<double> power_w{};      ///< Else chosen.
  std::optional<double> feed_mm_min{};  ///< Else chosen.
  Side side = Side::kWaste;
  Lead lead_in{LeadKind::kArc, 2.0};
  Lead lead_out{};
  double overcut_mm = 0.0;
  double tab_mm = 0.5;  ///< What is left standing at a tab.
  unsigned tabs = 0;    ///< Of each part; holes have none.
  double pierce_s = 0.0;
  double corner_loop_mm = 0.0;     ///< Radius of loops past outer corners; 0: none.
  double corner_dwell_s = 0.0;     ///< Dark rest at corners that have no loop; 0: none.
  double corner_angle_deg = 45.0;  ///< What turns by less is no corner.
  double common_line_mm = 0.0;     ///< Cuts that run so near side by side are one; 0: none are.
  /// Waste narrower than the kerf is cut along its middle, at most this far into its edges; 0: not.
  double narrow_mm = 0.0;
  StartAt start = StartAt::kAny;
  std::optional<unsigned> rank{};  ///< Layers of lower rank are cut first; none: no such order.
  std::optional<PowerShare> power_share{};  ///< In place of power_w, until power_in_watts().
  unsigned passes = 1;                      ///< Times that each contour is cut.
  bool passes_by_layer = false;  ///< All contours of the layer once, then once more; else each.
  double z_step_mm = 0.0;        ///< Z goes down by this with each pass after the first.
  Air air = Air::kFlood;
  bool is_scored = false;  ///< A marked line is reported as scored, not as engraved.
  FillSettings fill{};     ///< Used by Side::kFill, and without the angle by Side::kImage.
  ImageSettings image{};   ///< Used by Side::kImage.
  bool operator==(const LayerSettings&) const = default;
};

/// Turns power that is a share into watts. Throws std::invalid_argument for S beyond the greatest.
/// @param full_power_w power at `full_power_s`, above 0
void power_in_watts(LayerSettings& settings, double full_power_w, double full_power_s);

/// Takes `key=value`. Throws std::invalid_argument saying what is wrong, and what there is.
void set(LayerSettings& settings, std::string_view key, std::string_view value);

/// A rule: the settings that a layer, or colour, of a name has of its own. The rule `*` is for all
/// layers that no other one names.
using LayerRule = NamedValues;

/// Returns whether a rule names the layer: by its name, by its colour however that is written, or
/// by the name of a colour, see is_colour_named(). The rule `*` names none.
[[nodiscard]] bool names(const LayerRule& rule, const drawing::Layer& layer);

/// Throws std::invalid_argument with the place, also for keys and values that mean nothing.
[[nodiscard]] LayerRule parse_rule(std::string_view text, std::string place);

/// Rules, one to a line; blank lines and those that begin with `#` do not count. Throws
/// std::invalid_argument as parse_rule() does, and for a file without any.
[[nodiscard]] std::vector<LayerRule> read_rules(const std::string& text, const std::string& file);

/// Returns every rule that names the layer; where none does, the rules `*`.
[[nodiscard]] std::vector<const LayerRule*> rules_for(const drawing::Layer& layer,
                                                      const std::vector<LayerRule>& rules);

/// Returns the common settings with the rules for the layer, later ones last. A layer that is
/// engraved or filled has nothing of the common settings, which are for cuts, and neither leads nor
/// tabs. Throws std::invalid_argument with the place of a rule that gives it some. Pictures are
/// skipped unless a rule says kind=image.
/// @param engraved what a layer that is engraved or filled has in their place
[[nodiscard]] LayerSettings settings_for(const drawing::Layer& layer,
                                         const LayerSettings& common,
                                         const std::vector<LayerRule>& rules,
                                         const LayerSettings& engraved = {});

}  // namespace sim::cut
