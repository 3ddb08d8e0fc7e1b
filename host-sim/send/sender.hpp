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
  bool checked = false;  ///< Lines have number and CRC; else they are plain, as for any Grbl.
  /// Greatest number of bytes in flight. 0 stands for the free space that the controller announces.
  /// For checked lines, all of which are repeated after a damaged one, 0 stands for the smallest
  /// window that keeps a serial line busy.
  std::size_t window = 0;
  bool goes_on_after_errors = false;
  /// Resets a controller that is held, so that an interrupted job can be resumed.
  bool takes_up = false;
  /// The lines are sent although the controller is in alarm, as it takes them in that state:
  /// questions, other `$` statements, `$X` first.
  bool rests_in_alarm = false;
  std::uint32_t max_number = 9'999'999;  ///< Greatest number; after it the numbers restart.
};

/// The sender's half of the conversation with a Grbl controller, without a port and without a
/// clock. The owner of port and clock hands over the bytes that arrived, takes the bytes to be
/// written, and passes the time in milliseconds since any fixed instant.
///
/// Characters of lines are counted, so that the controller always has some lines waiting. The job
/// is done when all lines are answered and the machine is at rest. If a job ends early for any
/// reason, the controller is reset: when the machine is at rest, or at once in states in which a
/// hold does nothing.
class Sender {
 public:
  using Time = std::chrono::milliseconds;
  enum class State : std::uint8_t {
    kMeeting,    ///< Waits for the controller's first report or banner.
    kAsking,     ///< Asks the controller for its free space; the controller must be idle.
    kBeginning,  ///< Switches the controller to checked lines (numbered, with a checksum).
    kSending,
    kWaiting,  ///< Waits until the machine is at rest.
    /// Switches checked lines off, at rest. From now on, a damaged byte may act as a reset.
    kEnding,
    kStopping,  ///< Holds, then resets, so that nothing of the job is left to continue.
    kDone,
    kFailed,  ///< trouble() has the reason.
  };

  Sender(JobPart job, SendOptions options, Time now);
  Sender(const std::vector<JobLine>& job, SendOptions options, Time now);

  void receive(std::string_view bytes, Time now);
  /// Acts on the time that has passed. Must be called every few milliseconds at least.
  void attend(Time now);
  void lose_link(std::string why = "the link is gone") { fail(std::move(why)); }

  /// Returns realtime bytes for a link that carries them apart from lines. On other links output()
  /// includes them.
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
  /// Asks once for a full report, which only some controllers have.
  void ask_full_report() { out_.put_realtime('\x87'); }
  /// Ends the job: holds, and resets when the machine is at rest, or resets at once in a state in
  /// which a hold does nothing.
  void abort(std::string why = "aborted") { stop(std::move(why)); }

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool over() const { return state_ == State::kDone || state_ == State::kFailed; }
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  [[nodiscard]] const std::string& machine_state() const { return reported_.state; }
  /// Returns the share of the job's lines that were answered, 0…1.
  [[nodiscard]] double progress() const;
  [[nodiscard]] std::size_t answered() const { return lines_.answered(); }
  /// Returns the line of the file that comes next; 0 after the last line.
  [[nodiscard]] std::size_t file_line() const {
    return answered() < job_.size() ? number_in_file(answered()) : 0;
  }
  [[nodiscard]] std::size_t resent() const { return lines_.resent(); }
  [[nodiscard]] std::size_t errors() const { return errors_; }

  /// Called with each line in both directions: '>' for sent or '<' for received, and the line.
  std::function<void(char, std::string_view)> on_line;

 private:
  /// Numbers of checked lines.
  struct Numbering {
    bool active = false;      ///< Checked lines have begun.
    std::size_t begun = 0;    ///< Index of the line with which they began.
    std::uint32_t first = 1;  ///< Number of that line.
  };
  /// The machine by its last status report.
  struct Reported {
    std::string state{};
    bool moves = false;                   ///< The feed is not 0.
    std::optional<std::uint32_t> room{};  ///< Free space for lines, bytes.
    Time at{};                            ///< When the report came.
    unsigned count = 0;                   ///< Number of reports since the sender's state began.
    /// Number of latest consecutive reports that show the machine at rest.
    unsigned idle_count = 0;
  };

  // Lines from the controller, in sender.cpp.
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

  // Lines to the controller, in sender_lines.cpp.
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

  // Time, in sender_time.cpp.
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
  Time entered_;   ///< When the current state began.
  Time asked_;     ///< When the question of the current state was last sent.
  Time polled_;    ///< When a status report was last requested.
  Time moved_;     ///< When a line was last answered or sent again.
  Time heard_;     ///< When anything was last received.
  Time wished_{};  ///< When the operator's request was last sent.
  unsigned questions_ = 0;
  std::string trouble_;
  std::string message_;  ///< The last `[MSG:`; explains the error after it.
  std::string incoming_;
  SendQueue out_;
  LinesInFlight lines_;
  Numbering numbering_;
  std::size_t errors_ = 0;
  std::size_t room_ = 0;  ///< Free space for lines, as announced, bytes.
  bool told_options_ = false;
  bool said_reset_ = false;
  unsigned answers_owed_ = 0;  ///< Answers to questions that have not arrived.
  bool wants_hold_ = false;
  bool wants_resume_ = false;
  Reported reported_;
};

}  // namespace sim
