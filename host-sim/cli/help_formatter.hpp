#pragma once

#include <memory>

namespace CLI {
class FormatterBase;
}

namespace sim {

/// Returns a formatter of `--help`. It prints the examples in a command's footer directly after the
/// command's description.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter();

}  // namespace sim
