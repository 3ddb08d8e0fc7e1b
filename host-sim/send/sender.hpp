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
  /// Bytes on their way at most; 0 is what the controller says it has room for, and checked as
  /// little as keeps a serial line full, because all of it is sent again when one is damaged.
  std::size_t window = 0;
  bool goes_on_after_errors = false;
  /// Resets a controller that is held, and speaks to one in alarm: to take up what was interrupted.
  bool takes_up = false;
  std::uint32_t most_number = 9'999'999;  ///< Of a line; counting begins anew after it.
};

/// The sender's half of the conversation with a Grbl controller, without a port and without a
/// clock: whoever owns both hands over what came, asks what is to be written, and says what
/// time it is, in milliseconds since whenever.
///
/// Lines are counted by characters: so many are on their way that the controller always has
/// some. When all are answered and the machine stands still, the job is done.
class Sender {
 public:
  using Time = std::chrono::milliseconds;
  enum class State : std::uint8_t {
    kMeeting,    ///< Waits for any word.
    kAsking,     ///< What room it has; and it must be idle.
    kBeginning,  ///< With checked lines.
    kSending,
    kEnding,    ///< With checked lines.
    kWaiting,   ///< For standstill.
    kStopping,  ///< Held, then reset.
    kDone,
    kFailed,  ///< trouble() says why.
  };

  Sender(std::vector<JobLine> job, SendOptions options, Time now);

  void receive(std::string_view bytes, Time now);
  /// What time alone brings. At least every few milliseconds.
  void attend(Time now);
  void lose_link(std::string why = "the link is gone") { fail(std::move(why)); }

  /// Realtime bytes for a link that has a way of their own for them; else output() has them.
  [[nodiscard]] std::string_view realtime() const { return realtime_; }
  /// So many of them have gone that way.
  void acted(std::size_t count) { realtime_.erase(0, count); }

  /// The next bytes to be written, no more than the rest of a line; empty for none.
  [[nodiscard]] std::string_view output();
  /// So many of them are.
  void wrote(std::size_t count);

  // The operator.
  void hold();
  void resume();
  /// Ends the job: held, and at standstill reset.
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
    return answered_ < job_.size() ? job_[answered_].number : 0;
  }
  [[nodiscard]] std::size_t resent() const { return resent_; }
  [[nodiscard]] std::size_t errors() const { return errors_; }

  /// Told of every line in both directions: '>' or '<', and the line.
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

  // What is said, in sender_lines.cpp.
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
  void answered_until(std::size_t line);
  [[nodiscard]] std::size_t window() const;

  // Time, in sender_time.cpp.
  void attend_silence();
  void attend_wishes();
  void attend_losses();
  void repeat_question();
  void end_line_again();

  void enter(State state);
  void stop(std::string why);
  void fail(std::string why);
  [[nodiscard]] bool counts() const;
  [[nodiscard]] Time since(Time then) const { return now_ - then; }

  std::vector<JobLine> job_;
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
  std::string machine_state_;
};

}  // namespace sim
