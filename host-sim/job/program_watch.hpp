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

/// Looks for what a controller takes, and drives in another way than the program says: power above
/// $30, feeds above $110…$115, light at rest under M3, soft limits on a machine that was not homed.
///
/// Is given each line that the controller takes, and the pieces of the path, those of a line after
/// the line itself. Of a kind it names the first of each value, and no more than kMostNotes.
class ProgramWatch {
 public:
  static constexpr std::size_t kMostNotes = 100;

  explicit ProgramWatch(const cnc::Settings& settings);

  void take(std::size_t line, std::string_view text);
  void put(const PathPiece& piece);
  /// There are no more lines.
  void end() { go_dark(); }

  /// Whether light at rest was asked for, of which the settings allow none.
  [[nodiscard]] bool notes_light_at_rest() const { return notes_light_at_rest_; }
  /// In the order of their lines.
  [[nodiscard]] std::vector<LineNote> notes() const;

 private:
  void take_words(std::size_t line, const ProgramLine& words);
  void take_spindle(std::size_t line, const ProgramLine& words);
  void take_dwell(std::size_t line, const ProgramLine& words);
  void check_power(std::size_t line, double power);
  void check_feed(const PathPiece& piece);
  void go_dark();
  /// Whether the program means light where nothing moves, of which the settings allow none. Where
  /// they allow some, the controller itself reports light that exceeds them.
  [[nodiscard]] bool lit() const { return laser_ && !burns_at_rest_ && constant_ && power_ > 0.0; }
  void note(std::size_t line, std::string text);
  [[nodiscard]] std::string feed_text(const PathPiece& piece, std::size_t axis) const;

  struct Feed {
    std::size_t line = 0;
    double word = 0.0;
  };
  /// Pieces come up to 16 motions behind their lines; a line has one feed.
  static constexpr std::size_t kMostPending = 64;

  cnc::AxisArray<double> rates_{};  ///< mm/s.
  double most_power_;
  bool laser_;
  bool burns_at_rest_;  ///< Within $870 and $871.
  bool soft_limits_;
  bool block_delete_;
  double power_ = 0.0;        ///< S.
  bool constant_ = false;     ///< M3.
  std::size_t lit_line_ = 0;  ///< Asked for light that has not burnt yet; 0 for none.
  bool notes_light_at_rest_ = false;
  bool homed_ = false;
  std::deque<Feed> feeds_;  ///< The last words F.
  std::vector<double> powers_listed_;
  std::vector<double> feeds_listed_;
  std::vector<LineNote> notes_;
};

}  // namespace sim
