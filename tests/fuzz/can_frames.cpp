/// libFuzzer: random frames of a bus, at random times, through the controller's link.
///
/// Each byte begins an event. Its low three bits choose the event (a frame by its identifier, time
/// that passes, words of the controller), the others the length; that many bytes follow.
///
/// Whatever arrives, nothing may crash. The text that is read consists of complete messages in
/// their order; each message is marked at its beginning, and a simple assembler puts the messages
/// together independently. A stop is reported if and only if one arrived. The node sends complete
/// messages in valid frames.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "firmware/link/can/can_link.hpp"

namespace {

namespace can = cnc::can;

constexpr std::uint8_t kNode = 0x11;
constexpr char kBegin = '\xFE';  ///< First byte of a message to the node; it occurs nowhere else.

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

/// Assembles messages of ISO 15765-2 without flow control, from frames that come in order. It finds
/// at least the messages that a receiver with limits of time and space finds.
class Assembler {
 public:
  void take(std::span<const std::byte> payload) {
    if (payload.empty()) return;
    const auto first = std::to_integer<unsigned>(payload[0]);
    const unsigned low = first & 15U;
    if (first >> 4U == 0 && low >= 1 && payload.size() > low) {
      left_ = low;
      begin(payload.subspan(1, low));
    } else if (first >> 4U == 1 && payload.size() == 8) {
      const unsigned length = low << 8U | std::to_integer<unsigned>(payload[1]);
      if (length >= 1 && length <= 7) return;  // An invalid first frame is ignored.
      left_ = length;
      if (left_ != 0) begin(payload.subspan(2));
    } else if (first >> 4U == 2 && left_ != 0) {
      const std::size_t part = std::min<std::size_t>(left_, 7);
      // A repeated frame, as after a disturbance at the end of a frame, counts once.
      if (payload.size() <= part || low == ((number_ - 1) & 15U)) return;
      if (low != number_) left_ = 0;
      number_ = (number_ + 1) & 15U;
      if (left_ != 0) add(payload.subspan(1, part));
    }
  }

  std::deque<std::string> messages;

 private:
  void begin(std::span<const std::byte> part) {
    text_.clear();
    number_ = 1;
    add(part);
  }
  void add(std::span<const std::byte> part) {
    for (const std::byte byte : part) text_ += static_cast<char>(byte);
    left_ -= static_cast<unsigned>(part.size());
    if (left_ == 0) messages.push_back(text_);
  }

  std::string text_;
  unsigned left_ = 0;
  unsigned number_ = 1;
};

/// The bus as seen by the node.
class Bus final : public hal::CanPort {
 public:
  [[nodiscard]] bool receive(hal::CanFrame& frame) override {
    if (incoming.empty()) return false;
    frame = incoming.front();
    incoming.pop_front();
    return true;
  }
  [[nodiscard]] bool send(const hal::CanFrame& frame) override {
    if (room() == 0) return false;
    sent.push_back(frame);
    return true;
  }
  [[nodiscard]] std::size_t room() const override { return 16 - sent.size(); }
  [[nodiscard]] hal::CanHealth health() const override { return {}; }
  void hear_only(std::span<const std::uint32_t> heard, std::size_t urgent) override {
    require(heard.size() == 6 && urgent <= heard.size(), "what a node hears");
  }

  std::deque<hal::CanFrame> incoming;
  std::vector<hal::CanFrame> sent;
};

class Bench {
 public:
  Bench() { link_.want_node(kNode); }

  void frame(unsigned kind, std::span<const std::uint8_t> bytes) {
    constexpr std::array<std::uint32_t, 6> kIds{can::kNetwork,
                                                can::kFailSafe,
                                                can::kRealtime + kNode,
                                                can::kTextTo + kNode,
                                                can::kHostHeartbeat,
                                                can::kLssTo};
    hal::CanFrame frame{.id = kIds[kind], .length = static_cast<std::uint8_t>(bytes.size())};
    for (std::size_t at = 0; at < bytes.size(); ++at) frame.data[at] = std::byte{bytes[at]};
    if (frame.id == can::kTextTo + kNode) mark(frame);
    const std::span payload = std::span{frame.data}.first(frame.length);
    const bool stops_all = frame.id == can::kNetwork && bytes.size() >= 2 && bytes[0] == 2;
    stop_came_ |= frame.id == can::kFailSafe || stops_all;
    if (frame.id == can::kTextTo + kNode) assembler_.take(payload);
    bus_.incoming.push_back(frame);
  }

  void turn() {
    now_ = now_.plus(1000);
    link_.attend(now_);
    if (link_.take_stop()) require(stop_came_, "a stop that nobody sent");
    for (std::byte byte{}; link_.take_realtime(byte);) {
    }
    if (link_.take_node_to_store() != 0) link_.note_stored(true);
    read();
    judge_sent();
    require(link_.node() >= 1 && link_.node() <= can::kLastNode, "a node's number");
  }

  void say(std::span<const std::uint8_t> bytes) {
    static_cast<void>(link_.write(std::as_bytes(bytes)));
  }

 private:
  /// Limits text to 7 bits, and marks the beginning of a message.
  static void mark(hal::CanFrame& frame) {
    const auto kind = std::to_integer<unsigned>(frame.data[0]) >> 4U;
    const std::size_t begin = kind == 1 ? 2 : 1;
    if (kind > 2) return;
    for (std::size_t at = begin; at < frame.length; ++at) frame.data[at] &= std::byte{0x7F};
    if (kind < 2 && frame.length > begin) frame.data[begin] = static_cast<std::byte>(kBegin);
  }

  void read() {
    std::array<std::byte, 1024> bytes{};
    const std::size_t count = link_.read(bytes);
    std::string text;
    for (std::size_t at = 0; at <= count; ++at) {
      const bool ends = at == count || static_cast<char>(bytes[at]) == kBegin;
      if (ends && !text.empty()) expect(text);
      if (ends) text.clear();
      if (at < count) text += static_cast<char>(bytes[at]);
    }
  }

  void expect(const std::string& text) {
    auto& messages = assembler_.messages;
    while (!messages.empty() && messages.front() != text) messages.pop_front();
    require(!messages.empty(), "text that is no whole message, or out of order");
    messages.pop_front();
  }

  void judge_sent() {
    for (const hal::CanFrame& frame : bus_.sent) {
      require(frame.length <= 8 && !frame.extended && !frame.remote, "a frame of 11 bits");
      const std::uint32_t function = frame.id & ~0x7FU;
      const bool known = frame.id == can::kLssFrom || function == can::kEmergency ||
                         function == can::kTextFrom || function == can::kHeartbeat;
      require(known, "an identifier of a node's");
      const auto kind = std::to_integer<unsigned>(frame.data[0]) >> 4U;
      if (function == can::kTextFrom) require(frame.length >= 1 && kind <= 3, "a frame of text");
    }
    bus_.sent.clear();
  }

  Bus bus_;
  cnc::CanLink link_{bus_, kNode};
  hal::TickCount now_{0xFFFF'0000U};
  Assembler assembler_;
  bool stop_came_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr unsigned kTime = 6;
  std::span<const std::uint8_t> input{data, size};
  Bench bench;
  while (!input.empty()) {
    const unsigned kind = input[0] & 7U;
    const unsigned length = (input[0] >> 3U) % 9U;
    input = input.subspan(1);
    const auto part = input.first(std::min<std::size_t>(length, input.size()));
    if (kind == kTime) {
      for (unsigned turns = 1 + 16 * length; turns > 0; --turns) bench.turn();
      continue;
    }
    input = input.subspan(part.size());
    kind < kTime ? bench.frame(kind, part) : bench.say(part);
    if (kind == 3) continue;  // Several frames of text may come in one cycle.
    bench.turn();
  }
  for (int turns = 0; turns < 40; ++turns) bench.turn();
  return 0;
}
