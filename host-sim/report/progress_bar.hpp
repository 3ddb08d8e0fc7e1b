#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <string_view>

namespace sim {

/// A line on the terminal that shows the progress of a long job. It appears only after half a
/// second, is drawn at most ten times a second, and is removed at the end.
class ProgressBar {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// Prepares a bar, which is not shown yet.
  /// @param is_shown usually `is_terminal(stream)`; if false, nothing is ever written
  /// @param columns width of the terminal; if empty, the terminal is queried at each update, as its
  ///   width may change
  ProgressBar(std::FILE* stream,
              bool is_shown,
              Time now,
              std::optional<std::size_t> columns = std::nullopt)
      : stream_{stream}, is_shown_{is_shown}, next_{now + kDelay}, columns_{columns} {}
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Draws the bar. The line is never longer than the terminal is wide: first the bar, then the
  /// label gets shorter.
  /// @param fraction share done, 0…1 (clamped)
  /// @param label the work in progress
  void update(double fraction, std::string_view label, Time now);

  /// Removes the bar, before other text is written. The next update() draws it again.
  void clear();

 private:
  /// Work shorter than this shows nothing.
  static constexpr std::chrono::milliseconds kDelay{500};
  static constexpr std::chrono::milliseconds kPeriod{100};  ///< People cannot read faster updates.

  std::FILE* stream_;
  bool is_shown_;
  bool is_drawn_ = false;
  Time next_;
  std::optional<std::size_t> columns_;
};

[[nodiscard]] bool is_terminal(std::FILE* stream);

}  // namespace sim
