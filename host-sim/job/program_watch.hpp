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

/// Finds lines that a controller takes but drives otherwise than the program says: power above $30,
/// feeds above $110…$115, light at rest under M3, soft limits on a machine that was not homed.
///
/// It gets each line that the controller takes, and the pieces of the path; the pieces of a line
/// come after the line itself. For each kind it notes the first occurrence of each value, and at
/// most kMaxNotes values.
class ProgramWatch {
 public:
  static constexpr std::size_t kMaxNotes = 100;

  explicit ProgramWatch(const cnc::Settings& settings);

  void take(std::size_t line, std::string_view text);
  void put(const PathPiece& piece);
  /// Ends the program: no more lines follow.
  void end() { go_dark(); }

  /// Returns whether the program requires light at rest although the settings allow none.
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
  /// Returns whether the program requires light where nothing moves, although the settings allow
  /// none. If they allow some, the controller itself reports light that exceeds them.
  [[nodiscard]] bool lit() const { return laser_ && !burns_at_rest_ && constant_ && power_ > 0.0; }
  void note(std::size_t line, std::string text);
  [[nodiscard]] std::string feed_text(const PathPiece& piece, std::size_t axis) const;

  struct Feed {
    std::size_t line = 0;
    double word = 0.0;
  };
  /// Greatest number of lines whose feed is kept. Pieces come up to 16 motions after their lines,
  /// and a line has one feed.
  static constexpr std::size_t kMaxPending = 64;

  cnc::AxisArray<double> rates_{};  ///< Greatest rates of the axes, mm/s.
  double max_power_;
  bool laser_;
  bool burns_at_rest_;  ///< Whether light at rest is allowed, within $870 and $871.
  bool soft_limits_;
  bool block_delete_;
  double power_ = 0.0;        ///< S of the program.
  bool constant_ = false;     ///< Whether M3 is on.
  std::size_t lit_line_ = 0;  ///< Line that required light which has not burnt yet; 0 for none.
  bool notes_light_at_rest_ = false;
  bool homed_ = false;
  std::deque<Feed> feeds_;  ///< The latest words F.
  std::vector<double> powers_listed_;
  std::vector<double> feeds_listed_;
  std::vector<LineNote> notes_;
};

}  // namespace sim
