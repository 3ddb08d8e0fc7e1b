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

/// Reads `name: value; …`. What is none is skipped, as browsers do.
[[nodiscard]] SvgDeclarations svg_declarations(std::string_view text);

/// What the elements of one selector get.
struct SvgRule {
  SvgSelector selector;
  std::shared_ptr<const SvgDeclarations> declarations;
};

/// Receives what of a style sheet is not read, and at which byte of it.
using SvgSheetReport = std::function<void(std::size_t offset, const std::string& what)>;

/// Reads the rules of a style sheet in their order, those of `@media all` and `screen` included.
/// Rules with a selector that is not known and other at-rules are reported and left out.
[[nodiscard]] std::vector<SvgRule> svg_rules(std::string_view text, const SvgSheetReport& report);

/// Returns the text without blanks at its ends.
[[nodiscard]] std::string_view css_trimmed(std::string_view text);

}  // namespace sim::drawing
