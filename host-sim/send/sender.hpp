#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/send/answer.hpp"
#include "host-sim/send/job_lines.hpp"
#include "host-sim/send/lines_in_flight.hpp"
#include "host-sim/send/send_queue.hpp"

namespace sim {

struct SendOptions {
  /// Whether lines have a number and a CRC. Otherwise they are plain, as for any Grbl.
  bool checked = false;
  /// Greatest number of bytes in flight. 0 stands for the free space that the controller announces.
  /// With checked lines, 0 stands for the smallest window that keeps a serial line busy, because
  /// all lines after a damaged line are sent again.
  std::size_t window = 0;
  bool goes_on_after_errors = false;
  /// Whether a controller that is held is reset first, so that an interrupted job can be resumed.
  bool takes_up = false;
  /// Whether the lines are sent even if the controller is in alarm. The controller must accept them
  /// in this state: `$` statements, or lines after `$X`.
  bool rests_in_alarm = false;
  /// Greatest number of a checked line. The line after it restarts the numbering.
  std::uint32_t max_number = 9'999'999;
};

/// The sender in a conversation with a Grbl controller, without a port and without a clock. The
/// owner of the port and the clock passes the bytes that arrived and the time in milliseconds since
/// any fixed instant, and takes the bytes to be written.
///
/// Counts the characters of the lines in flight, so that the controller always has some lines
/// waiting. The job is done when all lines are answered and the machine is at rest. If a job ends
/// early for any reason, the controller is reset when the machine is at rest. In a state in which a
/// hold has no effect, it is reset immediately.
class Sender {
 public:
  using Time = std::chrono::milliseconds;
  enum class State : std::uint8_t {
    kMeeting,    ///< Waits for the controller's first report or banner.
    kAsking,     ///< Asks the controller for its free space; the controller must be idle.
    kBeginning,  ///< Switches the controller to checked lines (numbered, with a checksum).
    kSending,
    kWaiting,  ///< Waits until the machine is at rest.
    /// Switches checked lines off while the machine is at rest. As soon as they are off, a damaged
    /// byte may act as a reset.
    kEnding,
    kStopping,  ///< Holds and then resets the controller, so that no line of the job can continue.
    kDone,
    kFailed,  ///< trouble() has the reason.
  };

  Sender(JobPart job, SendOptions options, Time now);
  Sender(const std::vector<JobLine>& job, SendOptions options, Time now);

  void receive(std::string_view bytes, Time now);
  /// Acts on the time that has passed. Call it every few milliseconds.
  void attend(Time now);
  void lose_link(std::string why = "the link is gone") { fail(std::move(why)); }

  /// Returns the realtime bytes for a link that sends them separately from lines. For other links,
  /// output() includes them.
  [[nodiscard]] std::string_view realtime() const { return out_.realtime(); }
  /// Drops `count` bytes of realtime(), which the link has sent.
  void acted(std::size_t count) { out_.drop_realtime(count); }

  /// Returns the next bytes to be written, at most the rest of one line; empty if there are none.
  [[nodiscard]] std::string_view output() { return out_.next(numbering_.active); }
  /// Drops `count` bytes of output(), which were written.
  void wrote(std::size_t count) { out_.wrote(count); }

  // Requests of the operator.
  void hold();
  void resume();
  /// Requests one full report, which only some controllers have.
  void ask_full_report() { out_.put_realtime('\x87'); }
  /// Ends the job: holds the controller, and resets it when the machine is at rest. Resets it
  /// immediately in a state in which a hold has no effect.
  void abort(std::string why = "aborted") { stop(std::move(why)); }

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool over() const { return state_ == State::kDone || state_ == State::kFailed; }
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  [[nodiscard]] const std::string& machine_state() const { return reported_.state; }
  /// Returns the share of the job's lines that were answered, 0…1.
  [[nodiscard]] double progress() const;
  [[nodiscard]] std::size_t answered() const { return lines_.answered(); }
  /// Returns the number of the line of the file that comes next; 0 after the last line.
  [[nodiscard]] std::size_t file_line() const {
    return answered() < job_.size() ? number_in_file(answered()) : 0;
  }
  [[nodiscard]] std::size_t resent() const { return lines_.resent(); }
  [[nodiscard]] std::size_t errors() const { return errors_; }

  /// Function that is called with each line in both directions. Its arguments are `>` for a sent
  /// line or `<` for a received line, and the line.
  std::function<void(char, std::string_view)> on_line;

 private:
  /// Relation between the index of a line in the job and its number as a checked line.
  struct Numbering {
    bool active = false;      ///< Whether checked lines have begun.
    std::size_t begun = 0;    ///< Index of the first checked line.
    std::uint32_t first = 1;  ///< Number of the first checked line.
  };
  /// State of the machine according to its last status report.
  struct Reported {
    std::string state{};
    bool moves = false;                   ///< Whether the feed is not 0.
    std::optional<std::uint32_t> room{};  ///< Free space for lines, bytes.
    Time at{};                            ///< Time at which the report arrived.
    unsigned count = 0;                   ///< Number of reports since the sender's state began.
    /// Number of consecutive reports, up to the last one, that show the machine at rest.
    unsigned idle_count = 0;
  };

  // Functions for lines from the controller, in sender.cpp.
  void take_line(std::string_view line);
  void meet(const Answer& answer);
  void take_status(const Answer& answer);
  void judge_state();
  void take_trouble(const Answer& answer);
  void take_plain(const Answer& answer);
  void take_options();
  void take_checked(const Answer& answer);
  void take_end(const Answer& answer);
  void refused(std::size_t line, const Answer& answer);

  // Functions for lines to the controller, in sender_lines.cpp.
  void ask();
  void begin();
  void send_lines();
  void send_end();
  void go_back(std::size_t line);
  void put(std::string_view line);
  [[nodiscard]] std::string text_of(std::size_t line) const;
  [[nodiscard]] std::uint32_t number_of(std::size_t line) const;
  [[nodiscard]] std::size_t number_in_file(std::size_t line) const {
    return job_.lines->number_of(job_.first + line);
  }
  void answered_until(std::size_t line);
  [[nodiscard]] std::size_t window() const;

  // Functions that act on time, in sender_time.cpp.
  void attend_silence();
  void attend_stop();
  void attend_wishes();
  void attend_losses();
  void repeat_question();
  void end_line_again();

  void enter(State state);
  void stop(std::string why);
  void fail(std::string why);
  [[nodiscard]] bool counts() const;
  [[nodiscard]] Time since(Time then) const { return now_ - then; }

  JobPart job_;
  SendOptions options_;
  State state_ = State::kMeeting;
  Time now_;
  Time entered_;   ///< Time at which the current state began.
  Time asked_;     ///< Time at which the question of the current state was last sent.
  Time polled_;    ///< Time at which a status report was last requested.
  Time moved_;     ///< Time at which a line was last answered or sent again.
  Time heard_;     ///< Time at which bytes were last received.
  Time wished_{};  ///< Time at which a request of the operator was last sent.
  unsigned questions_ = 0;
  std::string trouble_;
  std::string message_;  ///< Text of the last `[MSG:`, which explains the error after it.
  std::string incoming_;
  SendQueue out_;
  LinesInFlight lines_;
  Numbering numbering_;
  std::size_t errors_ = 0;
  std::size_t room_ = 0;  ///< Free space for lines that the controller announced, bytes.
  bool told_options_ = false;
  bool said_reset_ = false;
  unsigned answers_owed_ = 0;  ///< Number of answers to questions that have not arrived yet.
  bool wants_hold_ = false;
  bool wants_resume_ = false;
  Reported reported_;
};

}  // namespace sim
