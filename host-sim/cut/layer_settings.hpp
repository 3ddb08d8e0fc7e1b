#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/cut/named_values.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// On which side of a drawn line the beam goes.
enum class Side : std::uint8_t {
  kWaste,  ///< Half a kerf beside it, so that the part has the drawn size.
  kOn,     ///< On the line itself, through the sheet; open lines, too.
  kMark,   ///< On the line, which is engraved: nothing is cut through.
  kSkip,   ///< Nowhere.
  kStart,  ///< Nowhere: what is drawn marks where the nearest contour is begun.
};

/// Returns whether the beam goes along lines of this side at all.
[[nodiscard]] constexpr bool is_driven(Side side) {
  return side == Side::kWaste || side == Side::kOn || side == Side::kMark;
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
  StartAt start = StartAt::kAny;
  std::optional<unsigned> rank{};  ///< Layers of lower rank are cut first; none: no such order.
};

/// Takes `key=value`. Throws std::invalid_argument saying what is wrong, and what there is.
void set(LayerSettings& settings, std::string_view key, std::string_view value);

/// A rule: the settings that a layer, or colour, of a name has of its own.
using LayerRule = NamedValues;

/// Throws std::invalid_argument with the place, also for keys and values that mean nothing.
[[nodiscard]] LayerRule parse_rule(std::string_view text, std::string place);

/// Rules, one to a line; blank lines and those that begin with `#` do not count. Throws
/// std::invalid_argument as parse_rule() does, and for a file without any.
[[nodiscard]] std::vector<LayerRule> read_rules(const std::string& text, const std::string& file);

/// The common settings with every rule that names the layer, later ones last. A layer that is
/// engraved has nothing of the common settings, which are for cuts, and neither leads nor tabs.
/// Throws std::invalid_argument with the place of a rule that gives it some.
[[nodiscard]] LayerSettings settings_for(const drawing::Layer& layer,
                                         const LayerSettings& common,
                                         const std::vector<LayerRule>& rules);

}  // namespace sim::cut
