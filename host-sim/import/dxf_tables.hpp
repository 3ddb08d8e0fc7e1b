#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "host-sim/import/dxf_group.hpp"
#include "host-sim/text/font.hpp"

namespace sim::drawing {

/// Returns millimetres per unit of $INSUNITS; nothing where it says none.
[[nodiscard]] std::optional<double> millimetres_per_dxf_unit(int unit);

/// Returns a name as all spellings of it have it: DXF does not tell cases apart.
[[nodiscard]] std::string dxf_key(std::string_view name);

/// The header of a drawing.
struct DxfHeader {
  std::optional<double> mm_per_unit{};  ///< By $INSUNITS.
  bool is_english = false;              ///< $MEASUREMENT is 0.

  /// Reads one variable's group.
  void take(std::string_view variable, const DxfGroup& group);
};

/// A record of the table of layers.
struct DxfLayer {
  std::string name{};  ///< As the table spells it.
  std::string colour{"ACI 7"};
  std::string line_type{};
  std::string hidden{};  ///< `off`, `frozen`, `not plotted`; empty where it is seen.
  [[nodiscard]] bool is_frozen() const { return hidden == "frozen"; }
};

/// A record of the table of styles of letters.
struct DxfStyle {
  std::string file{};  ///< The font that it names; empty where it names none.
  text::FontWish font{};
  double height = 0.0;       ///< For letters that have none of their own.
  double width = 1.0;        ///< Factor.
  double oblique_deg = 0.0;  ///< To the right.
  int flags = 0;             ///< 2: backwards, 4: upside down.
};

/// Layers, line types and styles of letters.
class DxfTables {
 public:
  void add_layer(const DxfEntity& record);
  void add_line_type(const DxfEntity& record);
  void add_style(const DxfEntity& record);

  /// Returns the layer of a name, or one of that name that is as usual.
  [[nodiscard]] DxfLayer layer(std::string_view name) const;
  /// Returns the style of a name, or a usual one.
  [[nodiscard]] DxfStyle style(std::string_view name) const;
  /// Returns whether a line of this type has gaps or figures.
  [[nodiscard]] bool is_dashed(std::string_view line_type) const;

 private:
  std::map<std::string, DxfLayer, std::less<>> layers_;
  std::map<std::string, DxfStyle, std::less<>> styles_;
  std::set<std::string, std::less<>> without_gaps_{"", "CONTINUOUS", "BYLAYER", "BYBLOCK"};
};

/// Returns `#rrggbb` of a true colour.
[[nodiscard]] std::string dxf_colour(double rgb);

}  // namespace sim::drawing
