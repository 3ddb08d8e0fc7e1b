#include "host-sim/cli/help_formatter.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace sim {
namespace {

/// Text below the options of a command, split into its paragraph of examples and the rest.
struct Footer {
  std::string examples;
  std::string rest;
};

Footer footer_of(const CLI::App& app) {
  const std::string text = app.get_footer();
  const std::size_t begin = text.find("Example");
  const bool begins_line = begin == 0 || (begin != std::string::npos && text[begin - 1] == '\n');
  if (!begins_line) return {"", text};
  const std::size_t blank = text.find("\n\n", begin);
  if (blank == std::string::npos) return {text.substr(begin), text.substr(0, begin)};
  return {text.substr(begin, blank - begin), text.substr(0, begin) + text.substr(blank + 2)};
}

class HelpFormatter final : public CLI::Formatter {
 public:
  std::string make_description(const CLI::App* app) const override {
    const std::string examples = footer_of(*app).examples;
    const std::string description = CLI::Formatter::make_description(app);
    return examples.empty() ? description : description + "\n" + examples + "\n\n";
  }

  std::string make_footer(const CLI::App* app) const override {
    std::string rest = footer_of(*app).rest;
    while (rest.ends_with('\n')) rest.pop_back();
    return rest.empty() ? rest : rest + "\n";
  }
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_formatter() { return std::make_shared<HelpFormatter>(); }

}  // namespace sim
