#include "tests/target/machine/serial_peer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace machine {
namespace {

[[noreturn]] void give_up(const char* what, const std::string& name) {
  fmt::print(stderr, "machine: {} {}\n", what, name);
  std::exit(1);
}

}  // namespace

SerialPeer::SerialPeer(const SerialOptions& options) : window_{options.window} {
  if (!options.chardev.empty()) connect(options.chardev);
  open_files(options);
  if (!options.times.empty()) read_times(options.times);
}

SerialPeer::~SerialPeer() {
  if (output_ != nullptr) std::fclose(output_);
}

void SerialPeer::open_files(const SerialOptions& options) {
  if (!options.input.empty()) {
    std::ifstream file{options.input, std::ios::binary};
    if (!file) give_up("cannot read", options.input);
    to_send_.assign(std::istreambuf_iterator<char>{file}, {});
  }
  if (!options.output.empty()) {
    output_ = std::fopen(options.output.c_str(), "wb");
    if (output_ == nullptr) give_up("cannot write", options.output);
  }
}

void SerialPeer::connect(const std::string& device) {
  qemu::Chardev* const found = qemu::qemu_chr_find(device.c_str());
  if (found == nullptr || !qemu::qemu_chr_fe_init(&device_, found, nullptr)) {
    give_up("no free -chardev with the id", device);
  }
  has_device_ = true;
  const auto room = [](void* self) {
    const std::size_t held = static_cast<SerialPeer*>(self)->to_send_.size();
    return static_cast<int>(kAhead - std::min(held, kAhead));
  };
  const auto take = [](void* self, const std::uint8_t* bytes, int size) {
    auto* const peer = static_cast<SerialPeer*>(self);
    peer->to_send_.insert(peer->to_send_.end(), bytes, bytes + size);
    if (peer->more_) peer->more_();
  };
  qemu::qemu_chr_fe_set_handlers(&device_, room, take, nullptr, nullptr, this, nullptr, true);
}

/// Reads lines `NS BYTES`, in order of time.
void SerialPeer::read_times(const std::string& file) {
  std::ifstream stream{file};
  if (!stream) give_up("cannot read", file);
  for (Burst burst; stream >> burst.at_ns >> burst.bytes;) bursts_.push_back(burst);
  timed_ = true;
}

/// Returns whether a burst permits bytes now; without one, nothing is sent.
bool SerialPeer::time_has_come() {
  while (!bursts_.empty() && bursts_.front().bytes == 0) bursts_.pop_front();
  if (bursts_.empty()) return false;
  if (bursts_.front().at_ns <= now_ns()) return true;
  alarm_.set(bursts_.front().at_ns);
  return false;
}

bool SerialPeer::line_fits() {
  const auto end = std::find(to_send_.begin(), to_send_.end(), '\n');
  const auto length = static_cast<std::size_t>(end - to_send_.begin()) + 1;
  if (unanswered_ != 0 && unanswered_ + length > window_) return false;
  lines_.push_back(length);
  unanswered_ += length;
  return true;
}

bool SerialPeer::has_byte() {
  if (to_send_.empty() || (timed_ && !time_has_come())) return false;
  if (window_ != 0 && !in_line_) in_line_ = line_fits();
  return window_ == 0 || in_line_;
}

std::optional<std::uint8_t> SerialPeer::send() {
  if (!has_byte()) return std::nullopt;
  const std::uint8_t byte = to_send_.front();
  to_send_.pop_front();
  if (timed_) --bursts_.front().bytes;
  if (byte == '\n') in_line_ = false;
  if (has_device_) qemu::qemu_chr_fe_accept_input(&device_);
  return byte;
}

void SerialPeer::hear(std::uint8_t byte) {
  if (output_ != nullptr) std::fputc(byte, output_);
  if (has_device_) qemu::qemu_chr_fe_write_all(&device_, &byte, 1);
  if (window_ != 0) hear_answer(static_cast<char>(byte));
}

void SerialPeer::hear_answer(char character) {
  if (character != '\n') {
    answer_ += character;
    return;
  }
  const bool answers = answer_.starts_with("ok") || answer_.starts_with("error:");
  if (answer_.starts_with("Grbl ")) forget_lines();
  answer_.clear();
  if (!answers || lines_.empty()) return;
  unanswered_ -= lines_.front();
  lines_.pop_front();
  if (more_) more_();
}

/// Forgets the lines that the restarted receiver will never answer: all but the line that is being
/// sent.
void SerialPeer::forget_lines() {
  if (lines_.empty()) return;
  const std::size_t last = lines_.back();
  lines_.clear();
  unanswered_ = 0;
  if (in_line_) {
    lines_.push_back(last);
    unanswered_ = last;
  }
  if (more_) more_();
}

void SerialPeer::flush() const {
  if (output_ != nullptr) std::fflush(output_);
}

}  // namespace machine
