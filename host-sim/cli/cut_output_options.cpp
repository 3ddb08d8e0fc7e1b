#include "host-sim/cli/cut_output_options.hpp"

#include <CLI/CLI.hpp>

#include "host-sim/cli/file_options.hpp"

namespace sim {

void add_cut_output_options(CLI::App& command, CutOutputOptions& options) {
  const auto add_file = [&](const char* name, std::string& file, const char* help) {
    mark_file(command.add_option(name, file, help)->type_name("FILE"), FileRole::kOutput);
  };
  add_file("--svg", options.svg, "Draw parts, path, kerf, order and rapids");
  add_file("--png", options.png, "The same picture as PNG");
}

}  // namespace sim
