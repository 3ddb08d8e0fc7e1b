#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/settings.hpp"
#include "host-sim/job/program_text.hpp"
#include "host-sim/measure/program_line.hpp"
#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// Finds lines that a controller accepts but does not drive as programmed: power above $30, feeds
/// above $110…$115, light at rest under M3, and soft limits on a machine that was not homed.
///
/// take() must be called with each line that the controller accepts, and put() with the pieces of
/// the path, after the line to which they belong. For each kind of fault, the first occurrence of
/// each value is noted, for at most kMaxNotes values.
class ProgramWatch {
 public:
  static constexpr std::size_t kMaxNotes = 100;

  explicit ProgramWatch(const cnc::Settings& settings);

  void take(std::size_t line, std::string_view text);
  void put(const PathPiece& piece);
  /// Ends the program: no more lines follow.
  void end() { go_dark(); }

  /// Returns whether the program requires the light to be on at rest, although the settings do not
  /// allow this.
  [[nodiscard]] bool notes_light_at_rest() const { return notes_light_at_rest_; }
  /// Returns the notes in the order of their lines.
  [[nodiscard]] std::vector<LineNote> notes() const;

 private:
  void take_words(std::size_t line, const ProgramLine& words);
  void take_spindle(std::size_t line, const ProgramLine& words);
  void take_dwell(std::size_t line, const ProgramLine& words);
  void check_power(std::size_t line, double power);
  void check_feed(const PathPiece& piece);
  void go_dark();
  /// Returns whether the program now requires light at rest, although the settings do not allow
  /// this. If the settings allow light within limits, the controller itself reports light that
  /// exceeds the limits.
  [[nodiscard]] bool lit() const { return laser_ && !burns_at_rest_ && constant_ && power_ > 0.0; }
  void note(std::size_t line, std::string text);
  [[nodiscard]] std::string feed_text(const PathPiece& piece, std::size_t axis) const;

  struct Feed {
    std::size_t line = 0;
    double word = 0.0;
  };
  /// Greatest number of lines whose feed is stored. Pieces arrive up to 16 motions after their
  /// lines, and each line has one feed.
  static constexpr std::size_t kMaxPending = 64;

  cnc::AxisArray<double> rates_{};  ///< Greatest rates of the axes, mm/s.
  double max_power_;
  bool laser_;
  bool burns_at_rest_;  ///< True if light at rest is allowed, within $870 and $871.
  bool soft_limits_;
  bool block_delete_;
  double power_ = 0.0;     ///< Last value of S in the program.
  bool constant_ = false;  ///< True if M3 is active.
  /// Line that required light, if no motion has followed it yet; 0 for none.
  std::size_t lit_line_ = 0;
  bool notes_light_at_rest_ = false;
  bool homed_ = false;
  std::deque<Feed> feeds_;  ///< The last kMaxPending words F of the program, with their lines.
  std::vector<double> powers_listed_;
  std::vector<double> feeds_listed_;
  std::vector<LineNote> notes_;
};

}  // namespace sim
