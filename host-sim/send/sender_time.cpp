#include "host-sim/send/sender.hpp"
#include "host-sim/send/state_words.hpp"

namespace sim {
namespace {

using Time = Sender::Time;

constexpr Time kPollPeriod{200};
constexpr Time kStopPollPeriod{50};
constexpr Time kFirstPoll{300};
constexpr Time kMeetingLimit{10'000};
/// Longest silence of a controller. A controller answers a status request immediately in every
/// state, but Grbl is silent while it homes.
constexpr Time kSilenceLimit{20'000};
constexpr Time kAskPeriod{2000};
constexpr Time kBeginPeriod{300};
constexpr unsigned kMaxQuestions = 20;
/// Time since the last answer after which several lines may have been lost.
constexpr Time kStall{60};
/// Time since the last answer after which a single line may have been lost. It is longer than
/// kStall, because a single unanswered line may only be waiting for the machine.
constexpr Time kStallOfOne{1000};
/// Time within which a report should confirm a request of the operator. Otherwise the request is
/// repeated.
constexpr Time kPatience{250};
/// Time without an answer after which the last line may have lost its end. It is longer than an
/// answer to any question takes.
constexpr Time kDeaf{300};

}  // namespace

void Sender::attend(Time now) {
  now_ = now;
  if (over()) return;
  attend_silence();
  if (over()) return;
  attend_wishes();
  if (state_ == State::kSending && numbering_.active) attend_losses();
  repeat_question();
  end_line_again();
  send_lines();
  const bool met = state_ != State::kMeeting || since(entered_) >= kFirstPoll;
  const Time period = state_ == State::kStopping ? kStopPollPeriod : kPollPeriod;
  if (!met || since(polled_) < period) return;
  polled_ = now_;
  out_.put_realtime('?');
}

void Sender::attend_silence() {
  if (state_ == State::kMeeting && since(entered_) > kMeetingLimit) {
    return fail("no controller answers");
  }
  if (state_ != State::kMeeting && since(heard_) > kSilenceLimit) fail("the controller is silent");
}

/// Repeats a request of the operator until a report shows that the controller received it.
void Sender::attend_wishes() {
  if (state_ == State::kStopping) attend_stop();
  if (over() || since(wished_) < kPatience) return;
  if (wants_hold_) hold();
  if (wants_resume_) resume();
}

/// Resets the controller as soon as a reset keeps the position, or if the machine does not come to
/// rest in time. Two reports are required, because the first report that shows the machine at rest
/// may have been sent before the hold.
void Sender::attend_stop() {
  constexpr Time kLongestBraking{10'000};
  constexpr Time kLongestReset{2'000};
  if (since(entered_) > kLongestBraking + kLongestReset) return fail(std::move(trouble_));
  const bool rests = has_stopped(reported_.state) && !reported_.moves;
  const bool known = reported_.count >= 2 && (rests || is_ended_by_reset_only(reported_.state));
  if (!known && since(entered_) <= kLongestBraking) return;
  if (said_reset_ && since(wished_) < kPatience) return;
  said_reset_ = true;
  wants_hold_ = false;
  wished_ = now_;
  out_.put_realtime('\x18');
}

/// Sends an empty line. The last line may have lost its end, and all later bytes, including
/// questions, would become part of it. The lines in flight are not sent again here, because a
/// machine on hold accepts no lines, and the lines would fill the link.
void Sender::end_line_again() {
  const bool sends = state_ == State::kSending && numbering_.active && !out_.has_lines();
  const bool waits = state_ == State::kWaiting || state_ == State::kStopping || sends;
  if (!options_.checked || !waits || since(heard_) < kDeaf || since(asked_) < kDeaf) return;
  asked_ = now_;
  put("");
}

/// Sends the unanswered lines again if the controller has no line waiting. In this case the lines,
/// the request to repeat them, or the answers were lost.
void Sender::attend_losses() {
  if (lines_.count() == 0) return;
  const Time stall = lines_.count() == 1 ? kStallOfOne : kStall;
  if (since(moved_) < stall || out_.has_lines()) return;
  const bool told = reported_.at > moved_ + stall / 2 && reported_.room;
  // A single report may be damaged. A machine that reports idle more than once has no line waiting.
  if (told && (*reported_.room >= room_ || reported_.idle_count > 1)) return go_back(answered());
  if (!reported_.room && since(moved_) > 2 * kStallOfOne) return go_back(answered());
  if (!told && since(polled_) >= kStall) {
    polled_ = now_;
    out_.put_realtime('?');
  }
}

/// Repeats a question, because the question or its answer may be lost.
void Sender::repeat_question() {
  const bool asks = state_ == State::kAsking;
  const bool begins = state_ == State::kBeginning || state_ == State::kEnding;
  if (!asks && !begins) return;
  // Some answers never come, because the controller did not receive the questions while it started.
  if (asks && told_options_ && since(moved_) > kStallOfOne) return take_options();
  if (since(asked_) < (asks ? kAskPeriod : kBeginPeriod)) return;
  if (questions_ >= kMaxQuestions) return fail("the answers of the controller are not complete");
  if (asks) return ask();
  if (state_ == State::kBeginning) return begin();
  send_end();
}

}  // namespace sim
