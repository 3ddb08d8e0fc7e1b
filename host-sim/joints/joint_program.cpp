#include "host-sim/joints/joint_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "host-sim/joints/joint_way.hpp"
#include "host-sim/measure/driven_path.hpp"
#include "host-sim/measure/program_reader.hpp"
#include "host-sim/post/program_words.hpp"

namespace sim::joints {
namespace {

using cnc::gcode::Word;

constexpr std::string_view kAxisLetters = "XYZABC";
/// M words that the written program keeps: stops, spindle, coolant and program ends. Their meaning
/// does not depend on G43.4.
constexpr std::array<std::uint32_t, 10> kKeptM{0, 1, 2, 3, 4, 5, 7, 8, 9, 30};
constexpr std::uint32_t kDwellG = 4;

/// A motion of a program. `model` converts tip positions to axis positions. It is empty if the
/// motion is outside of G43.4: its positions are then axis positions.
struct Motion {
  PathPiece piece;
  std::optional<FiveAxisModel> model{};
};

/// The words of a line that do not describe motion.
struct KeptWords {
  std::string before{};  ///< Words for spindle, coolant and dwell, written before the motion.
  std::string after{};   ///< Words for stops and program ends, written after the motion.
  std::string power{};   ///< S word, or empty.
};

bool is_after_motion(std::uint32_t m) { return m <= 2 || m == 30; }

std::string text_of(const Word& word) {
  constexpr int kMaxDecimals = 9;
  return word.letter + post::decimal_text(post::number_of(word), kMaxDecimals, false);
}

/// Returns the words of a line that the written program keeps. Throws std::invalid_argument for an
/// M word that is not in kKeptM, because the target controller may not know it.
KeptWords kept_words(std::string_view line) {
  KeptWords kept;
  const std::vector<Word> words = post::words_in(line);
  const bool dwells = std::ranges::any_of(words, [](const Word& word) {
    return word.letter == 'G' && word.value.whole == kDwellG && word.value.billionths == 0;
  });
  const auto add = [](const Word& word, std::string& text) {
    if (!text.empty()) text += ' ';
    text += text_of(word);
  };
  for (const Word& word : words) {
    if (word.letter == 'S') add(word, kept.power);
    if (dwells && word.letter == 'P') kept.before += (kept.before.empty() ? "G4 " : " G4 ");
    if (dwells && word.letter == 'P') kept.before += text_of(word);
    if (word.letter != 'M') continue;
    if (std::ranges::find(kKeptM, word.value.whole) == kKeptM.end()) {
      throw std::invalid_argument(fmt::format(
          "{} cannot be converted to moves of the axes; remove it from the line", text_of(word)));
    }
    add(word, is_after_motion(word.value.whole) ? kept.after : kept.before);
  }
  return kept;
}

/// Returns the comments of a line, each in brackets.
std::string comments_of(std::string_view line) {
  std::string comments;
  for (std::size_t at = line.find_first_of("(;"); at != std::string_view::npos;
       at = line.find_first_of("(;", at)) {
    const bool is_rest = line[at] == ';';
    const std::size_t end = is_rest ? line.size() : std::min(line.find(')', at), line.size());
    comments += fmt::format("({})\n", line.substr(at + 1, end - at - 1));
    at = std::min(end + 1, line.size());
  }
  return comments;
}

/// Reads a program line by line and writes the equivalent moves of the machine's axes.
class JointWriter {
 public:
  JointWriter(const cnc::Settings& settings, const JointOptions& options)
      : settings_{settings}, options_{options}, reader_{reading_options()} {
    const Point& zero = options.zero;
    reader_.read_line(fmt::format("G10 L2 P1 X{:.6f} Y{:.6f} Z{:.6f}", zero[0], zero[1], zero[2]),
                      0);
    program_.text = "G21 G90 G94\n";
  }
  // Not copyable: the callbacks of the reader refer to this object.
  JointWriter(const JointWriter&) = delete;
  JointWriter& operator=(const JointWriter&) = delete;
  ~JointWriter() = default;

  void take(std::string_view line, int number) {
    motions_.clear();
    reader_.read_line(line, number);
    if (!reader_.path().notes.empty()) {
      throw std::invalid_argument(reader_.path().notes.front().text);
    }
    program_.text += comments_of(line);
    if (line.starts_with('$') || line.starts_with('%')) return;
    const KeptWords kept = kept_words(line);
    add_line(kept.before);
    power_ = kept.power;
    for (const Motion& motion : motions_) write(motion);
    add_line(power_);  // Writes the S word alone if no motion of the line has taken it.
    add_line(kept.after);
  }

  [[nodiscard]] bool ended() const { return reader_.ended(); }

  [[nodiscard]] JointProgram take_program() {
    if (!has_centre_) {
      throw std::invalid_argument(
          "the program has no G43.4: its positions are axis positions already, there is nothing to "
          "convert");
    }
    return std::move(program_);
  }

 private:
  ReadOptions reading_options() {
    ReadOptions options = read_options_for(settings_);
    options.tool_centre = [this](const Point& place, double tool_length_mm, bool begins) {
      const FiveAxisModel model{settings_, tool_length_mm};
      has_centre_ = true;
      if (begins) {
        model_ = model;
        return model.program_for(place);
      }
      model_.reset();
      return model.axes_for(place);
    };
    options.on_piece = [this](const PathPiece& piece) { motions_.push_back({piece, model_}); };
    return options;
  }

  void add_line(const std::string& words) {
    if (!words.empty()) program_.text += words + '\n';
  }

  void write(const Motion& motion) {
    const PathPiece& piece = motion.piece;
    if (piece.travel == Travel::kProbe) {
      throw std::invalid_argument(
          "a probing motion cannot be converted, because its end is not known; remove it");
    }
    const double linear = piece.curve.linear_length();
    const double size = linear > 0.0 ? linear : piece.curve.length();
    if (size == 0.0) return;
    const JointWay way = motion.model
                             ? joint_way(*motion.model, piece.curve, options_.tip_tolerance_mm)
                             : way_of_axes(piece.curve);
    const bool is_feed = piece.travel == Travel::kFeed;
    const double seconds = is_feed ? size / piece.feed : 0.0;
    if (!std::isfinite(seconds)) throw std::invalid_argument("a motion has no feed; add an F word");
    ++program_.figures.motions;
    program_.figures.feed_s += seconds;
    program_.figures.error_mm = std::max(program_.figures.error_mm, way.error_mm);
    if (is_feed) set_feed_mode();
    for (const Point& place : way.ends) {
      write_move(place, is_feed ? seconds / static_cast<double>(way.ends.size()) : 0.0);
    }
  }

  /// Returns the move of a motion outside of G43.4, whose positions are axis positions. Throws
  /// std::invalid_argument for an arc.
  static JointWay way_of_axes(const Curve& curve) {
    if (curve.circle()) {
      throw std::invalid_argument(
          "an arc outside of G43.4 cannot be converted; activate G43.4 before the arc");
    }
    return {.ends = {curve.end()}};
  }

  void set_feed_mode() {
    if (has_inverse_time_) return;
    program_.text += "G93\n";
    has_inverse_time_ = true;
  }

  /// @param seconds duration of the move if it is a feed; 0 for a rapid
  void write_move(const Point& place, double seconds) {
    check_tilt(place);
    grow_bounds(place);
    std::string line;
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      const int decimals = options_.decimals + (axis < cnc::kLinearAxisCount ? 0 : 1);
      std::string word = kAxisLetters[axis] + post::decimal_text(place[axis], decimals, false);
      if (shown_[axis] == word) continue;
      line += ' ' + word;
      shown_[axis] = std::move(word);
    }
    if (seconds > 0.0) waiting_s_ += seconds;
    // The move changes no written digit. waiting_s_ adds its time to the next written move.
    if (line.empty()) return;
    ++program_.figures.moves;
    program_.text += (seconds > 0.0 ? "G1" : "G0") + line;
    if (seconds > 0.0) {
      program_.text += fmt::format(" F{:.7g}", 60.0 / waiting_s_);
      waiting_s_ = 0.0;
    }
    if (!power_.empty()) program_.text += ' ' + power_;
    power_.clear();
    program_.text += '\n';
  }

  void check_tilt(const Point& place) const {
    constexpr double kRoundingDeg = 1.0e-6;
    const double least = settings_.get(cnc::setting::kMinTilt);
    const double most = settings_.get(cnc::setting::kMaxTilt);
    const bool has_a = static_cast<int>(settings_.get(cnc::setting::kRotaryAxes)) % 2 == 1;
    const double tilt = place[has_a ? 3 : 4];
    if (tilt >= least - kRoundingDeg && tilt <= most + kRoundingDeg) return;
    throw std::invalid_argument(
        fmt::format("{}{:.3f} is outside of the machine's range of tilt, {:.3f} to "
                    "{:.3f} degrees ($916, $917)",
                    has_a ? 'A' : 'B',
                    tilt,
                    least,
                    most));
  }

  void grow_bounds(const Point& place) {
    std::optional<Bounds>& bounds = program_.figures.bounds;
    if (!bounds) bounds = Bounds{.low = place, .high = place};
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      bounds->low[axis] = std::min(bounds->low[axis], place[axis]);
      bounds->high[axis] = std::max(bounds->high[axis], place[axis]);
    }
  }

  const cnc::Settings& settings_;
  const JointOptions& options_;
  std::optional<FiveAxisModel> model_{};
  bool has_centre_ = false;
  std::vector<Motion> motions_;  ///< Motions of the line that is being read.
  ProgramReader reader_;
  JointProgram program_;
  std::array<std::string, kAxisLetters.size()> shown_;  ///< Last written word of each axis.
  /// S word of the current line; empty after it is written with a motion.
  std::string power_;
  /// Total time in seconds of the feeds since the last written move that were too short to write.
  double waiting_s_ = 0.0;
  bool has_inverse_time_ = false;
};

}  // namespace

JointProgram joint_program(std::string_view text,
                           const std::string& file,
                           const cnc::Settings& settings,
                           const JointOptions& options) {
  if (!FiveAxisModel{settings, 0.0}.leans()) {
    throw std::invalid_argument(
        "the settings do not describe a five-axis machine; set $900 to $917");
  }
  JointWriter writer{settings, options};
  int number = 0;
  for (std::size_t at = 0; at < text.size() && !writer.ended();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++number;
    try {
      writer.take(line, number);
    } catch (const std::invalid_argument& fault) {
      throw std::invalid_argument(fmt::format("{}:{}: {}", file, number, fault.what()));
    }
    at = end + 1;
  }
  try {
    return writer.take_program();
  } catch (const std::invalid_argument& fault) {
    throw std::invalid_argument(fmt::format("{}: {}", file, fault.what()));
  }
}

}  // namespace sim::joints
