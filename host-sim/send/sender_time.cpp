#include "host-sim/send/sender.hpp"
#include "host-sim/send/state_words.hpp"

namespace sim {
namespace {

using Time = Sender::Time;

constexpr Time kPollPeriod{200};
constexpr Time kStopPollPeriod{50};
constexpr Time kFirstPoll{300};
constexpr Time kMeetingLimit{10'000};
/// A status is answered at once in every state; Grbl itself is silent while it homes.
constexpr Time kSilenceLimit{20'000};
constexpr Time kAskPeriod{2000};
constexpr Time kBeginPeriod{300};
constexpr unsigned kMostQuestions = 20;
/// Time after the last answer after which lines may have been lost,
constexpr Time kStall{60};
/// and for a single line, which may be waiting for the machine.
constexpr Time kStallOfOne{1000};
/// A wish that no report has confirmed for this long is said again.
constexpr Time kPatience{250};
/// Longer than an answer to any question takes.
constexpr Time kDeaf{300};

}  // namespace

void Sender::attend(Time now) {
  now_ = now;
  if (over()) return;
  attend_silence();
  if (over()) return;
  attend_wishes();
  if (state_ == State::kSending && numbers_lines_) attend_losses();
  repeat_question();
  end_line_again();
  send_lines();
  const bool met = state_ != State::kMeeting || since(entered_) >= kFirstPoll;
  const Time period = state_ == State::kStopping ? kStopPollPeriod : kPollPeriod;
  if (!met || since(polled_) < period) return;
  polled_ = now_;
  put_realtime('?');
}

void Sender::attend_silence() {
  if (state_ == State::kMeeting && since(entered_) > kMeetingLimit) {
    return fail("no controller answers");
  }
  if (state_ != State::kMeeting && since(heard_) > kSilenceLimit) fail("the controller is silent");
}

/// Repeats a wish until a report shows that it was heard.
void Sender::attend_wishes() {
  if (state_ == State::kStopping) attend_stop();
  if (over() || since(wished_) < kPatience) return;
  if (wants_hold_) hold();
  if (wants_resume_) resume();
}

/// Resets as soon as that costs no position, and where a machine does not come to rest. The first
/// report of a stop may have been on its way before the hold.
void Sender::attend_stop() {
  constexpr Time kLongestBraking{10'000};
  constexpr Time kLongestReset{2'000};
  if (since(entered_) > kLongestBraking + kLongestReset) return fail(std::move(trouble_));
  const bool rests = has_stopped(machine_state_) && !moves_;
  const bool known = reports_ >= 2 && (rests || is_ended_by_reset_only(machine_state_));
  if (!known && since(entered_) <= kLongestBraking) return;
  if (said_reset_ && since(wished_) < kPatience) return;
  said_reset_ = true;
  wants_hold_ = false;
  wished_ = now_;
  put_realtime('\x18');
}

/// The last line may have lost its end, and all that follows would be part of it, questions too.
/// Lines are not sent again for that: a machine on hold takes none, and they would fill the link.
void Sender::end_line_again() {
  const bool sends = state_ == State::kSending && numbers_lines_ && lines_out_.empty();
  const bool waits = state_ == State::kWaiting || state_ == State::kStopping || sends;
  if (!options_.checked || !waits || since(heard_) < kDeaf || since(asked_) < kDeaf) return;
  asked_ = now_;
  put("");
}

/// Lines of which the controller has none waiting, and no answer comes: they, or the request
/// for them, or the answers were lost.
void Sender::attend_losses() {
  if (next_ == answered_) return;
  const Time stall = next_ - answered_ == 1 ? kStallOfOne : kStall;
  if (since(moved_) < stall || !lines_out_.empty()) return;
  const bool told = room_told_ > moved_ + stall / 2 && room_now_;
  // A report may be damaged, but nothing waits where nothing is done.
  if (told && (*room_now_ >= room_ || idle_reports_ > 1)) return go_back(answered_);
  if (!room_now_ && since(moved_) > 2 * kStallOfOne) return go_back(answered_);
  if (!told && since(polled_) >= kStall) {
    polled_ = now_;
    put_realtime('?');
  }
}

/// Questions and their answers may be lost, too.
void Sender::repeat_question() {
  const bool asks = state_ == State::kAsking;
  const bool begins = state_ == State::kBeginning || state_ == State::kEnding;
  if (!asks && !begins) return;
  // Some answers were lost with what a controller does not hear while it starts.
  if (asks && told_options_ && since(moved_) > kStallOfOne) return take_options();
  if (since(asked_) < (asks ? kAskPeriod : kBeginPeriod)) return;
  if (questions_ >= kMostQuestions) return fail("the controller does not answer as one should");
  if (asks) return ask();
  if (state_ == State::kBeginning) return begin();
  send_end();
}

}  // namespace sim
