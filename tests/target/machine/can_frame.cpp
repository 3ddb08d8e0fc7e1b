#include "tests/target/machine/can_frame.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cstdio>
#include <fstream>

namespace machine {
namespace {

constexpr std::uint32_t kWidestBase = 0x7FF, kWidestExtended = 0x1FFF'FFFF;

/// Counts the bits that are sent, and computes their checksum.
struct Bits {
  std::uint32_t checksum = 0;
  unsigned count = 0;
  unsigned stuffed = 0;
  unsigned run = 0;
  bool last = true;

  void put(bool bit) {
    ++count;
    run = bit == last ? run + 1 : 1;
    last = bit;
    if (run < 5) return;
    ++stuffed;  // A stuff bit has the opposite value, and is the first bit of a new run.
    last = !bit;
    run = 1;
  }
  void put(std::uint32_t word, unsigned bits, bool summed = true) {
    while (bits-- > 0) {
      const bool bit = (word >> bits & 1U) != 0;
      put(bit);
      if (!summed) continue;
      const bool feedback = bit != ((checksum >> 14U & 1U) != 0);
      checksum = (checksum << 1U ^ (feedback ? 0x4599U : 0U)) & 0x7FFFU;
    }
  }
};

template <typename Number>
bool take_hex(std::string_view text, Number& number) {
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number, 16);
  return error == std::errc{} && stopped == end;
}

}  // namespace

unsigned bits_on_wire(const CanFrame& frame) {
  Bits bits;
  bits.put(0, 1);
  if (frame.extended) {
    bits.put(frame.id >> 18U, 11);
    bits.put(3, 2);
    bits.put(frame.id & 0x3'FFFFU, 18);
    bits.put(frame.remote ? 4 : 0, 3);
  } else {
    bits.put(frame.id, 11);
    bits.put(frame.remote ? 4 : 0, 3);
  }
  bits.put(frame.length, 4);
  for (unsigned i = 0; i < frame.length && !frame.remote; ++i) bits.put(frame.data[i], 8);
  bits.put(bits.checksum, 15, false);
  // Checksum delimiter, acknowledgement and its delimiter, end of frame and intermission have no
  // stuff bits.
  return bits.count + bits.stuffed + 1 + 2 + 7 + 3;
}

std::uint64_t arbitration(const CanFrame& frame) {
  const std::uint64_t base = frame.extended ? frame.id >> 18U : frame.id;
  const std::uint64_t remote = frame.remote ? 1 : 0;
  if (!frame.extended) return base << 21U | remote << 20U;
  return base << 21U | 3ULL << 19U | std::uint64_t{frame.id & 0x3'FFFFU} << 1U | remote;
}

std::string text_of(const CanFrame& frame) {
  std::string text =
      frame.extended ? fmt::format("{:08X}#", frame.id) : fmt::format("{:03X}#", frame.id);
  if (frame.remote) return text + fmt::format("R{}", frame.length);
  for (unsigned i = 0; i < frame.length; ++i) text += fmt::format("{:02X}", frame.data[i]);
  return text;
}

std::optional<CanFrame> frame_of(std::string_view text) {
  CanFrame frame;
  const std::size_t hash = text.find('#');
  if ((hash != 3 && hash != 8) || !take_hex(text.substr(0, hash), frame.id)) return std::nullopt;
  frame.extended = hash == 8;
  if (frame.id > (frame.extended ? kWidestExtended : kWidestBase)) return std::nullopt;
  std::string_view data = text.substr(hash + 1);
  if (!data.empty() && data[0] == 'R') {
    frame.remote = true;
    data.remove_prefix(1);
    if (!data.empty() && (!take_hex(data, frame.length) || frame.length > 8)) return std::nullopt;
    return frame;
  }
  if (data.size() % 2 != 0 || data.size() > 2 * frame.data.size()) return std::nullopt;
  for (; !data.empty(); data.remove_prefix(2)) {
    if (!take_hex(data.substr(0, 2), frame.data[frame.length++])) return std::nullopt;
  }
  return frame;
}

bool read_frames(const std::string& path, std::vector<TimedFrame>& frames) {
  std::ifstream file{path};
  if (!file) {
    fmt::print(stderr, "machine: cannot read {}\n", path);
    return false;
  }
  std::string text;
  for (std::int64_t at_ns = 0; file >> at_ns >> text;) {
    const std::optional<CanFrame> frame = frame_of(text);
    if (!frame || at_ns < 0 || (!frames.empty() && at_ns < frames.back().at_ns)) break;
    frames.push_back({at_ns, *frame});
    text.clear();
  }
  if (file.eof() && text.empty()) return true;
  fmt::print(stderr, "machine: {}: line {} is no frame, or not later\n", path, frames.size() + 1);
  return false;
}

}  // namespace machine
