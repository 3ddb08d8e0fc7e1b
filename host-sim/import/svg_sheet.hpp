#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/svg_selector.hpp"

namespace sim::drawing {

/// One `name: value` of a rule or of a `style` attribute.
struct SvgDeclaration {
  std::string name;
  std::string value;
  bool is_important = false;
};

using SvgDeclarations = std::vector<SvgDeclaration>;

/// Reads declarations `name: value; …`. Skips malformed ones, as browsers do.
[[nodiscard]] SvgDeclarations svg_declarations(std::string_view text);

/// The declarations that apply to the elements of one selector.
struct SvgRule {
  SvgSelector selector;
  std::shared_ptr<const SvgDeclarations> declarations;
};

/// Receives each part of a style sheet that is not read, with the number of its first byte.
using SvgSheetReport = std::function<void(std::size_t offset, const std::string& what)>;

/// Reads the rules of a style sheet in their order, including those of `@media all` and `screen`.
/// Rules with a selector that is not supported, and other at-rules, are reported and left out.
[[nodiscard]] std::vector<SvgRule> svg_rules(std::string_view text, const SvgSheetReport& report);

/// Returns the text without blanks at its ends.
[[nodiscard]] std::string_view css_trimmed(std::string_view text);

}  // namespace sim::drawing
