#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "host-sim/import/dxf_group.hpp"
#include "host-sim/text/font.hpp"

namespace sim::drawing {

/// Returns the millimetres per unit of a value of $INSUNITS; nothing if the value names no unit.
[[nodiscard]] std::optional<double> millimetres_per_dxf_unit(int unit);

/// Returns a name in one case for all its spellings: DXF ignores case in names.
[[nodiscard]] std::string dxf_key(std::string_view name);

/// The header of a drawing.
struct DxfHeader {
  std::optional<double> mm_per_unit{};  ///< Unit by $INSUNITS.
  bool is_english = false;              ///< $MEASUREMENT is 0: the drawing uses English units.

  /// Reads one group of a header variable.
  void take(std::string_view variable, const DxfGroup& group);
};

/// A record of the table of layers.
struct DxfLayer {
  std::string name{};  ///< Name as the table spells it.
  std::string colour{"ACI 7"};
  std::string line_type{};
  std::string hidden{};  ///< `off`, `frozen` or `not plotted`; empty if the layer is visible.
  [[nodiscard]] bool is_frozen() const { return hidden == "frozen"; }
};

/// A record of the table of styles of letters.
struct DxfStyle {
  std::string file{};  ///< Name of the style's font file; empty if it has none.
  text::FontWish font{};
  double height = 0.0;       ///< Height of letters that have none of their own.
  double width = 1.0;        ///< Factor of the width.
  double oblique_deg = 0.0;  ///< Lean of the letters to the right.
  int flags = 0;             ///< Sum of 2 (backwards) and 4 (upside down).
};

/// Layers, line types and styles of letters.
class DxfTables {
 public:
  void add_layer(const DxfEntity& record);
  void add_line_type(const DxfEntity& record);
  void add_style(const DxfEntity& record);

  /// Returns the layer with a name, or a default layer with that name if the table has none.
  [[nodiscard]] DxfLayer layer(std::string_view name) const;
  /// Returns the style with a name, or a default style.
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
