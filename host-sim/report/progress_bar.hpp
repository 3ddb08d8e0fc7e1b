#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string_view>

namespace sim {

/// A line on the terminal that says how far a long job is. Appears only after
/// half a second, is drawn ten times a second at most, and leaves no trace.
class ProgressBar {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `is_shown`: usually `is_terminal(stream)`; otherwise nothing is ever written.
  /// `columns` of the terminal; without a number the terminal is asked each time, as it may change.
  ProgressBar(std::FILE* stream,
              bool is_shown,
              Time now,
              std::optional<std::size_t> columns = std::nullopt)
      : stream_{stream}, is_shown_{is_shown}, next_{now + kDelay}, columns_{columns} {}
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `fraction` done, 0…1 (clamped); `label` is what is being done. The line is never longer than
  /// the terminal is wide: first the bar, then the label gets shorter.
  void update(double fraction, std::string_view label, Time now);

  /// Removes the bar, before something else is written. It comes back by itself.
  void clear();

 private:
  static constexpr std::chrono::milliseconds kDelay{500};   ///< Short work shows nothing.
  static constexpr std::chrono::milliseconds kPeriod{100};  ///< Faster than anybody reads.

  std::FILE* stream_;
  bool is_shown_;
  bool is_drawn_ = false;
  Time next_;
  std::optional<std::size_t> columns_;
};

[[nodiscard]] bool is_terminal(std::FILE* stream);

}  // namespace sim
