#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host-sim/cut/layer_settings.hpp"

namespace sim::cut {

/// A quantity of a contour, or of the sheet, that a rule compares.
enum class Quantity : std::uint8_t {
  kDiameter,   ///< Diameter of a closed contour; see diameter_of().
  kPerimeter,  ///< Length of any contour.
  kArea,       ///< Area that a closed contour encloses, including holes in it.
  kThickness,  ///< Thickness of the sheet.
};

enum class Relation : std::uint8_t { kLess, kAtMost, kGreater, kAtLeast };

/// A comparison of a quantity with a bound, such as `diameter < 2 thickness`.
struct Comparison {
  Quantity quantity = Quantity::kDiameter;
  Relation relation = Relation::kLess;
  double bound = 0.0;         ///< Bound, in mm or mm², or as a multiple of the thickness.
  bool of_thickness = false;  ///< Whether the bound is a multiple of the thickness.
};

/// The contours to which a rule applies, by their role.
enum class ContourKind : std::uint8_t { kAny, kHole, kOuter, kOpen };

/// The treatment that a rule requires for its contours.
enum class RuleAction : std::uint8_t {
  kChange,  ///< The contours are cut with changed settings.
  kSkip,    ///< The contours are not cut.
  kMark,    ///< The contours are engraved on their line instead of being cut.
};

/// A change of one setting in a rule: a new value, or a share of the layer's value.
struct RuleChange {
  std::string key;
  std::string value;
  /// Percentage of the layer's power or feed. 0: the setting becomes `value`.
  double percent = 0.0;
};

/// One rule of the shop, such as `hole diameter < thickness: feed=60%, lead-in=line:1`.
struct ShopRule {
  std::string text;   ///< Text of the rule as the user wrote it, without blanks around it.
  std::string place;  ///< Origin of the rule for messages: `FILE:LINE` or `--rule`.
  ContourKind kind = ContourKind::kAny;
  std::vector<Comparison> comparisons{};  ///< Comparisons that a contour must all satisfy.
  RuleAction action = RuleAction::kChange;
  std::vector<RuleChange> changes{};
};

/// Reads one rule:
///
///     rule       = [kind] [comparison {"and" comparison}] ":" action
///     kind       = "hole" | "outer" | "open"
///     comparison = quantity ("<" | "<=" | ">" | ">=") bound
///     quantity   = "diameter" | "perimeter" | "area" | "thickness"
///     bound      = NUMBER ["mm" | "mm2"] | [NUMBER] "thickness"
///     action     = "skip" | "mark" {"," change} | change {"," change}
///     change     = KEY "=" VALUE | ("feed" | "power") "=" NUMBER "%"
///
/// KEY and VALUE are those of the rules of layers. A rule has a kind, a comparison, or both. Throws
/// std::invalid_argument with the place of the rule, the column, and the text that is required
/// there.
[[nodiscard]] ShopRule parse_shop_rule(std::string_view text, std::string place);

/// Reads rules, one per line. Blank lines, and lines that begin with `#`, are ignored. Throws
/// std::invalid_argument as parse_shop_rule() does, and for a text without any rule.
[[nodiscard]] std::vector<ShopRule> read_shop_rules(const std::string& text,
                                                    const std::string& file);

}  // namespace sim::cut
