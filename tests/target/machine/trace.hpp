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

/// What happened and when: one line each of virtual time in ns, source and event, as README.md
/// lists them.
class Trace {
 public:
  /// Without a file only misuse is told, and to the terminal only.
  explicit Trace(std::FILE* file) : file_{file} {}

  template <typename... Values>
  void event(std::string_view source, fmt::format_string<Values...> form, Values&&... values) {
    if (file_ == nullptr) return;
    fmt::print(file_, "{} {} ", now_ns(), source);
    fmt::print(file_, form, std::forward<Values>(values)...);
    std::fputc('\n', file_);
  }

  /// From now on these words of RAM are told, where they have changed, before what is driven.
  void follow_words(const std::vector<std::uint32_t>& addresses) {
    for (const std::uint32_t address : addresses) words_.push_back({address, 0});
  }
  [[nodiscard]] bool follows_words() const { return !words_.empty(); }
  /// Those that have changed.
  void tell_words() {
    for (Word& word : words_) {
      std::uint32_t now = 0;
      qemu::cpu_physical_memory_rw(word.address, &now, sizeof now, false);
      if (now == word.told) continue;
      word.told = now;
      event("word", "{:08x} {}", word.address, now);
    }
  }

  /// Something is driven: a pin, or what makes pulses on one.
  template <typename... Values>
  void driven(std::string_view source, fmt::format_string<Values...> form, Values&&... values) {
    tell_words();
    event(source, form, std::forward<Values>(values)...);
  }

  /// The image did what the reference manual forbids or what is not modelled.
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
