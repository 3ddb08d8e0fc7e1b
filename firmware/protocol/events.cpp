#include <algorithm>

#include "firmware/protocol/identity.hpp"
#include "firmware/protocol/line_protocol.hpp"
#include "firmware/protocol/report_lines.hpp"

namespace cnc {

/// Returns whether an automatic report is due: automatic reports are switched on (0x8C), and the
/// interval of $481 has passed since the last automatic report.
bool LineProtocol::report_is_due() const {
  if (!auto_report_) return false;
  const float interval_ms = machine_.settings().get(setting::kReportInterval);
  if (interval_ms <= 0.0F) return false;
  return now_.since(reported_) >= static_cast<std::int32_t>(1000.0F * interval_ms);
}

/// Sends a status report if one was requested or is due, even while lines or listings wait. Returns
/// whether it sent one.
bool LineProtocol::report() {
  form_.inches = inches();
  const bool due = report_is_due();
  if (due) reported_ = now_;
  const bool full = receiver_.take_full_status_request();
  const bool asked = receiver_.take_status_request() || full;
  if (!asked && !due) return false;
  if (asked) silence_.poll(now_);
  Reply reply = begin_answer();
  status_.write(reply, machine_, receiver_.advertised_room(), form_, full);
  answer(reply);
  return true;
}

/// Writes the next line that no sender requested, such as an alarm or a message. Returns false if
/// there is none.
bool LineProtocol::tell_news() {
  if (greeting_due_) {
    greet();
    return true;
  }
  if (modes_wanted_) {
    modes_wanted_ = false;
    Reply reply = begin_answer();
    put_parser_state(reply, machine_);
    answer(reply);
    return true;
  }
  if (machine_.alarm() != told_alarm_) {
    told_alarm_ = machine_.alarm();
    if (told_alarm_ == Alarm::kNone) return false;
    answer(begin_answer().text("ALARM:").number(static_cast<std::uint32_t>(told_alarm_)).end());
    if (machine_.needs_reset()) message("Reset to continue");
    if (starts_)
      message("A startup line raised the alarm: reset, $X, then clear the line by $N0= or $N1=");
    return true;
  }
  if (const Uncut* const uncut = machine_.take_uncut()) {
    tell_uncut(*uncut);
    return true;
  }
  if (machine_.rest_light().take_refusal()) {
    message(RestLight::kRefusalText);
    return true;
  }
  if (sender_part_.has_refusal()) {
    message(sender_part_.take_refusal());
    return true;
  }
  const auto tool = machine_.tool_change().wanted();
  const bool news = tool.has_value() && !tool_told_;
  tool_told_ = tool.has_value();
  if (news) {
    answer(
        begin_answer().text("[MSG:Tool change: T").number(*tool).text(", then cycle start]").end());
    return true;
  }
  return attend_startup_trial();
}

/// Reports the part of the path that stays uncut, with its start in machine coordinates, such as
/// `[MSG:17.204 mm are uncut from 12.000,3.500,0.000 on; ~ goes on without them]`.
void LineProtocol::tell_uncut(const Uncut& uncut) {
  Reply reply = begin_answer();
  reply.text("[MSG:")
      .place(motion::to_coordinate(uncut.distance), false)
      .text(" mm are uncut from ");
  put_places(reply, machine_.motion().place_of(uncut.from), form_);
  const bool held = machine_.state() == MachineState::kHold;
  answer(reply.text(held ? " on; ~ goes on without them]" : " on]").end());
}

/// Reports the result of a line, such as a probe, if senders expect this report before the
/// acknowledgement of the line. Returns whether a line was written.
bool LineProtocol::tell_result() {
  if (machine_.news().probe_ended.take()) {
    Reply reply = begin_answer();
    put_probe(reply, machine_.last_probe(), form_);
    answer(reply);
    return true;
  }
  if (!machine_.news().program_ended.take()) return false;
  message("Pgm End");
  return true;
}

/// Writes the first lines after power-up and after each reset.
void LineProtocol::welcome() {
  beginning_ = false;
  form_.axes = static_cast<std::size_t>(machine_.settings().get(setting::kReportedAxes));
  greet();
  if (machine_.alarm() == Alarm::kNone) startup_line_ = 0;
  if (machine_.alarm() == Alarm::kStoreDamaged) {
    message("The store is damaged. Check settings and offsets, and store one of them again.");
  }
  tell_waiting_limits();
  tell_trouble();
}

/// Writes the lines by which a new sender recognises the controller.
void LineProtocol::greet() {
  greeting_due_ = false;
  status_.begin_anew();
  answer(begin_answer().text(identity::kBanner).end());
  if (machine_.alarm() != Alarm::kNone) message("'$H'|'$X' to unlock");
}

void LineProtocol::tell_trouble() {
  if (board_ == nullptr) return;
  Reply reply = begin_answer();
  reply.text("[MSG:");
  const std::size_t size = board_->describe_trouble(reply.room());
  if (size == 0) return;
  reply.wrote(size);
  answer(reply.letter(']').end());
}

/// Saves positions that G10, G28.1 and G30.1 have changed. Writing flash stops the processor, so
/// that no fault could switch beam or spindle off in time. So positions are saved only while
/// nothing moves and beam and spindle are off.
void LineProtocol::save_places() {
  const gcode::StoredPlaces& places = machine_.interpreter().places();
  if (!machine_.idle() || machine_.tool_runs() || saving_failed_ || stored_.has_saved(places))
    return;
  if (!machine_.memory().check_places() || stored_.save_places(places)) return;
  saving_failed_ = true;
  message("The store cannot keep the offsets");
}

}  // namespace cnc
