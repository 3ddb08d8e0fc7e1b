#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <string>

#include "firmware/protocol/identity.hpp"
#include "host-sim/cli/command_tree.hpp"
#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/completion.hpp"
#include "host-sim/cli/manual_page.hpp"
#include "host-sim/report/terminal.hpp"

namespace sim {
namespace {

constexpr const char* kCompletionFooter =
    "Examples:\n"
    "  source <(kerfline completion bash)\n"
    "  kerfline completion fish > ~/.config/fish/completions/kerfline.fish\n"
    "\n"
    "An installed package has the three scripts where the shells look for them.";

constexpr const char* kManualFooter =
    "Example:\n"
    "  kerfline manual | man -l -";

}  // namespace

void add_completion_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("completion", "Print the script with which a shell completes commands.");
  command->footer(kCompletionFooter);
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "Shell that reads the script")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->callback([&app, shell] {
    using Writer = std::string (*)(std::span<const CommandText>);
    static const std::map<std::string, Writer> kWriters{
        {"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};
    terminal::write_data(kWriters.at(*shell)(command_tree(app)));
  });
}

void add_manual_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("manual", "Print the manual page in the format of man.");
  command->footer(kManualFooter);
  command->callback(
      [&app] { terminal::write_data(manual_page(command_tree(app), cnc::identity::version())); });
}

}  // namespace sim
