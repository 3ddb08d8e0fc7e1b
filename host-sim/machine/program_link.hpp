#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host-sim/machine/known_link.hpp"

namespace sim {

/// The controller's answer to a line that it refuses.
struct Refusal {
  std::size_t line = 0;    ///< Number of the line, from 1.
  std::size_t column = 0;  ///< Column, from 1; 0 if the answer concerns the complete line.
  int number = 0;          ///< Grbl's error number.
  std::string reason;
};

enum class AfterRefusal {
  kStop,  ///< Stops sending, as a sender program does.
  kGoOn,  ///< Continues and checks every line, as a checker does.
};

/// A sender at the other end of the serial line. It sends a program line by line, and records the
/// refusals. It sends a line only after the answer to the previous line.
class ProgramLink final : public KnownLink {
 public:
  /// Stores a program. Adds a line end to the last line if it has none.
  ProgramLink(std::string program, AfterRefusal after_refusal);

  [[nodiscard]] std::size_t read(std::span<std::byte> into) override;
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override;
  [[nodiscard]] bool has_byte() const override {
    return status_due_ || !(awaits_answer_ || nothing_to_send());
  }

  /// Returns whether the program is sent and no answer is outstanding.
  [[nodiscard]] bool finished() const { return !awaits_answer_ && nothing_to_send(); }
  [[nodiscard]] bool awaits_answer() const { return awaits_answer_; }
  /// Requests a status report at a time when no line is being sent. A sender does this regularly to
  /// show that it is present.
  void ask_status() { status_due_ = true; }
  /// Stops sending.
  void stop() { stopped_ = true; }

  /// Returns the number of the last line that was sent, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// Returns the share of the program that was sent, 0…1.
  [[nodiscard]] double progress() const;
  /// Returns the first refusals, at most kMaxRefusals.
  [[nodiscard]] const std::vector<Refusal>& refusals() const { return refusals_; }
  [[nodiscard]] std::size_t refused() const { return refused_; }
  /// Returns the first messages of the controller about accepted lines of G-code, each with the
  /// number of its line; at most kMaxRefusals.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::string>>& messages() const {
    return messages_;
  }
  [[nodiscard]] std::string_view program() const { return program_; }

  /// Greatest number of faults of one program that a report lists.
  static constexpr std::size_t kMaxRefusals = 1000;

  /// Called for every line that the controller accepts, in order.
  std::function<void(std::size_t line, std::string_view text)> on_taken{};
  /// Called for every line that the controller sends, without the line end.
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
  std::string message_;  ///< Text of the last `[MSG:…]`, which explains the next answer.
  std::vector<Refusal> refusals_;
  std::size_t refused_ = 0;
  std::vector<std::pair<std::size_t, std::string>> messages_;
};

}  // namespace sim
