#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/send/answer.hpp"
#include "host-sim/send/job_lines.hpp"

namespace sim {

struct SendOptions {
  bool checked = false;  ///< Lines with number and CRC; else plain ones, as for any Grbl.
  /// Bytes on their way at most. 0 stands for the free space that the controller announces; for
  /// checked lines, which are all repeated after a damaged one, for the least that keeps a serial
  /// line full.
  std::size_t window = 0;
  bool goes_on_after_errors = false;
  /// Resets a controller that is held, to resume an interrupted job.
  bool takes_up = false;
  /// A controller in alarm takes these lines: questions, other `$` statements, `$X` first.
  bool rests_in_alarm = false;
  std::uint32_t most_number = 9'999'999;  ///< Of a line; the count restarts after it.
};

/// The sender's half of the conversation with a Grbl controller, without a port and without a
/// clock. The owner of both hands over the bytes that arrived, takes those to be written, and
/// gives the time in milliseconds since any instant.
///
/// Lines are counted by characters, so that the controller always has some waiting. When all are
/// answered and the machine stands still, the job is done. However a job ends early, the
/// controller is reset: at standstill, and at once in states in which a hold does nothing.
class Sender {
 public:
  using Time = std::chrono::milliseconds;
  enum class State : std::uint8_t {
    kMeeting,    ///< Waits for any word.
    kAsking,     ///< For its free space; and it must be idle.
    kBeginning,  ///< With checked lines.
    kSending,
    kWaiting,   ///< For standstill.
    kEnding,    ///< With checked lines, at standstill: from here on a damaged byte may be a reset.
    kStopping,  ///< Held, then reset: nothing of the job is left to go on.
    kDone,
    kFailed,  ///< trouble() says why.
  };

  Sender(JobPart job, SendOptions options, Time now);
  Sender(const std::vector<JobLine>& job, SendOptions options, Time now);

  void receive(std::string_view bytes, Time now);
  /// Acts on the time that has passed; to be called every few milliseconds at least.
  void attend(Time now);
  void lose_link(std::string why = "the link is gone") { fail(std::move(why)); }

  /// Realtime bytes for a link that carries them apart from lines; else output() has them.
  [[nodiscard]] std::string_view realtime() const { return realtime_; }
  /// Drops `count` of them, which the link has carried.
  void acted(std::size_t count) { realtime_.erase(0, count); }

  /// The next bytes to be written, no more than the rest of a line; empty for none.
  [[nodiscard]] std::string_view output();
  /// Drops `count` bytes of output(), which were written.
  void wrote(std::size_t count);

  // The operator.
  void hold();
  void resume();
  /// Asks for a full report, once; for a controller that has one.
  void ask_full_report() { put_realtime('\x87'); }
  /// Ends the job: holds, and resets at standstill, or at once where a hold does nothing.
  void abort(std::string why = "aborted") { stop(std::move(why)); }

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] bool over() const { return state_ == State::kDone || state_ == State::kFailed; }
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  [[nodiscard]] const std::string& machine_state() const { return machine_state_; }
  /// Share of the job's lines that were answered, 0…1.
  [[nodiscard]] double progress() const;
  [[nodiscard]] std::size_t answered() const { return answered_; }
  /// The line of the file that comes next; 0 behind the last.
  [[nodiscard]] std::size_t file_line() const {
    return answered_ < job_.size() ? number_in_file(answered_) : 0;
  }
  [[nodiscard]] std::size_t resent() const { return resent_; }
  [[nodiscard]] std::size_t errors() const { return errors_; }

  /// Gets every line in both directions: '>' or '<', and the line.
  std::function<void(char, std::string_view)> on_line;

 private:
  // The other end's words, in sender.cpp.
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

  // Writing, in sender_lines.cpp.
  void ask();
  void begin();
  void send_lines();
  void send_end();
  void go_back(std::size_t line);
  void put(std::string line);
  void put_realtime(char byte) { realtime_ += byte; }
  [[nodiscard]] std::string between_lines(char byte) const;
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
  Time entered_;   ///< When this state began,
  Time asked_;     ///< when its question was put last,
  Time polled_;    ///< when a status was,
  Time moved_;     ///< when something was answered or sent again,
  Time heard_;     ///< and when anything was heard.
  Time wished_{};  ///< When the operator's wish was last said.
  unsigned questions_ = 0;
  std::string trouble_;
  std::string message_;  ///< The last `[MSG:`, which explains the error after it.
  std::string incoming_;
  std::deque<std::string> lines_out_;
  std::size_t line_out_written_ = 0;
  std::string realtime_;      ///< Bytes that are to act,
  std::string realtime_out_;  ///< and those on their way between the lines, as they are written.

  std::size_t next_ = 0;           ///< The line to be sent.
  std::size_t furthest_ = 0;       ///< All before it were sent once.
  std::size_t answered_ = 0;       ///< All before it are.
  std::deque<std::size_t> sizes_;  ///< Of the lines from answered_ to next_, in bytes,
  std::size_t on_their_way_ = 0;   ///< and their sum.
  std::size_t begun_ = 0;          ///< The line with which checked ones began,
  std::uint32_t first_n_ = 1;      ///< and its number.
  std::size_t resent_ = 0;
  std::size_t errors_ = 0;
  std::size_t room_ = 0;                   ///< For lines, as the controller told it.
  std::optional<std::uint32_t> room_now_;  ///< In the last status.
  Time room_told_{};
  bool numbers_lines_ = false;  ///< Checked lines have begun.
  bool told_options_ = false;
  bool said_reset_ = false;
  unsigned answers_owed_ = 0;  ///< To questions.
  bool wants_hold_ = false;
  bool wants_resume_ = false;
  unsigned idle_reports_ = 0;
  unsigned reports_ = 0;  ///< Of the machine since this state began.
  bool moves_ = false;    ///< In the last of them.
  std::string machine_state_;
};

}  // namespace sim
