#include "firmware/protocol/line_protocol.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "firmware/protocol/code_texts.hpp"
#include "firmware/protocol/realtime_commands.hpp"

namespace cnc {
namespace {

/// Maximum number of rows of a listing in one poll, so that `$ES` does not delay the planner.
constexpr int kRowsInATurn = 8;

/// Maximum number of lines in one poll. A cycle polls twice, so the planner can plan these lines
/// within the time of a cycle.
constexpr int kLinesInATurn = 4;

/// Returns whether a line contains only blanks and comments.
bool is_empty(std::string_view line) {
  gcode::LineReader reader{line};
  return !reader.begin(false) && reader.at_end();
}

/// Appends the CRC of the reply's present text.
Reply& put_crc(Reply& reply) {
  std::array<char, 8> digits{};
  put_line_crc(reply.view(), digits.data());
  return reply.letter('*').text({digits.data(), digits.size()});
}

}  // namespace

LineProtocol::LineProtocol(hal::ByteStream& link,
                           Machine& machine,
                           hal::RecordStore& store,
                           hal::ControlBoard* board)
    : link_{link},
      machine_{machine},
      board_{board},
      stored_{store},
      kerf_{store},
      listing_{machine, stored_, kerf_, board} {
  const Progress kept = machine_.progress().noted();
  // If stored steps per mm differ from the default, this call drops the progress that `kept`
  // contains.
  load_settings();
  machine_.set_power_table(stored_.load_power_table());
  machine_.set_places(stored_.load_places());
  machine_.progress().set(kept.any() ? kept : stored_.load_progress());
  if (stored_.damaged()) machine_.lock_for_damage();
}

void LineProtocol::poll(hal::TickCount now) {
  now_ = now;
  int rows = 0;
  int lines = 0;
  for (;;) {
    receive();
    attend_realtime();
    if (lines == 0) {
      watch_link();
      watch_checks();
    }
    outbox_.send(link_);
    if (!outbox_.empty()) return;
    if (report() || tell_news()) continue;
    if (listing_.active()) {
      if (++rows > kRowsInATurn) return;
      Reply row = begin_answer();
      if (listing_.next(row, form_)) answer(row);
      continue;
    }
    if (lines == 0) save_progress();
    attend_tool_change();
    if (machine_.busy()) return;
    if (beginning_) {
      welcome();
    } else if (startup_line_ < kStartupDone) {
      run_startup_line();
    } else if (!finish_line()) {
      if (++lines > kLinesInATurn || awaits_tool()) return;
      if (!read_line()) {
        if (refuse_lost_line()) continue;
        return save_places();
      }
      std::string_view line = assembler_.line();
      if (passes_check(line)) handle(line);
      // An answer can be written immediately if no other line must be written before it. For most
      // lines this is so.
      const bool silent = outbox_.empty() && !listing_.active() && !tell_news();
      // A sender that waits for each answer gets the answer now, so its next line can be read in
      // this cycle.
      if (silent && !machine_.busy() && finish_line()) outbox_.send(link_);
    }
  }
}

void LineProtocol::receive() {
  const bool may_wait = link_.may_wait();
  // The number of chunks is limited to the receiver's capacity.
  for (std::size_t chunk = 0; chunk < Receiver::kRealBytes / incoming_.size(); ++chunk) {
    const std::size_t room =
        may_wait ? std::min<std::size_t>(incoming_.size(), receiver_.room()) : incoming_.size();
    const std::size_t count = link_.read(std::as_writable_bytes(std::span{incoming_}.first(room)));
    if (count == 0) return;
    silence_.hear(now_);
    receiver_.receive_all(std::span{incoming_}.first(count));
  }
}

void LineProtocol::act_at_once(std::byte byte) {
  silence_.hear(now_);
  const auto code = std::to_integer<std::uint8_t>(byte);
  if (code == static_cast<std::uint8_t>(RealtimeByte::kToolAcknowledge)) return refuse_tool();
  if (machine_.tool_change().open()) receive();  // Reads the lines that arrived before `~`.
  receiver_.act_at_once(code);
}

void LineProtocol::attend_realtime() {
  if (machine_.news().reset_pressed.take()) {
    receiver_.drop_waiting();
    begin_anew();
  }
  if (receiver_.take_reset()) {
    machine_.reset();
    begin_anew();
  }
  RealtimeByte command{};
  while (receiver_.take_command(command)) {
    if (command == RealtimeByte::kParserState) {
      modes_wanted_ = true;
    } else if (command == RealtimeByte::kAutoReport) {
      auto_report_ = !auto_report_;
    } else if (command == RealtimeByte::kToolAcknowledge) {
      acknowledge_tool();
    } else if (!ends_tool_change(command)) {
      apply(command, machine_);
    }
  }
}

/// Stops the machine if the sender is gone while the beam is on.
void LineProtocol::watch_link() {
  const float allowed_ms = machine_.settings().get(setting::kLinkWatchdog);
  const bool gone = silence_.gone(now_, allowed_ms, sender_owes());
  if (gone && allowed_ms > 0.0F && machine_.beam_works()) machine_.lose_link();
}

/// Returns whether the sender must send more lines: all lines are answered, and the program has not
/// switched the beam off.
bool LineProtocol::sender_owes() const {
  const bool lit = machine_.interpreter().state().spindle != gcode::SpindleMode::kOff;
  return lit && owed_ == Owed::kNothing && !machine_.busy();
}

/// Checks for silence of a sender that sends checked lines. No further line can be expected while a
/// line waits for the machine, or while its answer waits for the link.
void LineProtocol::watch_checks() {
  if (!check_.active()) return;
  if (owed_ != Owed::kNothing || machine_.busy()) check_.keep(now_);
  check_.attend(now_);
  receiver_.be_strict(check_.strict());
}

void LineProtocol::begin_anew() {
  check_ = {};
  forget_tool_change();
  receiver_.be_strict(false);
  assembler_ = {};
  listing_.stop();
  auto_report_ = false;
  owed_ = Owed::kNothing;
  unheard_ = greeting_due_ = false;
  if (startup_trial_) startup_trial_->failed = true;
  startup_line_ = kStartupDone;
  beginning_ = true;
}

void LineProtocol::begin_sender() {
  silence_.begin_sender();
  check_ = {};
  forget_tool_change();
  tool_told_ = false;
  receiver_.begin_anew();
  assembler_ = {};
  listing_.stop();
  outbox_ = {};
  auto_report_ = false;
  unheard_ = owed_ != Owed::kNothing;
  greeting_due_ = !beginning_;
}

void LineProtocol::lose_sender() {
  begin_sender();
  greeting_due_ = false;
  if (!machine_.idle() || machine_.tool_runs()) machine_.safety_door();
}

/// Answers the last line if an answer is still owed. Called after the machine has executed the
/// line. Returns whether an answer was owed.
bool LineProtocol::finish_line() {
  if (owed_ == Owed::kNothing) return false;
  if (tell_result()) return true;
  if (owed_ == Owed::kHoming) {
    owed_ = Owed::kNothing;
    if (machine_.alarm() != Alarm::kNone) {
      if (!std::exchange(unheard_, false)) {
        refuse(error_number::kLocked, 0, "homing has failed");
      }
      return true;
    }
    startup_line_ = 0;
    owed_ = Owed::kAck;
    return true;
  }
  owed_ = Owed::kNothing;
  const auto fault = machine_.news().take_path_fault();
  const bool failed = machine_.news().line_failed.take();
  if (startup_trial_ && (failed || fault)) startup_trial_->failed = true;
  if (std::exchange(unheard_, false)) return true;
  if (failed) {
    refuse(error_number::kNotDone);
  } else if (fault) {
    refuse(*fault);
  } else {
    say_ok();
  }
  return true;
}

bool LineProtocol::read_line() {
  return receiver_.take_until([this](char byte) { return assembler_.add(byte); });
}

/// Refuses a lost line. Drops the stored beginning of the first lost line, because its end was
/// lost. Returns whether a line was lost.
bool LineProtocol::refuse_lost_line() {
  if (!receiver_.take_lost_line()) return false;
  assembler_ = {};
  refuse(error_number::kLineTooLong, 0, "more lines came than the buffer holds: reset");
  return true;
}

/// Removes the number and the check from the line. Returns whether the line is to be executed.
bool LineProtocol::passes_check(std::string_view& line) {
  const LineCheck::Judgement judged = check_.judge(line, assembler_.long_line(), now_);
  line = judged.text;
  receiver_.be_strict(check_.strict());
  switch (judged.verdict) {
    case LineCheck::Verdict::kTake:
      return true;
    case LineCheck::Verdict::kBegin:
      acknowledge();
      return false;
    case LineCheck::Verdict::kMissing:
    case LineCheck::Verdict::kRepeated:
    case LineCheck::Verdict::kDrop:
      ask_again(judged.verdict);
      return false;
    case LineCheck::Verdict::kWrong:
      refuse(error_number::kWrongCheck,
             assembler_.whole() ? static_cast<std::uint32_t>(line.size() + 1) : 0,
             "the check does not match its line");
      return false;
  }
  return false;
}

/// Requests the wanted line, or reports that the last line was dropped while a request is open.
/// With the sum, an acknowledgement follows, because Marlin sends one, too, and senders expect it.
void LineProtocol::ask_again(LineCheck::Verdict verdict) {
  Reply reply = begin_answer();
  reply.text(verdict == LineCheck::Verdict::kDrop ? "Dropped: " : "Resend: ");
  reply.number(check_.wanted());
  if (check_.form() != LineCheck::Form::kCrc) {
    answer(reply.end());
    return acknowledge();
  }
  if (verdict == LineCheck::Verdict::kRepeated) reply.text(" N").number(check_.taken());
  answer(put_crc(reply).end());
}

void LineProtocol::handle(std::string_view line) {
  starts_ = false;
  const std::string_view whole = line;
  if (assembler_.too_long()) {
    return refuse(
        error_number::kLineTooLong, kLongestLine + 1, "line is longer than 256 characters");
  }
  line = gcode::without_mark(line);
  while (!line.empty() && gcode::is_blank(line.front())) line.remove_prefix(1);
  if (!line.empty() && line.front() == '$') return take_statement(line);
  if (!machine_.locked()) return take_gcode(whole);
  if (is_empty(line)) return acknowledge();
  refuse(error_number::kLocked);
}

/// Passes a line of G-code to the machine. If the kerf tables have changed, passes the selected
/// table first.
gcode::Refusal LineProtocol::accept(std::string_view line) {
  const gcode::Material& material = machine_.interpreter().state().material;
  const bool wanted =
      material.thickness_um != 0 && !machine_.interpreter().options().kerf->holds(material.table);
  if (wanted || kerf_seen_ != kerf_.revision()) select_kerf(material.table);
  return machine_.accept(line);
}

void LineProtocol::take_gcode(std::string_view line) {
  if (machine_.tool_change().open() && machine_.inputs().door)
    return refuse(error_number::kDoorOpen);
  const gcode::Refusal refusal = accept(line);
  if (refusal) return refuse(*refusal, 1);
  saving_failed_ = false;
  acknowledge();
}

void LineProtocol::refuse(const gcode::Fault& fault,
                          std::uint32_t first_column,
                          std::uint8_t number) {
  // If the text of comments was dropped from the line, the columns differ from those of the line
  // that was sent.
  const bool known = fault.column != 0 && assembler_.whole();
  Reply reason = begin_reason(known ? fault.column + first_column - 1 : 0);
  reason.wrote(gcode::describe(fault, reason.room()));
  const auto own = static_cast<std::uint8_t>(fault.code());
  refuse(number == 0 ? own : number, reason);
}

void LineProtocol::refuse(std::uint8_t number) { refuse(number, 0, error_text(number)); }

void LineProtocol::refuse(std::uint8_t number, std::uint32_t column, std::string_view reason) {
  Reply words = begin_reason(column);
  refuse(number, words.text(reason));
}

Reply LineProtocol::begin_reason(std::uint32_t column) {
  Reply reason = begin_answer();
  return reason.text("[MSG:").number(column).text(": ");
}

void LineProtocol::refuse(std::uint8_t number, Reply& reason) {
  answer(reason.letter(']').end());
  answer_line(begin_answer().text("error:").number(number));
}

void LineProtocol::answer_line(Reply& reply) {
  silence_.answer(now_);
  if (check_.numbered()) put_crc(reply.text(" N").number(check_.taken()));
  answer(reply.end());
}

void LineProtocol::say_ok() {
  Reply reply = begin_answer();
  answer_line(reply.text("ok"));
}

void LineProtocol::message(std::string_view words) {
  answer(begin_answer().text("[MSG:").text(words).letter(']').end());
}

bool LineProtocol::inches() const {
  return machine_.settings().get(setting::kReportInches) != 0.0F;
}

}  // namespace cnc
