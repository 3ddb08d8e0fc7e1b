#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/target/machine/qemu.hpp"
#include "tests/target/machine/virtual_clock.hpp"

namespace machine {

/// Record of events: one line each of virtual time in ns, source and event, as README.md describes.
class Trace {
 public:
  /// @param file without one, only misuse is reported, and only to the terminal
  explicit Trace(std::FILE* file) : file_{file} {}

  template <typename... Values>
  void event(std::string_view source, fmt::format_string<Values...> form, Values&&... values) {
    if (file_ == nullptr) return;
    fmt::print(file_, "{} {} ", now_ns(), source);
    fmt::print(file_, form, std::forward<Values>(values)...);
    std::fputc('\n', file_);
  }

  /// From now on, changes of these words of RAM are traced, before the next change of a pin or of
  /// pulses.
  void follow_words(const std::vector<std::uint32_t>& addresses) {
    for (const std::uint32_t address : addresses) words_.push_back({address, 0});
  }
  [[nodiscard]] bool follows_words() const { return !words_.empty(); }
  /// Traces the words that have changed.
  void tell_words() {
    for (Word& word : words_) {
      std::uint32_t now = 0;
      qemu::cpu_physical_memory_rw(word.address, &now, sizeof now, false);
      if (now == word.told) continue;
      word.told = now;
      event("word", "{:08x} {}", word.address, now);
    }
  }

  /// Traces that a pin is driven, or a source of pulses on one.
  template <typename... Values>
  void driven(std::string_view source, fmt::format_string<Values...> form, Values&&... values) {
    tell_words();
    event(source, form, std::forward<Values>(values)...);
  }

  /// Reports an action of the image that the reference manual forbids or that is not modelled.
  template <typename... Values>
  void misuse(std::string_view source, fmt::format_string<Values...> form, Values&&... values) {
    const std::string text = fmt::format(form, std::forward<Values>(values)...);
    event("misuse", "{}: {}", source, text);
    if (++misuses_ <= kToldAtMost) {
      fmt::print(stderr, "machine: {} ns: {}: {}\n", now_ns(), source, text);
    }
  }

  void flush() const {
    if (file_ != nullptr) std::fflush(file_);
  }

 private:
  static constexpr int kToldAtMost = 20;

  struct Word {
    std::uint32_t address;
    std::uint32_t told;
  };

  std::FILE* file_;
  int misuses_ = 0;
  std::vector<Word> words_;
};

}  // namespace machine
