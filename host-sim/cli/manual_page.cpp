#include "host-sim/cli/manual_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace sim {
namespace {

/// Returns roff that prints every character of one line unchanged.
std::string escaped_roff(std::string_view line) {
  std::string roff;
  // A dot or an apostrophe at the start of a line would begin a request.
  if (line.starts_with('.')) roff += "\\&";
  for (const char c : line) {
    switch (c) {
      case '\\':
        roff += "\\e";
        break;
      case '-':
        roff += "\\-";
        break;
      case '\'':
        roff += "\\(aq";
        break;
      case '`':
        roff += "\\(ga";
        break;
      case '^':
        roff += "\\(ha";
        break;
      case '~':
        roff += "\\(ti";
        break;
      default:
        roff += c;
    }
  }
  return roff;
}

/// Returns roff that prints the lines of a text with their breaks and indents; blank lines separate
/// paragraphs.
std::string as_printed(std::string_view text) {
  std::string roff = ".nf\n";
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    roff += line.empty() ? ".PP\n" : escaped_roff(line) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return roff + ".fi\n";
}

/// Returns a text as one paragraph, whose line breaks roff chooses.
std::string paragraph(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return escaped_roff(text) + "\n";
}

std::string parameter_roff(const ParameterText& parameter) {
  std::string names;
  for (const std::string& name : parameter.names) {
    if (!names.empty()) names += ", ";
    names += "\\fB" + escaped_roff(name) + "\\fR";
  }
  return fmt::format(
      ".TP\n{}{}\n{}", names, escaped_roff(parameter.value), paragraph(parameter.description));
}

std::string parameters_roff(const CommandText& command) {
  std::string roff;
  for (const ParameterText& parameter : command.positionals) roff += parameter_roff(parameter);
  for (const ParameterText& parameter : command.options) roff += parameter_roff(parameter);
  return roff;
}

std::string synopsis_of(const CommandText& command) {
  std::string roff = "\\fB" + escaped_roff(command.path) + R"(\fR [\fIOPTIONS\fR])";
  for (const ParameterText& positional : command.positionals) {
    roff += " \\fI" + escaped_roff(positional.names.front()) + "\\fR";
    if (positional.may_repeat) roff += " ...";
  }
  if (!command.subcommands.empty()) roff += " \\fICOMMAND\\fR";
  return roff + "\n";
}

/// Returns the program's purpose from its description: `the controller …` from `Kerfline: the
/// controller …`.
std::string purpose_of(const CommandText& program) {
  const std::string sentence = first_sentence(program.description);
  const std::size_t colon = sentence.find(": ");
  return colon == std::string::npos ? sentence : sentence.substr(colon + 2);
}

}  // namespace

std::string manual_page(std::span<const CommandText> commands, std::string_view version) {
  const CommandText& program = commands.front();
  const std::string name = escaped_roff(program.path);
  std::string title = program.path;
  std::transform(title.begin(), title.end(), title.begin(), [](unsigned char c) {
    return static_cast<char>(std::toupper(c));
  });
  std::string page = fmt::format(".TH {} 1 \"\" \"{} {}\" \"User Commands\"\n",
                                 escaped_roff(title),
                                 name,
                                 escaped_roff(version));
  page += ".ad l\n.nh\n";  // The right margin is ragged, and options are not hyphenated.
  page += fmt::format(".SH NAME\n{} \\- {}", name, paragraph(purpose_of(program)));
  page += ".SH SYNOPSIS\n" + synopsis_of(program);
  page += ".SH DESCRIPTION\n" + paragraph(program.description);
  page += ".SH OPTIONS\n" + parameters_roff(program);
  page += ".SH COMMANDS\n";
  for (const CommandText& command : commands.subspan(1)) {
    page += fmt::format(".SS {}\n", escaped_roff(command.path)) + synopsis_of(command);
    page += ".PP\n" + paragraph(command.description);
    page += parameters_roff(command);
    if (!command.footer.empty()) page += ".PP\n" + as_printed(command.footer);
  }
  return page + ".SH EXAMPLES\n" + as_printed(program.footer);
}

}  // namespace sim
