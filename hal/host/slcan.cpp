#include "hal/host/slcan.hpp"

namespace hal::host {

bool Slcan::receive(CanFrame& frame) {
  if (received_.empty()) return false;
  frame = received_.front();
  received_.pop_front();
  return true;
}

/// Drops the frame while the channel is closed, because a host that opens the channel does not
/// expect earlier frames.
bool Slcan::send(const CanFrame& frame) {
  if (frame.length > frame.data.size() || room() == 0) return false;
  if (!open_) return true;
  to_say_ += slcan_line(frame);
  return true;
}

std::size_t Slcan::room() const {
  return to_say_.size() >= kMaxToSay ? 0 : (kMaxToSay - to_say_.size()) / kLongestSlcanLine;
}

void Slcan::hear(std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) {
    const char letter = std::to_integer<char>(byte);
    if (letter != kSlcanDone && letter != '\n') {
      if (line_.size() <= kLongestSlcanLine) line_ += letter;
      continue;
    }
    if (!line_.empty()) to_say_ += obey(line_) ? kSlcanDone : kSlcanRefused;
    line_.clear();
  }
}

bool Slcan::obey(std::string_view line) {
  if (line.size() > kLongestSlcanLine) return false;
  switch (line[0]) {
    case 'O':
    // "Listen only" has the same effect as "open" here, because the bus has no other node.
    case 'L':
      open_ = true;
      return true;
    case 'C':
      open_ = false;
      return true;
    case 'S':
    case 's':
      return !open_;
    case 't':
    case 'T':
    case 'r':
    case 'R':
      return open_ && take_frame(line);
    case 'F':
      to_say_ += "F00";
      return true;
    case 'V':
      to_say_ += "V1013";
      return true;
    case 'N':
      to_say_ += "NKERF";
      return true;
    case 'Z':
      // Only "off" is accepted, because time stamps of frames are not supported.
      return line == "Z0";
    default:
      return false;
  }
}

bool Slcan::take_frame(std::string_view line) {
  const auto frame = read_slcan(line);
  if (!frame) return false;
  if (received_.size() == kFrames) {
    ++counts_.lost_frames;
    return false;
  }
  received_.push_back(*frame);
  return true;
}

void Slcan::close() {
  open_ = false;
  line_.clear();
  to_say_.clear();
  received_.clear();
}

}  // namespace hal::host
