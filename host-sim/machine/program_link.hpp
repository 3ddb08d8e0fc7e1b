#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host-sim/machine/known_link.hpp"

namespace sim {

/// The controller's answer to a line that it refused.
struct Refusal {
  std::size_t line = 0;    ///< Number of the line, from 1.
  std::size_t column = 0;  ///< Column, from 1; 0 when the answer concerns the whole line.
  int number = 0;          ///< Grbl's error number.
  std::string reason;
};

enum class AfterRefusal {
  kStop,  ///< Sends nothing more, as a sender does.
  kGoOn,  ///< Continues and checks every line, as a checker does.
};

/// A sender at the other end of the serial line. It sends a program line by line, each line when
/// the one before has been answered, and keeps the refusals.
class ProgramLink final : public KnownLink {
 public:
  /// Takes a program. A last line without a line end gets one.
  ProgramLink(std::string program, AfterRefusal after_refusal);

  [[nodiscard]] std::size_t read(std::span<std::byte> into) override;
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override;
  [[nodiscard]] bool has_byte() const override {
    return status_due_ || !(awaits_answer_ || nothing_to_send());
  }

  /// Returns whether nothing is left to send and no answer is outstanding.
  [[nodiscard]] bool finished() const { return !awaits_answer_ && nothing_to_send(); }
  [[nodiscard]] bool awaits_answer() const { return awaits_answer_; }
  /// Requests a status report at a time when no line is being sent, as a sender does now and then
  /// to show that it is present.
  void ask_status() { status_due_ = true; }
  /// Sends nothing more.
  void stop() { stopped_ = true; }

  /// Returns the number of the line sent last, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// Returns the share of the program that was sent, 0…1.
  [[nodiscard]] double progress() const;
  /// Returns the refusals, at most the first kMaxRefusals.
  [[nodiscard]] const std::vector<Refusal>& refusals() const { return refusals_; }
  [[nodiscard]] std::size_t refused() const { return refused_; }
  /// Returns the controller's messages about lines of G-code that it takes, each with the line's
  /// number; at most the first kMaxRefusals.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::string>>& messages() const {
    return messages_;
  }
  [[nodiscard]] std::string_view program() const { return program_; }

  /// Greatest number of faults that a report lists of one program.
  static constexpr std::size_t kMaxRefusals = 1000;

  /// Called for every line that the controller takes, in their order.
  std::function<void(std::size_t line, std::string_view text)> on_taken{};
  /// Called for every line that the controller sends, without its line end.
  std::function<void(std::string_view text)> on_answer{};

 private:
  [[nodiscard]] bool nothing_to_send() const {
    return (stopped_ && !in_line_) || sent_ >= program_.size();
  }
  void take_answer(std::string_view answer);
  void take_message();
  [[nodiscard]] std::string_view line_text() const {
    return program().substr(line_begin_, line_end_ - line_begin_);
  }

  std::string program_;
  AfterRefusal after_refusal_;
  std::size_t sent_ = 0;
  std::size_t line_ = 0;
  std::size_t line_begin_ = 0;
  std::size_t line_end_ = 0;
  bool in_line_ = false;
  bool after_return_ = false;
  bool awaits_answer_ = false;
  bool stopped_ = false;
  bool status_due_ = false;
  std::string received_;
  std::string message_;  ///< The last `[MSG:…]`, which explains the answer after it.
  std::vector<Refusal> refusals_;
  std::size_t refused_ = 0;
  std::vector<std::pair<std::size_t, std::string>> messages_;
};

}  // namespace sim
