#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string_view>

namespace sim {

/// A line on the terminal that shows the progress of a long job. It appears after half a second, is
/// drawn at most ten times per second, and is removed at the end.
class ProgressBar {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// Prepares a bar, which is not yet shown.
  /// @param is_shown usually `is_terminal(stream)`; if false, nothing is ever written
  /// @param columns width of the terminal; if empty, each update queries the terminal, because its
  /// width may change
  ProgressBar(std::FILE* stream,
              bool is_shown,
              Time now,
              std::optional<std::size_t> columns = std::nullopt)
      : stream_{stream}, is_shown_{is_shown}, next_{now + kDelay}, columns_{columns} {}
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Draws the bar. The line is never longer than the width of the terminal: on a narrow terminal,
  /// first the bar gets shorter, then the label.
  /// @param fraction share of the job that is done, 0…1 (clamped)
  /// @param label text that names the work in progress
  void update(double fraction, std::string_view label, Time now);

  /// Removes the bar. Call it before other text is written. The next update() draws the bar again.
  void clear();

 private:
  /// Time before the bar appears. Shorter jobs show no bar.
  static constexpr std::chrono::milliseconds kDelay{500};
  /// Time between two updates. Users cannot read faster updates.
  static constexpr std::chrono::milliseconds kPeriod{100};

  std::FILE* stream_;
  bool is_shown_;
  bool is_drawn_ = false;
  Time next_;
  std::optional<std::size_t> columns_;
};

[[nodiscard]] bool is_terminal(std::FILE* stream);

}  // namespace sim
