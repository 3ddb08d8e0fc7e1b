#include "host-sim/machine/program_link.hpp"

#include <charconv>

namespace sim {
namespace {

constexpr std::string_view kMessage = "[MSG:";
constexpr std::string_view kError = "error:";
constexpr std::string_view kAccepted = "ok";

template <typename Number>
std::size_t read_number(std::string_view text, Number& number) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  return static_cast<std::size_t>(result.ptr - text.data());
}

}  // namespace

ProgramLink::ProgramLink(std::string program, AfterRefusal after_refusal)
    : program_{std::move(program)}, after_refusal_{after_refusal} {
  const bool ends_open = !program_.empty() && program_.back() != '\n' && program_.back() != '\r';
  if (ends_open) program_ += '\n';
}

std::size_t ProgramLink::read(std::span<std::byte> into) {
  if (into.empty()) return 0;
  if (awaits_answer_ || nothing_to_send()) {
    if (!status_due_) return 0;
    status_due_ = false;
    into[0] = std::byte{'?'};
    return 1;
  }
  const char byte = program_[sent_++];
  into[0] = static_cast<std::byte>(byte);
  const bool second_of_pair = byte == '\n' && after_return_;
  after_return_ = byte == '\r';
  if (second_of_pair) return 1;
  if (!in_line_) {
    ++line_;
    line_begin_ = sent_ - 1;
  }
  in_line_ = byte != '\n' && byte != '\r';
  if (!in_line_) line_end_ = sent_ - 1;
  awaits_answer_ = !in_line_;
  return 1;
}

std::size_t ProgramLink::write(std::span<const std::byte> from) {
  for (const std::byte byte : from) {
    const char character = static_cast<char>(byte);
    if (character == '\n') {
      if (on_answer) on_answer(received_);
      take_answer(received_);
      received_.clear();
    } else if (character != '\r') {
      received_ += character;
    }
  }
  return from.size();
}

void ProgramLink::take_answer(std::string_view answer) {
  if (answer.starts_with(kMessage)) {
    message_ = answer.substr(kMessage.size(), answer.size() - kMessage.size() - 1);
    return;
  }
  const bool refused = answer.starts_with(kError);
  // Only `ok` and errors are answers. Any other line is a greeting, an alarm or a report.
  if (!refused && answer != kAccepted) return;
  awaits_answer_ = false;
  if (!refused) {
    take_message();
    if (on_taken) on_taken(line_, line_text());
    return;
  }
  ++refused_;
  if (after_refusal_ == AfterRefusal::kStop) stop();
  if (refusals_.size() == kMaxRefusals) return message_.clear();
  Refusal refusal{.line = line_, .column = 0, .number = 0, .reason = {}};
  read_number(answer.substr(kError.size()), refusal.number);
  const std::size_t digits = read_number(message_, refusal.column);
  refusal.reason = message_.size() > digits + 2 ? message_.substr(digits + 2) : message_;
  refusals_.push_back(refusal);
  message_.clear();
}

/// Records the message before an answer if it belongs to a line of G-code. Statements are also
/// answered by messages, and the end of a program causes one; these messages are dropped.
void ProgramLink::take_message() {
  if (message_.empty()) return;
  const bool statement = line_text().find_first_not_of(" \t") == line_text().find('$');
  if (!statement && message_ != "Pgm End" && messages_.size() < kMaxRefusals) {
    messages_.emplace_back(line_, message_);
  }
  message_.clear();
}

double ProgramLink::progress() const {
  return program_.empty() ? 1.0 : static_cast<double>(sent_) / static_cast<double>(program_.size());
}

}  // namespace sim
