#include "firmware/protocol/line_protocol.hpp"

/// Decides which polls would do nothing, so that the simulator can skip them; no board calls it.
/// Each condition belongs to one step of LineProtocol::poll(): if the condition holds, that step
/// does nothing.
namespace cnc {

/// Returns whether poll() can only wait for the machine: the machine is busy, or all lines are
/// answered and the machine is not idle.
bool LineProtocol::waits_for_machine() const {
  if (machine_.busy()) return true;
  const bool all_is_done = owed_ == Owed::kNothing && !beginning_ && startup_line_ >= kStartupDone;
  return all_is_done && !machine_.idle();
}

/// Returns whether a report or a save is due now or may soon be due.
bool LineProtocol::has_to_tell() const {
  if (!outbox_.empty() || listing_.active() || auto_report_ || modes_wanted_ || greeting_due_ ||
      startup_trial_ || sender_part_.has_refusal()) {
    return true;
  }
  if (machine_.alarm() != told_alarm_ || machine_.has_news() ||
      machine_.tool_change().wanted().has_value() != tool_told_) {
    return true;
  }
  return machine_.progress().noted().any() ? machine_.interrupted() : stored_.has_progress();
}

bool LineProtocol::is_quiet(hal::TickCount now) const {
  if (!receiver_.is_empty() || !waits_for_machine() || has_to_tell()) return false;
  if (check_.active() || sender_part_.taken() || machine_.tool_change().open()) return false;
  if (now.since(now_) >= kMaxQuietUs) return false;
  const float allowed_ms = machine_.settings().get(setting::kLinkWatchdog);
  return allowed_ms <= 0.0F || silence_.heard_within(now, allowed_ms);
}

}  // namespace cnc
