#include "hal/host/slcan_host.hpp"

namespace hal::host {

bool SlcanHost::receive(CanFrame& frame) {
  if (received_.empty()) return false;
  frame = received_.front();
  received_.pop_front();
  return true;
}

bool SlcanHost::send(const CanFrame& frame) {
  if (frame.length > frame.data.size() || room() == 0) return false;
  to_say_ += slcan_line(frame);
  return true;
}

std::size_t SlcanHost::room() const {
  return to_say_.size() >= kMaxToSay ? 0 : (kMaxToSay - to_say_.size()) / kLongestSlcanLine;
}

void SlcanHost::hear(std::span<const char> bytes) {
  for (const char letter : bytes) {
    if (letter == kSlcanRefused) {
      line_.clear();
    } else if (letter == kSlcanDone) {
      take_line();
    } else if (line_.size() <= kLongestSlcanLine) {
      line_ += letter;
    }
  }
}

/// Processes a line from the adapter. A line without a frame (empty, or `z`) only confirms that the
/// adapter has accepted a frame.
void SlcanHost::take_line() {
  const auto frame = read_slcan(line_);
  line_.clear();
  if (!frame) return;
  if (received_.size() == kFrames) {
    ++counts_.lost_frames;
    return;
  }
  received_.push_back(*frame);
}

}  // namespace hal::host
