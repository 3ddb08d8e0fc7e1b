#include "host-sim/send/send_queue.hpp"

namespace sim {

void SendQueue::put_line(std::string_view line) { lines_.push_back(std::string{line} + "\n"); }

void SendQueue::drop_lines() {
  while (lines_.size() > (written_ > 0 ? 1U : 0U)) lines_.pop_back();
}

std::string_view SendQueue::next(bool checked) {
  if (written_ == 0) {
    for (const char byte : realtime_) {
      const bool is_sent_twice = checked && byte != '?';
      realtime_out_ += is_sent_twice ? std::string{'\n', byte, byte} : std::string{byte};
    }
    realtime_.clear();
    if (!realtime_out_.empty()) return realtime_out_;
  }
  if (lines_.empty()) return {};
  return std::string_view{lines_.front()}.substr(written_);
}

void SendQueue::wrote(std::size_t count) {
  if (!realtime_out_.empty() && written_ == 0) {
    realtime_out_.erase(0, count);
    return;
  }
  written_ += count;
  if (lines_.empty() || written_ < lines_.front().size()) return;
  lines_.pop_front();
  written_ = 0;
}

}  // namespace sim
