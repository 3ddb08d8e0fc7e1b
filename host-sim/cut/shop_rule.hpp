#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host-sim/cut/layer_settings.hpp"

namespace sim::cut {

/// What of a contour a rule compares.
enum class Quantity : std::uint8_t {
  kDiameter,   ///< Of a closed contour; see diameter_of().
  kPerimeter,  ///< The length of any contour.
  kArea,       ///< What a closed contour encloses, holes included.
  kThickness,  ///< Of the sheet.
};

enum class Relation : std::uint8_t { kLess, kAtMost, kGreater, kAtLeast };

/// `diameter < 2 thickness`: a quantity and a bound.
struct Comparison {
  Quantity quantity = Quantity::kDiameter;
  Relation relation = Relation::kLess;
  double bound = 0.0;         ///< mm or mm², or a multiple of the thickness.
  bool of_thickness = false;  ///< The bound is such a multiple.
};

/// The contours that a rule is for, by their place in the part.
enum class ContourKind : std::uint8_t { kAny, kHole, kOuter, kOpen };

/// What happens to the contours of a rule.
enum class RuleAction : std::uint8_t {
  kChange,  ///< They are cut with other settings.
  kSkip,    ///< They are not cut.
  kMark,    ///< They are engraved on their line.
};

/// A value of a rule: that of a setting, or a share of the layer's.
struct RuleChange {
  std::string key;
  std::string value;
  double percent = 0.0;  ///< Of the layer's power or feed; 0: the value itself.
};

/// One rule of the shop: `hole diameter < thickness: feed=60%, lead-in=line:1`.
struct ShopRule {
  std::string text;   ///< As written, without blanks around it.
  std::string place;  ///< `FILE:LINE` or `--rule`, for messages.
  ContourKind kind = ContourKind::kAny;
  std::vector<Comparison> comparisons{};  ///< All of them hold.
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
/// with the keys of layers. A rule has a kind, a comparison, or both. Throws std::invalid_argument
/// with the place, the column and what is wanted there.
[[nodiscard]] ShopRule parse_shop_rule(std::string_view text, std::string place);

/// Reads rules, one to a line; blank lines and those that begin with `#` do not count. Throws as
/// parse_shop_rule() does, and for a text without any.
[[nodiscard]] std::vector<ShopRule> read_shop_rules(const std::string& text,
                                                    const std::string& file);

}  // namespace sim::cut
