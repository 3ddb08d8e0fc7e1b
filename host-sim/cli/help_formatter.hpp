#pragma once

#include <memory>

namespace CLI {
class FormatterBase;
}

namespace sim {

/// Prints `--help` with the examples of the command, from the text below it, before everything else
/// but its description.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter();

}  // namespace sim
