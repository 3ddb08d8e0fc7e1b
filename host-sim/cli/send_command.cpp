#include <fmt/format.h>
#include <poll.h>

#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "host-sim/cli/commands.hpp"
#include "host-sim/job/setting_line.hpp"
#include "host-sim/report/duration_text.hpp"
#include "host-sim/report/progress_bar.hpp"
#include "host-sim/send/can_port.hpp"
#include "host-sim/send/keys.hpp"
#include "host-sim/send/port.hpp"
#include "host-sim/send/sender.hpp"
#include "host-sim/serve/server.hpp"

namespace sim {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kSendFooter =
    "Examples:\n"
    "  kerfline send part.nc --port /dev/ttyACM0\n"
    "  kerfline send part.nc --tcp 127.0.0.1:2323 --checked --log part.log\n"
    "  kerfline send part.nc --can can0 --node 17\n"
    "  kerfline cut part.dxf ... | kerfline send - --port /dev/ttyUSB0\n"
    "\n"
    "Any Grbl controller; --checked asks for Kerfline. Keys at a terminal: ! or blank holds,\n"
    "~ or r resumes, q or Ctrl-C holds and resets: the place stays known.\n"
    "Exit status: 0 all done and at rest, 1 refused, aborted or cut off, 2 the call is wrong.";

struct SendCommandOptions {
  std::string file;
  std::string port;
  std::string tcp;
  std::string can;
  std::string slcan;
  int node = cnc::can::kUsualNode;
  unsigned baud = 115'200;
  std::string log;
  SendOptions send{};
};

void add_options(CLI::App& command, SendCommandOptions& options) {
  command.add_option("file", options.file, "The program; - reads standard input")
      ->required()
      ->type_name("FILE");
  auto* const links = command.add_option_group("link", "Where the controller is");
  links->add_option("--port", options.port, "A serial port")->type_name("DEVICE");
  links->add_option("--tcp", options.tcp, "Raw TCP")->type_name("HOST:PORT");
  links->add_option("--can", options.can, "A CAN interface of the kernel, can0 or vcan0")
      ->type_name("INTERFACE");
  links->add_option("--slcan", options.slcan, "A CAN adapter of the serial kind, at 1 Mbit/s")
      ->type_name("DEVICE");
  links->require_option(1);
  command.add_option("--node", options.node, "The controller's number on a CAN bus")
      ->check(CLI::Range(1, static_cast<int>(cnc::can::kLastNode)))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--baud", options.baud, "Of the serial port; USB has none")
      ->type_name("RATE")
      ->capture_default_str();
  command.add_flag("--checked",
                   options.send.checked,
                   "Number and check every line, and repeat what was damaged");
  command.add_option("--window", options.send.window, "Bytes on their way at most; else as told")
      ->check(CLI::Range(16, 65'536))
      ->type_name("BYTES");
  command.add_flag(
      "--keep-going", options.send.goes_on_after_errors, "Go on after a line that is refused");
  command.add_option("--log", options.log, "Every line in both directions, with its time")
      ->type_name("FILE");
}

/// Lines that would never be taken are found before anything moves.
void check_lengths(const std::vector<JobLine>& job, const SendCommandOptions& options) {
  constexpr std::size_t kLongest = 256;
  constexpr std::size_t kNumberAndCheck = 17;
  const std::size_t most = kLongest - (options.send.checked ? kNumberAndCheck : 0);
  for (const JobLine& line : job) {
    if (line.text.size() <= most) continue;
    throw std::invalid_argument(
        fmt::format("{}:{}: longer than {} characters", options.file, line.number, most));
  }
}

std::unique_ptr<Port> open_port(const SendCommandOptions& options) {
  const auto node = static_cast<std::uint8_t>(options.node);
  if (!options.tcp.empty()) return open_tcp_port(options.tcp);
  if (!options.can.empty()) return open_can_port(options.can, node);
  if (!options.slcan.empty()) return open_slcan_port(options.slcan, options.baud, node);
  return open_serial_port(options.port, options.baud);
}

/// One job over one port, at a terminal or not.
class Transfer {
 public:
  Transfer(const SendCommandOptions& options, std::vector<JobLine> job)
      : options_{options},
        port_{open_port(options)},
        lines_{job.size()},
        sender_{std::move(job), options.send, now()} {
    if (!options.log.empty()) open_log();
  }

  ExitStatus run() {
    while (!sender_.over()) {
      carry_out();
      sleep();
      carry_in();
      tell_news();
      if (!port_->open()) sender_.lose_link(port_->trouble());
      sender_.attend(now());
      attend_operator();
      show();
    }
    carry_out();
    bar_.clear();
    return tell();
  }

 private:
  [[nodiscard]] Sender::Time now() const {
    return std::chrono::duration_cast<Sender::Time>(Clock::now() - begun_);
  }

  void open_log() {
    log_.open(options_.log);
    if (!log_) throw std::invalid_argument(options_.log + ": cannot be written");
    sender_.on_line = [this](char way, std::string_view line) { log(way, line); };
  }

  void log(char way, std::string_view line) {
    log_ << fmt::format("{:10.3f} {} {}\n", static_cast<double>(now().count()) / 1e3, way, line);
  }

  void tell_news() {
    for (std::string news = port_->take_news(); !news.empty(); news = port_->take_news()) {
      if (!options_.log.empty()) log('*', news);
    }
  }

  void carry_out() {
    sender_.acted(port_->act(sender_.realtime()));
    for (;;) {
      const std::string_view bytes = sender_.output();
      if (bytes.empty()) return;
      const std::size_t count = port_->write(bytes);
      if (count == 0) return;
      sender_.wrote(count);
    }
  }

  void carry_in() {
    std::array<char, 4096> bytes{};
    for (;;) {
      const std::size_t count = port_->read(bytes);
      if (count == 0) return;
      sender_.receive({bytes.data(), count}, now());
    }
  }

  /// Until something comes, and not longer than a serial line takes to run dry.
  void sleep() {
    constexpr int kPeriodMs = 2;
    waited_.clear();
    port_->add_to(waited_);
    ::poll(waited_.data(), waited_.size(), kPeriodMs);
  }

  void attend_operator() {
    if (stop_.arrived()) sender_.abort();
    const auto key = keys_.take();
    if (!key) return;
    if (*key == '!' || *key == ' ') sender_.hold();
    if (*key == '~' || *key == 'r') sender_.resume();
    if (*key == 'q') sender_.abort();
  }

  void show() {
    const double done = sender_.progress();
    const double seconds = static_cast<double>(now().count()) / 1e3;
    const std::string left = done > 0.0 ? duration_text(seconds * (1.0 - done) / done) : "?";
    bar_.update(
        done,
        fmt::format(
            "{}/{} lines, {} left, {}", sender_.answered(), lines_, left, sender_.machine_state()),
        Clock::now());
  }

  ExitStatus tell() const {
    const bool fine = sender_.state() == Sender::State::kDone;
    if (!fine) fmt::print(stderr, "kerfline: {}: {}\n", options_.file, sender_.trouble());
    fmt::print("{}: {} of {} lines in {}, {} sent again, {} refused\n",
               options_.file,
               sender_.answered(),
               lines_,
               duration_text(static_cast<double>(now().count()) / 1e3),
               sender_.resent(),
               sender_.errors());
    return fine ? ExitStatus::kFine : ExitStatus::kFaults;
  }

  const SendCommandOptions& options_;
  Clock::time_point begun_ = Clock::now();
  StopSignals stop_;
  Keys keys_{};
  std::unique_ptr<Port> port_;
  std::vector<pollfd> waited_;
  std::ofstream log_;
  ProgressBar bar_{stderr, is_terminal(stderr), begun_};
  std::size_t lines_;
  Sender sender_;
};

ExitStatus send(const SendCommandOptions& options) {
  std::vector<JobLine> job = read_job(read_text(options.file));
  check_lengths(job, options);
  return Transfer{options, std::move(job)}.run();
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
