#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <stdexcept>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/transfer.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/job/program_text.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/send/take_up.hpp"
#include "host-sim/trace/input_file.hpp"

namespace sim {
namespace {

constexpr const char* kSendFooter =
    "Examples:\n"
    "  kerfline send part.nc --port /dev/ttyACM0\n"
    "  kerfline send part.nc --tcp 127.0.0.1:2323 --checked --log part.log\n"
    "  kerfline send part.nc --can can0 --node 17\n"
    "  kerfline send part.nc --port /dev/ttyACM0 --from-line 120\n"
    "  kerfline send part.nc --port /dev/ttyACM0 --numbered\n"
    "  kerfline send part.nc --port /dev/ttyACM0 --resume\n"
    "  kerfline cut part.dxf ... | kerfline send - --port /dev/ttyUSB0\n"
    "\n"
    "Any Grbl controller; --checked and --resume ask for Kerfline. What was sent --numbered or\n"
    "--checked and was interrupted, by whatever, goes on with --resume where the beam went dark:\n"
    "the controller is reset if it is held, and the path is driven dark up to that place. Keys at "
    "a terminal: ! or blank holds,\n"
    "~ or r resumes, q or Ctrl-C holds and resets: the place stays known. Without a terminal it\n"
    "prints for what the machine waits; SIGINT stops as q does.\n"
    "Exit status: 0 all done and at rest, 1 refused, aborted or cut off, 2 the call is wrong.";

void add_options(CLI::App& command, SendCommandOptions& options) {
  mark_file(command.add_option("file", options.file, "The program; - reads standard input")
                ->required()
                ->type_name("FILE"),
            FileRole::kInput);
  auto* const links = command.add_option_group("link", "Where the controller is");
  links->add_option("--port", options.port, "A serial port")->type_name("DEVICE");
  links->add_option("--tcp", options.tcp, "Raw TCP")->check(port_address())->type_name("HOST:PORT");
  links->add_option("--can", options.can, "A CAN interface of the kernel, can0 or vcan0")
      ->type_name("INTERFACE");
  links->add_option("--slcan", options.slcan, "A CAN adapter of the serial kind, at 1 Mbit/s")
      ->type_name("DEVICE");
  links->require_option(1);
  command.add_option("--node", options.node, "The controller's number on a CAN bus")
      ->check(in_whole_range(1, cnc::can::kLastNode))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--baud", options.baud, "Of the serial port; USB has none")
      ->check(in_whole_range(1, 10'000'000, "baud"))
      ->type_name("RATE")
      ->capture_default_str();
  command.add_flag("--checked",
                   options.send.checked,
                   "Number and check every line, and repeat what was damaged");
  command.add_option("--window", options.send.window, "Bytes on their way at most; else as told")
      ->check(in_whole_range(16, 65'536, "bytes"))
      ->type_name("BYTES");
  command.add_flag(
      "--keep-going", options.send.goes_on_after_errors, "Go on after a line that is refused");
  command.add_flag(
      "--stop-when-held",
      options.stop_when_held,
      "End the job where it would wait for an operator: at M0, M6, a hold, an open door");
  command.add_flag("--numbered", options.numbered, "With N in each line: --resume can go on then");
  auto* const resume =
      command.add_flag("--resume", options.resume, "Go on where the controller was interrupted");
  command.add_option("--from-line", options.from_line, "Begin with this line of the file")
      ->check(in_whole_range(1, 1'000'000'000))
      ->excludes(resume)
      ->type_name("LINE");
  mark_file(
      command.add_option("--log", options.log, "Every line in both directions, with its time")
          ->type_name("FILE"),
      FileRole::kOutput);
}

/// Lines that would never be taken are found before anything moves.
void check_lengths(const std::vector<JobLine>& job, const SendCommandOptions& options) {
  constexpr std::size_t kLongest = 256;
  constexpr std::size_t kNumber = 8;
  constexpr std::size_t kCheck = 9;
  const std::size_t most = kLongest - (options.send.checked                 ? kNumber + kCheck
                                       : options.numbered || options.resume ? kNumber
                                                                            : 0);
  for (const JobLine& line : job) {
    if (line.text.size() <= most) continue;
    throw std::invalid_argument(
        fmt::format("{}:{}: longer than {} characters without comments and blanks",
                    options.file,
                    line.number,
                    most));
  }
}

/// Lines that are sent plain, before those of the job.
ExitStatus say(const SendCommandOptions& options,
               Line& line,
               std::vector<JobLine> words,
               Standing* standing) {
  Transfer transfer{options, line, std::move(words), {.takes_up = options.resume}};
  if (standing != nullptr) {
    transfer.on_answer = [standing](std::string_view answer) { standing->read(answer); };
  }
  return transfer.run();
}

std::size_t index_of(const std::vector<JobLine>& job, const SendCommandOptions& options) {
  const auto found = std::find_if(job.begin(), job.end(), [&](const JobLine& line) {
    return line.number >= options.from_line;
  });
  if (found == job.end()) {
    throw std::invalid_argument(
        fmt::format("{}: has no line {} to begin with", options.file, options.from_line));
  }
  return static_cast<std::size_t>(found - job.begin());
}

/// Brings the machine to the line with which the job begins, and drops the lines before it.
ExitStatus begin_within(const SendCommandOptions& options, Line& line, std::vector<JobLine>& job) {
  Standing standing;
  const ExitStatus asked = say(options, line, standing_questions(options.resume), &standing);
  if (asked != ExitStatus::kFine) return asked;
  const std::size_t index = options.resume ? interrupted_at(job, standing) : index_of(job, options);
  std::vector<JobLine> lines = lines_before(job, index, standing, options.resume);
  const ExitStatus said = say(options, line, std::move(lines), nullptr);
  terminal::print("{}: begins with line {}\n", options.file, job[index].number);
  job.erase(job.begin(), job.begin() + static_cast<std::ptrdiff_t>(index));
  return said;
}

/// What was left out of the file is printed; false where the file must not be sent.
bool tell(const ProgramText& program, const SendCommandOptions& options) {
  for (const LineNote& note : program.notes) {
    terminal::print(stderr, "{}\n", place_and_text(options.file, note));
  }
  for (const LineNote& fault : program.faults) {
    terminal::print(stderr, "{}\n", place_and_text(options.file, fault));
  }
  return program.faults.empty();
}

ExitStatus send(const SendCommandOptions& options) {
  const ProgramText program = prepare_program(read_text(options.file));
  if (!tell(program, options)) {
    terminal::print(stderr, "{}: nothing was sent\n", options.file);
    return ExitStatus::kFaults;
  }
  std::vector<JobLine> job = read_job(program.text);
  check_lengths(job, options);
  if (options.numbered || options.resume || options.send.checked) number_lines(job);
  if (job.empty()) throw std::invalid_argument(options.file + ": has no line to send");
  Line line{options};
  ExitStatus status = ExitStatus::kFine;
  if (!options.begins_at_start()) status = begin_within(options, line, job);
  if (status == ExitStatus::kFine) {
    Transfer transfer{options, line, std::move(job), options.send};
    status = transfer.run();
    transfer.tell();
  }
  const bool is_logged = line.close_log();
  return is_logged || status != ExitStatus::kFine ? status : ExitStatus::kUsage;
}

}  // namespace

void add_send_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command =
      app.add_subcommand("send",
                         "Send a program to a controller over a serial port, TCP or CAN,\n"
                         "and wait until it is done.");
  command->footer(kSendFooter);
  const auto options = std::make_shared<SendCommandOptions>();
  add_options(*command, *options);
  command->callback([options, &status] { status = send(*options); });
}

}  // namespace sim
