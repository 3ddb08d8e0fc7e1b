#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host-sim/machine/known_link.hpp"

namespace sim {

/// What the controller answered to a line it refused.
struct Refusal {
  std::size_t line = 0;    ///< From 1.
  std::size_t column = 0;  ///< From 1; 0 when the whole line is meant.
  int number = 0;          ///< Grbl's error number.
  std::string reason;
};

enum class AfterRefusal {
  kStop,  ///< As a sender does: send nothing more.
  kGoOn,  ///< Look at every line, as a checker does.
};

/// A sender at the other end of the serial line: sends a program line by line,
/// each when the one before has been answered, and keeps what was refused.
class ProgramLink final : public KnownLink {
 public:
  /// A last line without a line end gets one.
  ProgramLink(std::string program, AfterRefusal after_refusal);

  [[nodiscard]] std::size_t read(std::span<std::byte> into) override;
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override;
  [[nodiscard]] bool has_byte() const override {
    return status_due_ || !(awaits_answer_ || nothing_to_send());
  }

  /// Nothing left to send and no answer outstanding.
  [[nodiscard]] bool finished() const { return !awaits_answer_ && nothing_to_send(); }
  [[nodiscard]] bool awaits_answer() const { return awaits_answer_; }
  /// Asks for a status report when no line is being sent, as a sender does now and then to be
  /// known to be there.
  void ask_status() { status_due_ = true; }
  /// Sends nothing more.
  void stop() { stopped_ = true; }

  /// The line sent last, from 1.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// Share of the program sent, 0…1.
  [[nodiscard]] double progress() const;
  /// The first kMostRefusals.
  [[nodiscard]] const std::vector<Refusal>& refusals() const { return refusals_; }
  [[nodiscard]] std::size_t refused() const { return refused_; }
  /// What the controller says to a line of G-code that it takes, by line; the first kMostRefusals.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::string>>& messages() const {
    return messages_;
  }
  [[nodiscard]] std::string_view program() const { return program_; }

  /// What a report lists of a program that is full of faults.
  static constexpr std::size_t kMostRefusals = 1000;

  /// Told of every line that the controller takes, in their order.
  std::function<void(std::size_t line, std::string_view text)> on_taken{};
  /// Told of every line of the controller, without its end.
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
