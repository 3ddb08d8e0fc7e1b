#pragma once

#include <fmt/core.h>

#include <cstdint>
#include <cstdio>
#include <string_view>
#include <utility>

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

  /// From now on this word of RAM is told, where it has changed, before what is driven.
  void follow_word(std::uint32_t address) { word_address_ = address; }
  [[nodiscard]] bool follows_word() const { return word_address_ != 0; }

  /// Something is driven: a pin, or what makes pulses on one.
  template <typename... Values>
  void driven(std::string_view source, fmt::format_string<Values...> form, Values&&... values) {
    if (follows_word()) tell_word();
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

  void tell_word() {
    std::uint32_t word = 0;
    qemu::cpu_physical_memory_rw(word_address_, &word, sizeof word, false);
    if (word == word_) return;
    word_ = word;
    event("word", "{}", word);
  }

  std::FILE* file_;
  int misuses_ = 0;
  std::uint32_t word_address_ = 0;
  std::uint32_t word_ = 0;  // As it was told last.
};

}  // namespace machine
