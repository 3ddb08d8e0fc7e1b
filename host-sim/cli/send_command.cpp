#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/transfer.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/job/program_digest.hpp"
#include "host-sim/job/program_judge.hpp"
#include "host-sim/job/program_text.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/send/agreed_answers.hpp"
#include "host-sim/send/standpoint_reading.hpp"
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
    "Works with any Grbl controller; --checked and --resume require Kerfline. Before any motion "
    "the\n"
    "settings, offsets and position of the controller are read. A program with a line that the\n"
    "controller would refuse, or that leaves the travel ($130...), is sent only with\n"
    "--accept-faults.\n"
    "An interrupted job that was sent with --numbered or --checked continues with --resume where\n"
    "the beam went off: the controller is reset if it is held, and the path is driven with the "
    "beam\n"
    "off up to that point.\n"
    "Keys at a terminal: ! or blank holds, ~ or r resumes, q or Ctrl-C stops. A stop holds and "
    "then\n"
    "resets at standstill, or resets immediately where a hold has no effect (a tool change, "
    "homing,\n"
    "check mode). The position stays known, except during homing, and all lines are dropped. "
    "Without\n"
    "a terminal the program prints for what the machine waits; SIGINT stops as q does.\n"
    "Exit status: 0 all done and at rest, 1 faults, refused, aborted or cut off, 2 the call is "
    "wrong.";

void add_options(CLI::App& command, SendCommandOptions& options) {
  mark_file(command.add_option("file", options.file, "The program; - reads standard input")
                ->required()
                ->type_name("FILE"),
            FileRole::kInput);
  auto* const links = command.add_option_group("link", "Link to the controller");
  links->add_option("--port", options.port, "Serial port of the controller")->type_name("DEVICE");
  links->add_option("--tcp", options.tcp, "Raw TCP address of the controller")
      ->check(port_address())
      ->type_name("HOST:PORT");
  links->add_option("--can", options.can, "CAN interface of the kernel, such as can0 or vcan0")
      ->type_name("INTERFACE");
  links->add_option("--slcan", options.slcan, "Serial CAN adapter (slcan), at 1 Mbit/s")
      ->type_name("DEVICE");
  links->require_option(1);
  command.add_option("--node", options.node, "Node number of the controller on the CAN bus")
      ->check(in_whole_range(1, cnc::can::kLastNode))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--baud", options.baud, "Baud rate of the serial port; USB ignores it")
      ->check(in_whole_range(1, 10'000'000, "baud"))
      ->type_name("RATE")
      ->capture_default_str();
  command.add_flag(
      "--checked", options.send.checked, "Number and check every line, and repeat damaged lines");
  command
      .add_option(
          "--window",
          options.send.window,
          "Greatest number of sent bytes without an answer; default: as the controller announces")
      ->check(in_whole_range(16, 65'536, "bytes"))
      ->type_name("BYTES");
  command.add_flag("--accept-faults",
                   options.accept_faults,
                   "Send the program although it has faults or leaves the travel");
  command.add_flag("--keep-going",
                   options.send.goes_on_after_errors,
                   "Continue after a line that the controller refuses");
  command.add_flag(
      "--stop-when-held",
      options.stop_when_held,
      "End the job where it would wait for an operator: at M0, M6, a hold, an open door.\n"
      "The controller is reset, and all lines are dropped");
  command.add_flag("--numbered",
                   options.numbered,
                   "Send each line with a number N, so that --resume can continue the job");
  auto* const resume =
      command.add_flag("--resume", options.resume, "Continue the job where it was interrupted");
  command
      .add_option(
          "--from-line", options.from_line, "Number of the line of the file with which to begin")
      ->check(in_whole_range(1, 1'000'000'000))
      ->excludes(resume)
      ->type_name("LINE");
  mark_file(
      command.add_option("--log", options.log, "Write every line of both directions with its time")
          ->type_name("FILE"),
      FileRole::kOutput);
}

/// Checks, before any motion, that no line is too long for the controller. Throws
/// std::invalid_argument otherwise.
void check_lengths(const JobLines& job, const SendCommandOptions& options) {
  const bool numbered = options.numbered || options.resume || options.send.checked;
  const std::size_t most =
      kLongestSentLine - (numbered ? kSentNumber : 0) - (options.send.checked ? kSentCheck : 0);
  const auto line = line_too_long(job, most);
  if (!line) return;
  throw std::invalid_argument(
      fmt::format("{}:{}: longer than {} characters without comments and blanks",
                  options.file,
                  line->number,
                  most));
}

/// Sends lines that are not part of the job, and waits for their answers.
ExitStatus say(const SendCommandOptions& options,
               Line& line,
               const std::vector<JobLine>& words,
               const SendOptions& send,
               const std::function<void(Sender&, std::string_view)>& on_answer = {}) {
  Transfer transfer{options, line, JobPart{.lines = std::make_shared<const JobLines>(words)}, send};
  if (on_answer) {
    transfer.on_answer = [&](std::string_view answer) { on_answer(transfer.sender(), answer); };
  }
  return transfer.run();
}

/// The state of the controller before the job.
struct Answers {
  Standing standing;
  StandpointReading standpoint;

  void read(std::string_view answer) {
    standing.read(answer);
    standpoint.read(answer);
  }
};

std::vector<JobLine> questions_of(const SendCommandOptions& options) {
  std::vector<JobLine> questions = StandpointReading::questions();
  if (options.resume) questions.push_back({.text = "$RESUME"});
  return questions;
}

/// Sends the queries once and uses their answers, for a link without checks.
ExitStatus ask_once(const SendCommandOptions& options, Line& line, Answers& answers) {
  const SendOptions send{.takes_up = options.resume, .rests_in_alarm = true};
  return say(options,
             line,
             questions_of(options),
             send,
             [&answers](Sender& sender, std::string_view answer) {
               answers.read(answer);
               if (answer.starts_with("[KERFLINE:")) sender.ask_full_report();
             });
}

/// Repeats the queries until all answers agree, because answers, unlike queries, have no check.
ExitStatus ask_until_agreed(const SendCommandOptions& options, Line& line, Answers& answers) {
  constexpr int kMaxRounds = 12;
  AgreedAnswers agreed{options.resume};
  const SendOptions send{.checked = true, .takes_up = options.resume, .rests_in_alarm = true};
  const auto count = [&agreed](Sender& sender, std::string_view answer) {
    // Before kBeginning, the sender may still reset a held job. The reset changes the controller's
    // state, so earlier answers do not count.
    if (sender.state() < Sender::State::kBeginning) return;
    agreed.read(answer);
    if (answer.starts_with("[GC:")) sender.ask_full_report();
  };
  for (int round = 0; round < kMaxRounds; ++round) {
    const ExitStatus said = say(options, line, questions_of(options), send, count);
    if (said != ExitStatus::kFine) return said;
    agreed.end_round();
    if (!agreed.open().empty()) continue;
    for (const std::string& answer : agreed.lines()) answers.read(answer);
    return ExitStatus::kFine;
  }
  terminal::print(
      stderr,
      "{}: nothing was sent: the controller's answers to {} differ each time; the link damages too "
      "many bytes, so try a shorter cable or a lower --baud\n",
      options.file,
      fmt::to_string(fmt::join(agreed.open(), " ")));
  return ExitStatus::kFaults;
}

ExitStatus ask(const SendCommandOptions& options, Line& line, Answers& answers) {
  return options.send.checked ? ask_until_agreed(options, line, answers)
                              : ask_once(options, line, answers);
}

std::size_t index_of(const JobLines& job, const SendCommandOptions& options) {
  for (std::size_t index = 0; index < job.size(); ++index) {
    if (job.number_of(index) >= options.from_line) return index;
  }
  throw std::invalid_argument(fmt::format(
      "{}: line {} does not exist; choose another --from-line", options.file, options.from_line));
}

/// Chooses numbers for the checked lines of an approach. The controller must not take them for
/// lines of the job that are still to be driven.
void number_approach(std::vector<JobLine>& lines, SendOptions& send) {
  // Numbers that are kept free for an approach, which has about ten lines.
  constexpr std::uint32_t kFreeNumbers = 100;
  if (send.takes_up) {
    // Each line of the approach has the number 1. A greater number could be that of the line in
    // which the beam comes on again.
    send.max_number = 1;
  } else {
    // If the approach is interrupted, the controller reports the first line's number, which no job
    // has.
    lines.front().n = send.max_number - kFreeNumbers;
  }
}

/// Drives the machine to the position at which the first line of the job begins.
ExitStatus begin_within(const SendCommandOptions& options,
                        Line& line,
                        const Standing& standing,
                        JobPart& job) {
  Approach approach = lines_before(*job.lines, job.first, standing, options.resume);
  job.motion = std::move(approach.motion);
  SendOptions send{.checked = options.send.checked,
                   .takes_up = options.resume,
                   .rests_in_alarm = options.resume};
  if (send.checked) number_approach(approach.lines, send);
  const ExitStatus said = say(options, line, approach.lines, send);
  terminal::print("{}: begins with line {}\n", options.file, job.lines->number_of(job.first));
  return said;
}

void print_notes(const SendCommandOptions& options, const std::vector<LineNote>& notes) {
  for (const LineNote& note : notes) {
    terminal::print(stderr, "{}\n", place_and_text(options.file, note));
  }
}

ExitStatus refuse(const SendCommandOptions& options, std::string_view remedy) {
  terminal::print(stderr, "{}: nothing was sent{}\n", options.file, remedy);
  return ExitStatus::kFaults;
}

void warn_of_stale_inputs(const SendCommandOptions& options,
                          std::string_view program,
                          const Standpoint& standpoint) {
  for (const std::string& text :
       stale_inputs(program, folder_of(options.file), DigestFiles::kAny, &standpoint.settings)) {
    terminal::print(stderr, "{}: warning: {}\n", options.file, text);
  }
}

/// Checks the program in the same way as the browser page does: prints lines that the controller
/// would refuse, or that leave the travel.
ExitStatus judge(const SendCommandOptions& options,
                 const ProgramText& program,
                 const Standpoint& standpoint) {
  const Judgement judgement = judge_program(options.file, program.text, standpoint);
  if (judgement.fine()) return ExitStatus::kFine;
  for (const Fault& fault : judgement.faults) terminal::print(stderr, "{}\n", to_string(fault));
  if (judgement.more > 0) {
    terminal::print(stderr, "{}: {}\n", options.file, judgement.texts().back());
  }
  if (options.accept_faults) return ExitStatus::kFine;
  return refuse(options,
                ": correct these lines, or send the program nevertheless with --accept-faults");
}

/// Returns whether a job has only lines that a controller in alarm accepts, such as `$X` or
/// settings.
bool has_statements_only(const JobPart& job) {
  for (std::size_t i = 0; i < job.size(); ++i) {
    if (!job[i].text.starts_with('$')) return false;
  }
  return true;
}

ExitStatus send_job(const SendCommandOptions& options, Line& line, std::string file) {
  Answers answers;
  if (const ExitStatus asked = ask(options, line, answers); asked != ExitStatus::kFine) {
    return asked;
  }
  const Standpoint standpoint = answers.standpoint.standpoint();
  const ProgramText program = prepare_program(std::move(file), standpoint.block_delete());
  print_notes(options, program.notes);
  const bool numbered = options.numbered || options.resume || options.send.checked;
  JobPart job{.lines = std::make_shared<const JobLines>(read_job(program.text, numbered))};
  if (job.empty()) throw std::invalid_argument(options.file + ": has no line to send");
  warn_of_stale_inputs(options, program.text, standpoint);
  if (options.resume) job.first = interrupted_at(*job.lines, answers.standing);
  if (options.from_line != 0) job.first = index_of(*job.lines, options);
  if (const ExitStatus judged = judge(options, program, standpoint); judged != ExitStatus::kFine) {
    return judged;
  }
  if (!options.begins_at_start()) {
    const ExitStatus begun = begin_within(options, line, answers.standing, job);
    if (begun != ExitStatus::kFine) return begun;
  }
  SendOptions send = options.send;
  send.rests_in_alarm = has_statements_only(job);
  if (answers.standing.in_alarm && options.begins_at_start() && !send.rests_in_alarm) {
    return refuse(options, ": the controller is in alarm: home or unlock it first");
  }
  Transfer transfer{options, line, std::move(job), send};
  const ExitStatus status = transfer.run();
  transfer.tell();
  return status;
}

/// Makes all checks that do not require the controller, then opens the port and sends the job.
ExitStatus send(const SendCommandOptions& options) {
  std::string file = read_text(options.file);
  {
    const ProgramText program = prepare_program(file);
    if (!program.faults.empty()) {
      print_notes(options, program.notes);
      print_notes(options, program.faults);
      return refuse(options, "");
    }
    const JobLines job = read_job(program.text);
    check_lengths(job, options);
    if (job.empty()) throw std::invalid_argument(options.file + ": has no line to send");
    if (options.from_line != 0) static_cast<void>(index_of(job, options));
  }
  Line line{options};
  const ExitStatus status = send_job(options, line, std::move(file));
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
