#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace machine {

/// State of the flash operation during which power goes.
enum class Cut : std::uint8_t { kNone, kWhole, kTorn };

struct SerialOptions {
  std::string input;              // File that the sender sends.
  std::string output;             // File for the bytes that the chip sends.
  std::string chardev;            // Id of a -chardev, which replaces both files.
  std::uint32_t baud = 0;         // Baud rate of the sender; 0: that of the receiver.
  std::uint32_t answer_baud = 0;  // Baud rate of the chip's bytes; 0: that of BRR.
  std::int64_t from_ns = 0;       // Earliest time at which the sender begins.
  std::string times;              // File with times and numbers of the bytes to send.
  // Greatest number of bytes in lines without an answer; 0: the sender does not wait.
  std::uint32_t window = 0;
};

struct BitFlip {
  std::uint32_t address = 0;
  unsigned bit = 0;
  std::int64_t at_ns = 0;
};

/// A word of memory that changes at a time, as if by a debugger.
struct WordStore {
  std::uint32_t address = 0;
  std::uint32_t value = 0;
  std::int64_t at_ns = 0;
};

/// Options of the command line; README.md describes each.
struct Options {
  static constexpr std::size_t kSerialPorts = 6;

  std::string trace, flash, memory, pins, can_input, can_output;
  std::vector<std::uint32_t> words;  // Addresses of words that the trace follows.
  std::uint64_t seed = 1;
  std::uint32_t cut = 0;  // Number of the flash operation that is cut; 0: none.
  Cut cut_kind = Cut::kNone;
  std::uint32_t flash_kib = 1024;
  bool memories_only = false;  // Adds only the memory that the emulator lacks, and no peripherals.
  bool cycles = false;         // Counts cycles by the model of the core; requires memories_only.
  std::uint32_t erase_us = 0;  // Time of erasing; 0: that of the data sheet.
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

/// Reads one `name=value` into the options. Returns the complaint, or nothing.
[[nodiscard]] std::optional<std::string> take_option(std::string_view text, Options& options);

}  // namespace machine
