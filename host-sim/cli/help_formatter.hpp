#pragma once

#include <memory>

namespace CLI {
class FormatterBase;
}

namespace sim {

/// Returns a formatter of `--help`. It prints the examples of the command, from the text below it,
/// directly after its description.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter();

}  // namespace sim
