#pragma once

#include <poll.h>

#include <chrono>
#include <cstddef>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/link/can/can_identifiers.hpp"
#include "host-sim/cli/commands.hpp"
#include "host-sim/report/progress_bar.hpp"
#include "host-sim/send/keys.hpp"
#include "host-sim/send/port.hpp"
#include "host-sim/send/sender.hpp"
#include "host-sim/send/wait_watch.hpp"
#include "host-sim/serve/server.hpp"

namespace sim {

/// What `kerfline send` was called with.
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
  std::size_t from_line = 0;
  SendOptions send{};

  [[nodiscard]] bool begins_at_start() const { return !resume && from_line == 0; }
};

/// The link, and the log of what is said over it. Throws as the open functions of ports do, and
/// std::invalid_argument for a log that cannot be written.
struct Line {
  using Clock = std::chrono::steady_clock;

  explicit Line(const SendCommandOptions& options);

  [[nodiscard]] Sender::Time now() const {
    return std::chrono::duration_cast<Sender::Time>(Clock::now() - begun);
  }
  void log(char way, std::string_view words);

  Clock::time_point begun = Clock::now();
  StopSignals stop{};
  std::unique_ptr<Port> port;
  std::ofstream file{};
};

/// One job over a line, at a terminal or not.
class Transfer {
 public:
  Transfer(const SendCommandOptions& options,
           Line& line,
           std::vector<JobLine> job,
           const SendOptions& send);

  /// Told of every line that comes.
  std::function<void(std::string_view)> on_answer;

  /// Until it is over; what went wrong is told at once.
  ExitStatus run();
  /// The sum of it.
  void tell() const;

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
