#include "firmware/protocol/code_texts.hpp"
#include "firmware/protocol/compensation_text.hpp"
#include "firmware/protocol/line_protocol.hpp"

namespace cnc {

/// Stores a start-up line and runs it once, as Grbl does, to show whether it can run. The line is
/// stored before it runs, because nothing can be stored while the line's motion or outputs are on.
/// If the line fails later, attend_startup_trial() restores the previous line.
void LineProtocol::set_startup_line(const Statement& statement) {
  if (machine_.locked()) return refuse(error_number::kLocked);
  if (statement.text.size() > StoredText::kLongest) return refuse(error_number::kTextTooLong);
  const StoredText before = stored_.load_startup_line(statement.number);
  if (!stored_.save_startup_line(statement.number, statement.text)) {
    return refuse(error_number::kStoreFailed);
  }
  const gcode::Refusal refusal = accept(statement.text);
  if (!refusal) {
    startup_trial_ = {statement.number, before};
    return acknowledge();
  }
  if (!stored_.save_startup_line(statement.number, before.view())) {
    return refuse(error_number::kStoreFailed);
  }
  refuse(*refusal, statement.column);
}

/// Ends the trial of a stored start-up line after the line has been executed. If the line failed,
/// stores the previous line again, because a failing line would stop the machine at every start.
/// Returns whether a line was written.
bool LineProtocol::attend_startup_trial() {
  if (!startup_trial_) return false;
  if (machine_.alarm() != Alarm::kNone) startup_trial_->failed = true;
  if (!rests() || owed_ != Owed::kNothing) return false;
  const auto [index, before, failed] = *startup_trial_;
  if (failed && machine_.tool_runs()) return false;
  startup_trial_.reset();
  if (!failed) return false;
  if (!stored_.save_startup_line(index, before.view())) {
    message("The store cannot restore the startup line: clear it by $N0= or $N1=");
    return true;
  }
  Reply reply = begin_answer();
  reply.text("[MSG:$N").number(static_cast<std::uint32_t>(index));
  answer(reply.text(" failed; its previous text is restored]").end());
  return true;
}

/// Reports the fault of a compensated path that the last start-up line could not drive, if any.
void LineProtocol::tell_startup_fault() {
  const auto fault = machine_.news().take_path_fault();
  if (!fault) return;
  Reply reply = begin_answer();
  put_compensation_fault(reply.text("[MSG:Startup line: since G41 or G42, "), *fault);
  answer(reply.letter(']').end());
}

/// Runs the next start-up line. Prints the line as Grbl does, but without an answer, because a
/// sender would count it as an acknowledgement.
void LineProtocol::run_startup_line() {
  tell_startup_fault();
  if (startup_line_ == StoredState::kStartupLines) {
    startup_line_ = kStartupDone;
    return;
  }
  const StoredText line = stored_.load_startup_line(startup_line_++);
  if (line.empty() || machine_.locked()) return;
  starts_ = true;
  answer(begin_answer().letter('>').text(line.view()).end());
  const gcode::Refusal refusal = accept(line.view());
  if (!refusal) return;
  Reply reply = begin_answer();
  reply.text("[MSG:Startup line, column ").number(refusal->column).text(": ");
  reply.wrote(gcode::describe(*refusal, reply.room()));
  answer(reply.letter(']').end());
}

}  // namespace cnc
