#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "host-sim/import/dxf_group.hpp"
#include "host-sim/text/font.hpp"

namespace sim::drawing {

/// Returns the length, in mm, of the unit that a value of $INSUNITS names; nothing if the value
/// names no unit.
[[nodiscard]] std::optional<double> millimetres_per_dxf_unit(int unit);

/// Returns a name with its ASCII letters in upper case, for comparisons: DXF ignores case in names.
[[nodiscard]] std::string dxf_key(std::string_view name);

/// The header of a drawing.
struct DxfHeader {
  /// Millimetres per unit, by $INSUNITS; nothing if the header gives no unit.
  std::optional<double> mm_per_unit{};
  bool is_english = false;  ///< True if $MEASUREMENT is 0, which means English units.

  /// Reads one group of a header variable.
  void take(std::string_view variable, const DxfGroup& group);
};

/// A record of the table of layers.
struct DxfLayer {
  std::string name{};  ///< Name of the layer, as the table spells it.
  std::string colour{"ACI 7"};
  std::string line_type{};
  /// Reason why the layer is hidden: `off`, `frozen` or `not plotted`; empty if it is visible.
  std::string hidden{};
  [[nodiscard]] bool is_frozen() const { return hidden == "frozen"; }
};

/// A record of the table of text styles.
struct DxfStyle {
  std::string file{};  ///< Name of the font file; empty if the style names none.
  text::FontWish font{};
  double height = 0.0;       ///< Height of texts that give no height, in units of the drawing.
  double width = 1.0;        ///< Factor by which the width of letters is multiplied.
  double oblique_deg = 0.0;  ///< Lean of the letters to the right.
  /// Sum of flags: 2 if letters are mirrored (backwards), 4 if they are upside down.
  int flags = 0;
};

/// Tables of a DXF file: layers, line types and text styles.
class DxfTables {
 public:
  void add_layer(const DxfEntity& record);
  void add_line_type(const DxfEntity& record);
  void add_style(const DxfEntity& record);

  /// Returns the layer with a name, or a default layer with that name if the table has none.
  [[nodiscard]] DxfLayer layer(std::string_view name) const;
  /// Returns the style with a name, or a default style if the table has none.
  [[nodiscard]] DxfStyle style(std::string_view name) const;
  /// Returns whether lines of a line type have gaps or symbols.
  [[nodiscard]] bool is_dashed(std::string_view line_type) const;

 private:
  std::map<std::string, DxfLayer, std::less<>> layers_;
  std::map<std::string, DxfStyle, std::less<>> styles_;
  std::set<std::string, std::less<>> without_gaps_{"", "CONTINUOUS", "BYLAYER", "BYBLOCK"};
};

/// Returns a true colour (group 420) as `#rrggbb`.
[[nodiscard]] std::string dxf_colour(double rgb);

}  // namespace sim::drawing
