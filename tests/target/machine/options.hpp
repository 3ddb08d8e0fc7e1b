#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace machine {

/// What power leaves of the flash operation during which it goes.
enum class Cut : std::uint8_t { kNone, kWhole, kTorn };

struct SerialOptions {
  std::string input;              // File that a sender sends.
  std::string output;             // File of what the chip sends.
  std::string chardev;            // Instead of both: the id of a -chardev.
  std::uint32_t baud = 0;         // Of the sender; 0: as the receiver.
  std::uint32_t answer_baud = 0;  // At which the chip's bytes go out; 0: as BRR says.
  std::int64_t from_ns = 0;       // When the sender begins, at the earliest.
  std::string times;              // File of when it sends how many bytes.
  std::uint32_t window = 0;       // Bytes of lines without an answer; 0: no waiting.
};

struct BitFlip {
  std::uint32_t address = 0;
  unsigned bit = 0;
  std::int64_t at_ns = 0;
};

/// A word of memory that changes, as a debugger would change it.
struct WordStore {
  std::uint32_t address = 0;
  std::uint32_t value = 0;
  std::int64_t at_ns = 0;
};

/// What was said on the command line; README.md describes each.
struct Options {
  static constexpr std::size_t kSerialPorts = 6;

  std::string trace, flash, memory, pins, can_input, can_output;
  std::vector<std::uint32_t> words;  // Addresses of words to be told.
  std::uint64_t seed = 1;
  std::uint32_t cut = 0;  // Operation; 0: none.
  Cut cut_kind = Cut::kNone;
  std::uint32_t flash_kib = 1024;
  bool memories_only = false;  // Nothing of the chip but what the emulator's own memory lacks.
  bool cycles = false;         // A model of the core counts them; with memories_only.
  std::uint32_t erase_us = 0;  // 0: as the data sheet has it.
  std::array<SerialOptions, kSerialPorts> serial;
  std::uint32_t can_corrupt_percent = 0;
  bool can_alone = false;
  std::vector<BitFlip> flips;
  std::vector<WordStore> stores;
  std::uint32_t crystal_hz = 8'000'000;
  std::uint32_t slow_hz = 32'000;
  std::int64_t brown_out_ns = 0;  // 0: never.
  std::int64_t stop_ns = 0;       // 0: never.
};

/// One `name=value` into the options; what is wrong with it, or nothing.
[[nodiscard]] std::optional<std::string> take_option(std::string_view text, Options& options);

}  // namespace machine
