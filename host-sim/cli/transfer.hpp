#pragma once

#include <poll.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "firmware/link/can/can_identifiers.hpp"
#include "host-sim/cli/commands.hpp"
#include "host-sim/report/progress_bar.hpp"
#include "host-sim/send/keys.hpp"
#include "host-sim/send/port.hpp"
#include "host-sim/send/sender.hpp"
#include "host-sim/send/wait_watch.hpp"
#include "host-sim/serve/server.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {

/// Options of `kerfline send`.
struct SendCommandOptions {
  std::string file;
  std::string port;
  std::string tcp;
  std::string can;
  std::string slcan;
  int node = cnc::can::kUsualNode;
  unsigned baud = 115'200;
  std::string log;
  bool numbered = false;
  bool resume = false;
  bool stop_when_held = false;
  bool accept_faults = false;
  std::size_t from_line = 0;
  SendOptions send{};

  [[nodiscard]] bool begins_at_start() const { return !resume && from_line == 0; }
};

/// The link to the controller, with a log of all its lines. The constructor throws as the open
/// functions of ports do, and std::system_error if the log cannot be written. If a log can no
/// longer be written, as on a full disk, it ends with a message and does not stop the job.
struct Line {
  using Clock = std::chrono::steady_clock;

  explicit Line(const SendCommandOptions& options);
  /// Closes the log, so that it is kept even if the job ended in an exception.
  ~Line() { static_cast<void>(close_log()); }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  [[nodiscard]] Sender::Time now() const {
    return std::chrono::duration_cast<Sender::Time>(Clock::now() - begun);
  }
  void log(char way, std::string_view words);
  /// Moves the log to its final name. Returns false if the log could not be written.
  [[nodiscard]] bool close_log();

  Clock::time_point begun = Clock::now();
  StopSignals stop{};
  std::unique_ptr<Port> port;
  std::optional<OutputFile> file{};
  bool log_failed = false;

 private:
  void drop_log(const std::system_error& error);
};

/// Transfer of one job over a line, with or without a terminal.
class Transfer {
 public:
  Transfer(const SendCommandOptions& options, Line& line, JobPart job, const SendOptions& send);

  /// Called for every line that arrives.
  std::function<void(std::string_view)> on_answer;

  /// Runs until the transfer is over. Prints the reason of a failure immediately.
  ExitStatus run();
  /// Prints the summary of the transfer.
  void tell() const;
  [[nodiscard]] Sender& sender() { return sender_; }

 private:
  void tell_news();
  void carry_out();
  void carry_in();
  void sleep();
  void attend_operator();
  void attend_wait();
  void show();

  const SendCommandOptions& options_;
  Line& line_;
  Keys keys_{};
  WaitWatch wait_{};
  std::vector<pollfd> waited_;
  ProgressBar bar_;
  std::size_t lines_;
  Sender sender_;
};

}  // namespace sim
