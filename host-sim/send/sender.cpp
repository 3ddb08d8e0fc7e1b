#include "host-sim/send/sender.hpp"

#include <fmt/format.h>

#include "host-sim/send/code_words.hpp"
#include "host-sim/send/state_words.hpp"

namespace sim {
namespace {

/// Returns `line 2: error:20: ` and the controller's own explanation, or the description of the
/// number if the controller gave none.
std::string refusal_text(std::size_t line, std::uint32_t code, const std::string& message) {
  std::string text = fmt::format("line {}: error:{}", line, code);
  if (message.empty()) {
    const std::string words = error_words(code);
    return words.empty() ? text : text + ": " + words;
  }
  text += ": " + message;
  const std::string_view remedy = error_remedy(code);
  if (!remedy.empty()) text += fmt::format("{} {}", message.ends_with('.') ? "" : ".", remedy);
  return text;
}

constexpr unsigned kIdleReports = 2;
constexpr const char* kInAlarm = "the controller is in alarm: home or unlock it first";
/// Number of requests to begin checked lines that the controller may refuse. A Grbl refuses all of
/// them. A link that damages one byte in 80 spoils some requests, but hardly ever this number of
/// requests in succession.
constexpr unsigned kMaxRefused = 12;

}  // namespace

Sender::Sender(const std::vector<JobLine>& job, SendOptions options, Time now)
    : Sender{JobPart{.lines = std::make_shared<const JobLines>(job)}, options, now} {}

Sender::Sender(JobPart job, SendOptions options, Time now)
    : job_{std::move(job)},
      options_{options},
      now_{now},
      entered_{now},
      asked_{now},
      polled_{now},
      moved_{now},
      heard_{now} {}

void Sender::receive(std::string_view bytes, Time now) {
  now_ = now;
  if (!bytes.empty()) heard_ = now;
  for (const char byte : bytes) {
    if (byte != '\n' && byte != '\r') {
      incoming_ += byte;
      continue;
    }
    if (!incoming_.empty() && !over()) take_line(incoming_);
    incoming_.clear();
  }
  if (!over()) send_lines();
}

void Sender::take_line(std::string_view line) {
  if (on_line) on_line('<', line);
  const Answer answer = read_answer(line);
  if (answer.kind == AnswerKind::kMessage) message_ = answer.text;
  if (state_ == State::kMeeting) return meet(answer);
  switch (answer.kind) {
    case AnswerKind::kStatus:
      return take_status(answer);
    case AnswerKind::kOptions:
      told_options_ = true;
      room_ = answer.waiting_room.value_or(0);
      return;
    case AnswerKind::kAlarm:
    case AnswerKind::kBanner:
      return take_trouble(answer);
    case AnswerKind::kOk:
    case AnswerKind::kError:
    case AnswerKind::kResend:
      return numbering_.active && state_ == State::kSending ? take_checked(answer)
                                                            : take_plain(answer);
    default:
      return;
  }
}

void Sender::meet(const Answer& answer) {
  if (answer.kind == AnswerKind::kStatus) reported_.state = answer.state;
  if (answer.kind == AnswerKind::kStatus || answer.kind == AnswerKind::kBanner) {
    enter(State::kAsking);
  }
}

void Sender::take_status(const Answer& answer) {
  reported_.state = answer.state;
  // A damaged report may lack the free space of the buffer.
  if (answer.waiting_room) reported_.room = answer.waiting_room;
  reported_.at = now_;
  reported_.moves = answer.moves;
  ++reported_.count;
  if (reported_.state.starts_with("Hold") || reported_.state.starts_with("Door"))
    wants_hold_ = false;
  if (reported_.state.starts_with("Run") || is_at_rest(reported_.state)) wants_resume_ = false;
  const bool alarm = reported_.state.starts_with("Alarm");
  const bool rests = is_at_rest(reported_.state) || (options_.rests_in_alarm && alarm);
  reported_.idle_count = rests ? reported_.idle_count + 1 : 0;
  if (state_ == State::kWaiting && alarm && !rests) return fail(kInAlarm);
  if (state_ == State::kWaiting && reported_.idle_count >= kIdleReports) {
    enter(numbering_.active ? State::kEnding : State::kDone);
  }
  if (state_ == State::kAsking) judge_state();
}

/// Checks by the state of the machine whether lines can be sent. Fails if the controller is in
/// alarm, unless the options permit that. Resets a held controller if the options require it.
void Sender::judge_state() {
  const bool alarm = reported_.state.starts_with("Alarm");
  if (alarm && !options_.rests_in_alarm) return fail(kInAlarm);
  if (!options_.takes_up) return;
  if (said_reset_ || alarm || is_at_rest(reported_.state) || reported_.moves) return;
  if (!has_stopped(reported_.state)) return;
  said_reset_ = true;
  out_.put_realtime('\x18');
}

void Sender::take_trouble(const Answer& answer) {
  if (answer.kind == AnswerKind::kAlarm) {
    const std::string words = alarm_words(answer.code);
    std::string why = fmt::format("ALARM:{} near line {}", answer.code, file_line());
    if (!words.empty()) why += ": " + words;
    return fail(state_ == State::kStopping ? trouble_ + "; " + why : std::move(why));
  }
  // The opening of a port may have restarted the controller. Its banner may arrive at any later
  // time.
  if (state_ == State::kAsking || state_ == State::kBeginning) {
    answers_owed_ = 0;
    return enter(State::kAsking);
  }
  if (state_ == State::kStopping) return fail(std::move(trouble_));
  // The job is complete. The reset has ended the numbering of lines, too, so nothing is left to do.
  if (state_ == State::kEnding) return enter(State::kDone);
  fail("the controller has restarted");
}

/// Counts answers. Each answer belongs to the oldest line in flight.
void Sender::take_plain(const Answer& answer) {
  switch (state_) {
    case State::kAsking:
      if (answers_owed_ > 0) --answers_owed_;
      moved_ = now_;
      if (answers_owed_ == 0) take_options();
      return;
    case State::kBeginning:
      // A Grbl answers every line with a number and a check with an error.
      if (answer.kind != AnswerKind::kOk || !answer.checked ||
          answer.line != numbering_.first - 1) {
        if (answer.kind == AnswerKind::kError && questions_ >= kMaxRefused) {
          fail("the controller knows no checked lines: send without --checked");
        }
        return;
      }
      numbering_.active = true;
      return enter(State::kSending);
    case State::kEnding:
      return take_end(answer);
    case State::kSending:
      if (lines_.count() == 0) return;  // No line waits for an answer.
      if (answer.kind == AnswerKind::kError) refused(answered(), answer);
      return answered_until(answered() + 1);
    default:
      return;
  }
}

/// Ignores an answer without a correct CRC. An answer to a line also answers all lines before it.
void Sender::take_checked(const Answer& answer) {
  if (!answer.checked) return;
  const bool resend = answer.kind == AnswerKind::kResend;
  if (!resend && !answer.line) return;
  const std::uint32_t count = resend ? answer.number - 1 : *answer.line;
  if (count + 1 < numbering_.first) return;  // The answer is to a line before numbering_.begun.
  const std::size_t taken = numbering_.begun + (count + 1 - numbering_.first);
  if (!lines_.were_sent_until(taken)) return;  // The answer is to a line that was never sent.
  if (taken < answered() && resend) {
    return stop(
        fmt::format("the controller requests line {} again, although it has acknowledged this line",
                    number_in_file(taken)));
  }
  if (answer.kind == AnswerKind::kError) refused(taken - 1, answer);
  if (taken > answered()) answered_until(taken);
  if (resend && !answer.line && taken < lines_.next()) go_back(taken);
}

void Sender::take_options() {
  if (told_options_) enter(options_.checked ? State::kBeginning : State::kSending);
}

/// Marks all lines before `line` as answered, including lines that waited to be sent again.
void Sender::answered_until(std::size_t line) {
  lines_.answer_until(line);
  moved_ = now_;
}

void Sender::take_end(const Answer& answer) {
  if (answer.kind != AnswerKind::kOk || answer.checked || !answer.text.empty()) return;
  numbering_.active = false;
  enter(State::kDone);
}

void Sender::refused(std::size_t line, const Answer& answer) {
  ++errors_;
  const std::size_t number = line < job_.size() ? number_in_file(line) : 0;
  std::string why = refusal_text(number, answer.code, message_);
  message_.clear();
  if (options_.goes_on_after_errors) {
    if (trouble_.empty()) trouble_ = std::move(why);
    return;
  }
  stop(std::move(why));
}

double Sender::progress() const {
  return job_.empty() ? 1.0 : static_cast<double>(answered()) / static_cast<double>(job_.size());
}

void Sender::hold() {
  wants_hold_ = true;
  wants_resume_ = false;
  wished_ = now_;
  out_.put_realtime('!');
}

void Sender::resume() {
  wants_hold_ = false;
  wants_resume_ = true;
  wished_ = now_;
  out_.put_realtime('~');
}

void Sender::stop(std::string why) {
  if (over() || state_ == State::kStopping) return;
  trouble_ = std::move(why);
  if (state_ == State::kMeeting) return enter(State::kFailed);
  enter(State::kStopping);
  out_.drop_lines();
  hold();
  polled_ = now_;
  out_.put_realtime('?');
}

void Sender::fail(std::string why) {
  if (over()) return;
  trouble_ = std::move(why);
  enter(State::kFailed);
}

void Sender::enter(State state) {
  state_ = state;
  entered_ = asked_ = moved_ = now_;
  questions_ = 0;
  reported_.count = 0;
  reported_.idle_count = 0;
  if (state == State::kStopping) said_reset_ = false;
  switch (state) {
    case State::kAsking:
      return ask();
    case State::kBeginning:
      return begin();
    case State::kEnding:
      return send_end();
    case State::kDone:
      if (errors_ > 0) state_ = State::kFailed;
      return;
    default:
      return;
  }
}

}  // namespace sim
