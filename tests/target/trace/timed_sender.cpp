#include "tests/target/trace/timed_sender.hpp"

#include <algorithm>

namespace trace {

void TimedSender::arrive_before(std::uint32_t turn) {
  const std::size_t before = sent_.size();
  while (injected_ < injections_.size() && injections_[injected_].turn <= turn) {
    sent_ += injections_[injected_++].byte;
  }
  while (next_ < program_.size() && sent_.size() < before + kBurst) {
    if (!in_line_ && !line_fits()) break;
    in_line_ = program_[next_] != '\n';
    sent_ += program_[next_++];
  }
  if (sent_.size() > before) bursts_.push_back({turn, sent_.size() - before});
}

bool TimedSender::line_fits() {
  const std::size_t length = program_.find('\n', next_) + 1 - next_;
  if (unanswered_ > 0 && unanswered_ + length > kWindow) return false;
  lines_.push_back(length);
  unanswered_ += length;
  return true;
}

std::size_t TimedSender::read(std::span<std::byte> into) {
  const std::size_t count = std::min(into.size(), sent_.size() - read_);
  for (std::size_t i = 0; i < count; ++i) into[i] = static_cast<std::byte>(sent_[read_ + i]);
  read_ += count;
  return count;
}

std::size_t TimedSender::write(std::span<const std::byte> from) {
  for (const std::byte byte : from) {
    heard_ += static_cast<char>(byte);
    if (heard_.back() != '\n') continue;
    take_answer(heard_);
    heard_.clear();
  }
  return from.size();
}

void TimedSender::take_answer(std::string_view answer) {
  const bool refused = answer.starts_with("error:");
  if ((!refused && !answer.starts_with("ok")) || lines_.empty()) return;
  refused_ += refused ? 1 : 0;
  unanswered_ -= lines_.front();
  lines_.pop_front();
}

}  // namespace trace
