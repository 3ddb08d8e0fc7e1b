#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/svg_selector.hpp"

namespace sim::drawing {

/// One declaration `name: value` of a rule or of a `style` attribute.
struct SvgDeclaration {
  std::string name;
  std::string value;
  bool is_important = false;
};

using SvgDeclarations = std::vector<SvgDeclaration>;

/// Returns the declarations of a text `name: value; …`. Skips malformed declarations, as browsers
/// do.
[[nodiscard]] SvgDeclarations svg_declarations(std::string_view text);

/// A rule of a style sheet: declarations that apply to the elements which a selector matches.
struct SvgRule {
  SvgSelector selector;
  std::shared_ptr<const SvgDeclarations> declarations;
};

/// Function that is called for each part of a style sheet that is not supported. `offset` is the
/// number of the first byte of this part, and `what` describes the part.
using SvgSheetReport = std::function<void(std::size_t offset, const std::string& what)>;

/// Returns the rules of a style sheet in their order, including those within `@media all` and
/// `@media screen`. Other at-rules, and rules with a selector that is not supported, are reported
/// and left out.
[[nodiscard]] std::vector<SvgRule> svg_rules(std::string_view text, const SvgSheetReport& report);

/// Returns a text without the blanks at both of its ends.
[[nodiscard]] std::string_view css_trimmed(std::string_view text);

}  // namespace sim::drawing
