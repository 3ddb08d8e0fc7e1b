#include "host-sim/send/sender.hpp"

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

/// The last line may have lost its end, and all that follows would be part of it.
void Sender::end_line_again() {
  const bool waits = state_ == State::kWaiting || state_ == State::kStopping;
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
  // A line that lost its end swallows what is asked.
  if (since(heard_) > kDeaf) return go_back(answered_);
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
