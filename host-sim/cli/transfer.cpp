#include "host-sim/cli/transfer.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <system_error>
#include <utility>

#include "host-sim/report/duration_text.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/send/can_port.hpp"

namespace sim {
namespace {

std::unique_ptr<Port> open_port(const SendCommandOptions& options) {
  const auto node = static_cast<std::uint8_t>(options.node);
  if (!options.tcp.empty()) return open_tcp_port(options.tcp);
  if (!options.can.empty()) return open_can_port(options.can, node);
  if (!options.slcan.empty()) return open_slcan_port(options.slcan, options.baud, node);
  return open_serial_port(options.port, options.baud);
}

}  // namespace

Line::Line(const SendCommandOptions& options) {
  if (!options.log.empty()) file.emplace(options.log);
  port = open_port(options);
}

void Line::log(char way, std::string_view words) {
  if (!file) return;
  try {
    fmt::format_to(fmt::appender(file->buffer()),
                   "{:10.3f} {} {}\n",
                   static_cast<double>(now().count()) / 1e3,
                   way,
                   words);
    file->drain();
  } catch (const std::system_error& error) {
    drop_log(error);
  }
}

bool Line::close_log() {
  try {
    if (file) file->close();
  } catch (const std::system_error& error) {
    drop_log(error);
  }
  file.reset();
  return !log_failed;
}

void Line::drop_log(const std::system_error& error) {
  terminal::print(stderr, "kerfline: --log: {}; the job continues without its log\n", error.what());
  log_failed = true;
  file.reset();
}

Transfer::Transfer(const SendCommandOptions& options,
                   Line& line,
                   JobPart job,
                   const SendOptions& send)
    : options_{options},
      line_{line},
      bar_{stderr, is_terminal(stderr), Line::Clock::now()},
      lines_{job.size()},
      sender_{std::move(job), send, line.now()} {
  sender_.on_line = [this](char way, std::string_view words) {
    line_.log(way, words);
    if (way == '<' && on_answer) on_answer(words);
  };
}

ExitStatus Transfer::run() {
  while (!sender_.over()) {
    carry_out();
    sleep();
    carry_in();
    tell_news();
    if (!line_.port->open()) sender_.lose_link(line_.port->trouble());
    sender_.attend(line_.now());
    attend_operator();
    attend_wait();
    show();
  }
  carry_out();
  bar_.clear();
  const bool fine = sender_.state() == Sender::State::kDone;
  if (!fine) {
    terminal::print(stderr, "kerfline: {}: {}\n", options_.file, sender_.trouble());
  }
  return fine ? ExitStatus::kFine : ExitStatus::kFaults;
}

void Transfer::tell() const {
  terminal::print("{}: {} of {} lines in {}, {} sent again, {} refused\n",
                  options_.file,
                  sender_.answered(),
                  lines_,
                  duration_text(static_cast<double>(line_.now().count()) / 1e3),
                  sender_.resent(),
                  sender_.errors());
}

void Transfer::tell_news() {
  Port& port = *line_.port;
  for (std::string news = port.take_news(); !news.empty(); news = port.take_news()) {
    line_.log('*', news);
  }
}

void Transfer::carry_out() {
  sender_.acted(line_.port->act(sender_.realtime()));
  for (;;) {
    const std::string_view bytes = sender_.output();
    if (bytes.empty()) return;
    const std::size_t count = line_.port->write(bytes);
    if (count == 0) return;
    sender_.wrote(count);
  }
}

void Transfer::carry_in() {
  std::array<char, 4096> bytes{};
  for (;;) {
    const std::size_t count = line_.port->read(bytes);
    if (count == 0) return;
    sender_.receive({bytes.data(), count}, line_.now());
  }
}

/// Sleeps until bytes come, but not longer than a serial line takes to become empty.
void Transfer::sleep() {
  constexpr int kPeriodMs = 2;
  waited_.clear();
  line_.port->add_to(waited_);
  ::poll(waited_.data(), waited_.size(), kPeriodMs);
}

void Transfer::attend_operator() {
  if (line_.stop.arrived()) sender_.abort();
  const auto key = keys_.take();
  if (!key) return;
  if (*key == '!' || *key == ' ') sender_.hold();
  if (*key == '~' || *key == 'r') sender_.resume();
  if (*key == 'q') sender_.abort();
}

/// Prints the event for which the machine waits, or ends the job if the call requires that.
void Transfer::attend_wait() {
  if (sender_.state() == Sender::State::kStopping) return;
  const std::string words = wait_.attend(sender_.machine_state(), sender_.file_line(), line_.now());
  if (words.empty()) return;
  if (options_.stop_when_held)
    return sender_.abort("stopped instead of waiting: the machine " + words);
  if (keys_.any()) return;
  bar_.clear();
  terminal::print(stderr, "kerfline: {}: {}\n", options_.file, words);
}

void Transfer::show() {
  const double done = sender_.progress();
  const double seconds = static_cast<double>(line_.now().count()) / 1e3;
  const std::string left = done > 0.0 ? duration_text(seconds * (1.0 - done) / done) : "?";
  bar_.update(
      done,
      fmt::format(
          "{}/{} lines, {} left, {}", sender_.answered(), lines_, left, sender_.machine_state()),
      Line::Clock::now());
}

}  // namespace sim
