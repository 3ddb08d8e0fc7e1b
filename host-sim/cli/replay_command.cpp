#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/job/setting_line.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/serve/replay.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

constexpr const char* kReplayFooter =
    "Examples:\n"
    "  kerfline serve --tcp 2323 --record talk.txt      # and then\n"
    "  kerfline replay talk.txt\n"
    "\n"
    "Exit status: 0 the controller's answers are the same, 1 they differ, 2 the call is wrong.";

struct ReplayOptions {
  std::vector<std::string> files;
  bool with_times = false;
  bool update = false;
};

std::string quoted(const std::string& line) {
  return line.empty() ? std::string{"nothing more"} : fmt::format("`{}`", line);
}

bool replay_one(const std::string& file, const ReplayOptions& options) {
  const Conversation recorded = parse_conversation(read_text(file), file);
  const Conversation said = replay(recorded);
  if (options.update) {
    write_file(file, to_text(said));
    terminal::print("{}: updated\n", file);
    return true;
  }
  const auto difference = first_difference(recorded, said, options.with_times);
  if (!difference) {
    const double seconds = static_cast<double>(recorded.end_ns) * 1.0e-9;
    terminal::print("{}: the same, {:.3f} s\n", file, seconds);
    return true;
  }
  terminal::print("{}:{}: recorded {}, said {}\n",
                  file,
                  difference->line,
                  quoted(difference->expected),
                  quoted(difference->said));
  return false;
}

/// Checks that --update can rewrite the files. For this check they are inputs and outputs.
void refuse_unwritable(const ReplayOptions& options) {
  std::vector<NamedFile> files;
  for (const std::string& file : options.files) {
    if (file == "-") {
      throw std::invalid_argument(
          "--update rewrites its files, and `-` is standard input; write ./- for a file of that "
          "name");
    }
    files.push_back({"FILE", file, FileRole::kKept});
  }
  refuse_shared_files(files);
}

ExitStatus replay_all(const ReplayOptions& options) {
  if (options.update) refuse_unwritable(options);
  bool same = true;
  for (const std::string& file : options.files) same = replay_one(file, options) && same;
  return same ? ExitStatus::kFine : ExitStatus::kFaults;
}

}  // namespace

void add_replay_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command = app.add_subcommand(
      "replay", "Repeat conversations recorded by serve and compare the controller's answers.");
  command->footer(kReplayFooter);
  const auto options = std::make_shared<ReplayOptions>();
  mark_file(
      command->add_option("FILE", options->files, "Conversations recorded by `serve --record`")
          ->required(),
      FileRole::kInput);
  command->add_flag("--times", options->with_times, "Compare the times of answers, too");
  command->add_flag("--update", options->update, "Rewrite the controller's answers in the files");
  command->callback([options, &status] { status = replay_all(*options); });
}

}  // namespace sim
