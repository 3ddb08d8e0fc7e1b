#include "tests/target/machine/options.hpp"

#include <fmt/core.h>

#include <charconv>
#include <limits>

namespace machine {
namespace {

/// Reads all of `text` as a number up to `most`; returns whether it is one.
template <typename Number>
bool take_number(std::string_view text,
                 Number& number,
                 Number most = std::numeric_limits<Number>::max(),
                 int base = 10) {
  Number read{};
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, read, base);
  if (error != std::errc{} || stopped != end || read < 0 || read > most) return false;
  number = read;
  return true;
}

bool take_text(std::string_view text, std::string& into) {
  into = text;
  return !text.empty();
}

/// Reads ADDRESS:WHAT:NS, with the address in hexadecimal digits.
template <typename Change, typename What>
bool take_change(std::string_view text, std::vector<Change>& changes, const What& take_what) {
  const std::size_t first = text.find(':');
  const std::size_t second = text.find(':', first + 1);
  if (first == std::string_view::npos || second == std::string_view::npos) return false;
  Change change;
  if (!take_number(text.substr(0, first), change.address, ~0U, 16)) return false;
  if (!take_what(text.substr(first + 1, second - first - 1), change)) return false;
  if (!take_number(text.substr(second + 1), change.at_ns)) return false;
  changes.push_back(change);
  return true;
}

bool take_flip(std::string_view text, std::vector<BitFlip>& flips) {
  return take_change(text, flips, [](std::string_view what, BitFlip& flip) {
    return take_number(what, flip.bit, 7U);
  });
}

bool take_store(std::string_view text, std::vector<WordStore>& stores) {
  return take_change(text, stores, [](std::string_view what, WordStore& store) {
    return take_number(what, store.value, ~0U, 16) && store.address % 4 == 0;
  });
}

bool take_word(std::string_view text, std::vector<std::uint32_t>& words) {
  std::uint32_t address = 0;
  if (!take_number(text, address, ~0U, 16) || address % 4 != 0) return false;
  words.push_back(address);
  return true;
}

bool take_cut_kind(std::string_view text, Cut& kind) {
  if (text == "none") kind = Cut::kNone;
  if (text == "whole") kind = Cut::kWhole;
  if (text == "torn") kind = Cut::kTorn;
  return text == "none" || text == "whole" || text == "torn";
}

bool take_serial(std::string_view name, std::string_view value, SerialOptions& serial) {
  if (name == "in") return take_text(value, serial.input);
  if (name == "out") return take_text(value, serial.output);
  if (name == "times") return take_text(value, serial.times);
  if (name == "chardev") return take_text(value, serial.chardev);
  if (name == "baud") return take_number(value, serial.baud, 10'500'000U);
  if (name == "answer_baud") return take_number(value, serial.answer_baud, 10'500'000U);
  if (name == "from_ns") return take_number(value, serial.from_ns);
  return name == "window" && take_number(value, serial.window);
}

bool take_file(std::string_view name, std::string_view value, Options& options) {
  if (name == "trace") return take_text(value, options.trace);
  if (name == "flash") return take_text(value, options.flash);
  if (name == "memory") return take_text(value, options.memory);
  if (name == "pins") return take_text(value, options.pins);
  if (name == "can_in") return take_text(value, options.can_input);
  return name == "can_out" && take_text(value, options.can_output);
}

bool take_flash_size(std::string_view text, std::uint32_t& kib) {
  return take_number(text, kib, 1024U) && (kib == 256 || kib == 512 || kib == 1024);
}

bool take_switch(std::string_view text, bool& on) {
  on = text == "on";
  return text == "on" || text == "off";
}

bool take_value(std::string_view name, std::string_view value, Options& options) {
  if (name == "word") return take_word(value, options.words);
  if (name == "seed") return take_number(value, options.seed);
  if (name == "cut") return take_number(value, options.cut);
  if (name == "cut_kind") return take_cut_kind(value, options.cut_kind);
  if (name == "erase_us") return take_number(value, options.erase_us);
  if (name == "can_corrupt") return take_number(value, options.can_corrupt_percent, 100U);
  if (name == "can_alone") return take_switch(value, options.can_alone);
  if (name == "memories_only") return take_switch(value, options.memories_only);
  if (name == "cycles") return take_switch(value, options.cycles);
  if (name == "flash_kib") return take_flash_size(value, options.flash_kib);
  if (name == "flip") return take_flip(value, options.flips);
  if (name == "store") return take_store(value, options.stores);
  if (name == "crystal_hz") return take_number(value, options.crystal_hz, 26'000'000U);
  if (name == "slow_hz") return take_number(value, options.slow_hz, 47'000U);
  if (name == "brown_out_ns") return take_number(value, options.brown_out_ns);
  return name == "stop_ns" && take_number(value, options.stop_ns);
}

}  // namespace

std::optional<std::string> take_option(std::string_view text, Options& options) {
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  const std::string_view value =
      equals == std::string_view::npos ? std::string_view{} : text.substr(equals + 1);
  bool taken = false;
  // Names of these options begin with `usart1_` to `usart6_`.
  constexpr std::string_view kUsart = "usart";
  if (name.size() > 7 && name.substr(0, 5) == kUsart && name[6] == '_' && name[5] >= '1' &&
      name[5] <= '6') {
    const auto port = static_cast<std::size_t>(name[5] - '1');
    taken = take_serial(name.substr(7), value, options.serial[port]);
  } else {
    taken = take_file(name, value, options) || take_value(name, value, options);
  }
  if (taken) return std::nullopt;
  return fmt::format("no such option, or not a value that it takes: {}", text);
}

}  // namespace machine
