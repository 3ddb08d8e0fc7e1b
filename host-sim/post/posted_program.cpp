#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "host-sim/post/arc_division.hpp"
#include "host-sim/post/post.hpp"
#include "host-sim/post/program_words.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::post {
namespace {

using cnc::Plane;
using cnc::gcode::Word;
using Eigen::Index;
using Eigen::Vector3d;

constexpr std::string_view kAxisLetters = "XYZ";
constexpr std::string_view kCentreLetters = "IJK";
constexpr int kMaxWordDecimals = 9;
// The word of the first plane, G17. G18 and G19 follow in the order of cnc::Plane.
constexpr int kFirstPlaneWord = 17;
constexpr int kLineMotion = 1;
constexpr int kClockwiseMotion = 2;
constexpr int kDwell = 4;

/// The words of one line, sorted by their meaning.
struct SortedLine {
  std::vector<std::string> codes;   ///< The G and M words of the line, except words of motions.
  std::vector<std::string> values;  ///< The words S, P, D and Q of the line.
  std::array<std::optional<double>, 3> axes{};
  std::array<double, 3> centre{};  ///< Centre of an arc, relative to its start.
  std::optional<std::string> feed{};

  [[nodiscard]] bool moves() const {
    return std::ranges::any_of(axes, [](const auto& axis) { return axis.has_value(); });
  }
};

/// Writes the lines of a program, one after the other, in the form of a post.
class PostWriter {
 public:
  explicit PostWriter(const Post& post) : post_{post} {}

  void write(std::string_view line) {
    if (line.empty()) return;
    if (line.front() == '(') return write_comment(line);
    const SortedLine sorted = sort(words_in(line));
    mark_cut(sorted);
    if (sorted.moves()) {
      write_motion(sorted);
    } else {
      std::vector<std::string> texts = sorted.codes;
      texts.insert(texts.end(), sorted.values.begin(), sorted.values.end());
      if (sorted.feed) texts.push_back(*sorted.feed);
      add_line(texts);
    }
  }

  void add_raw(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) text_ += line + post_.line_end;
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  /// Writes `before_cut` of the post before the first motion of a cut, and `after_cut` after the
  /// last one.
  void mark_cut(const SortedLine& line) {
    const bool is_stop = std::ranges::find(line.codes, replaced("M5")) != line.codes.end();
    const bool is_cut = line.moves() ? motion_ != 0 : in_cut_ && !is_stop;
    if (is_cut == in_cut_) return;
    in_cut_ = is_cut;
    add_raw(is_cut ? post_.before_cut : post_.after_cut);
  }

  void write_comment(std::string_view line) {
    if (post_.comments == CommentForm::kNone) return;
    std::string text{line};
    if (post_.comments == CommentForm::kSemicolon) {
      text = fmt::format("; {}", line.substr(1, line.find(')') - 1));
    }
    text_ += text + post_.line_end;
  }

  /// Adds a line of words, with its line number. Adds nothing if the post leaves out all words of
  /// the line.
  void add_line(const std::vector<std::string>& texts) {
    std::vector<std::string_view> words;
    for (const std::string& text : texts) {
      if (!text.empty()) words.push_back(text);
    }
    if (words.empty()) return;
    const std::string_view blank = post_.has_blanks ? " " : "";
    if (post_.numbers) text_ += fmt::format("N{}{}", next_number(), blank);
    text_ += fmt::format("{}{}", fmt::join(words, blank), post_.line_end);
  }

  std::uint32_t next_number() {
    const LineNumbers& numbers = *post_.numbers;
    const std::uint64_t next = number_ ? std::uint64_t{*number_} + numbers.step : numbers.first;
    number_ = next <= numbers.most ? static_cast<std::uint32_t>(next) : numbers.first;
    return *number_;
  }

  /// Returns the text that the post writes for a G or M word, or for S.
  [[nodiscard]] std::string replaced(const std::string& word) const {
    const auto found = post_.words.find(word);
    return found == post_.words.end() ? word : found->second;
  }

  SortedLine sort(const std::vector<Word>& words) {
    SortedLine line;
    const bool dwells = std::ranges::any_of(
        words, [](const Word& word) { return word.letter == 'G' && word.value.whole == kDwell; });
    for (const Word& word : words) {
      if (const std::size_t axis = kAxisLetters.find(word.letter); axis < kAxisLetters.size()) {
        line.axes[axis] = rounded(number_of(word));
      } else if (const std::size_t i = kCentreLetters.find(word.letter);
                 i < kCentreLetters.size()) {
        line.centre[i] = number_of(word);
      } else if (word.letter == 'F') {
        line.feed = text_of(word);
      } else if (word.letter == 'G' || word.letter == 'M') {
        sort_code(word, line);
      } else if (dwells && word.letter == 'P') {
        const double time = number_of(word) * post_.dwell.per_second;
        line.values.push_back(post_.dwell.letter + decimal_text(time, kMaxWordDecimals, false));
      } else if (word.letter != 'S' || !replaced("S").empty()) {
        line.values.push_back(text_of(word));
      }
    }
    return line;
  }

  void sort_code(const Word& word, SortedLine& line) {
    const std::string name = text_of(word);
    if (std::ranges::find(kProgramWords, name) == kProgramWords.end()) {
      throw std::invalid_argument(fmt::format("a post cannot write the word {}", name));
    }
    const auto number = static_cast<int>(word.value.whole);
    if (word.letter == 'G' && number <= 3) {
      motion_ = number;
    } else if (word.letter == 'G' && number >= kFirstPlaneWord && number < kFirstPlaneWord + 3) {
      plane_ = static_cast<Plane>(number - kFirstPlaneWord);
      if (written_plane_) return;  // Written when an arc, G41 or G42 requires the plane.
      written_plane_ = plane_;
      line.codes.push_back(replaced(name));
    } else {
      if (name == "G41" || name == "G42") write_plane();
      line.codes.push_back(replaced(name));
    }
  }

  static std::string text_of(const Word& word) {
    return word.letter + decimal_text(number_of(word), kMaxWordDecimals, false);
  }

  [[nodiscard]] double rounded(double value) const {
    if (!post_.decimals) return value;
    const double scale = std::pow(10.0, *post_.decimals);
    return std::round(value * scale) / scale;
  }

  void write_plane() {
    if (written_plane_ == plane_) return;
    written_plane_ = plane_;
    add_line({replaced(fmt::format("G{}", kFirstPlaneWord + static_cast<int>(plane_)))});
  }

  void write_motion(const SortedLine& line) {
    if (motion_ < kClockwiseMotion) {
      write_element(line, motion_, {});
      return;
    }
    ProgramArc arc{.plane = plane_, .is_clockwise = motion_ == kClockwiseMotion};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<Index>(i);
      arc.from[axis] = place_[i].value_or(0.0);
      arc.to[axis] = line.axes[i].value_or(arc.from[axis]);
      arc.centre[axis] = arc.from[axis] + line.centre[i];
    }
    if (!post_.knows_arcs(plane_)) {
      write_parts(line, arc, chords_within(arc, post_.arc_tolerance_mm), kLineMotion);
    } else if (post_.arcs == ArcForm::kRadius) {
      constexpr double kQuarter = 0.5 * std::numbers::pi;
      write_plane();
      write_parts(line, arc, static_cast<int>(std::ceil(arc.sweep() / kQuarter - 1.0e-9)), motion_);
    } else {
      write_plane();
      write_element(line, motion_, centre_words(arc));
    }
  }

  [[nodiscard]] std::string arc_word(char letter, double value) const {
    const int places = post_.decimals ? *post_.decimals + 1 : kMaxWordDecimals;
    return letter + decimal_text(value, post_.centre_decimals.value_or(places), post_.has_points);
  }

  [[nodiscard]] std::vector<std::string> centre_words(const ProgramArc& arc) const {
    const cnc::PlaneAxes axes = cnc::axes_of(arc.plane);
    std::vector<std::string> words;
    for (const std::size_t i : {axes.first, axes.second}) {
      const auto axis = static_cast<Index>(i);
      const bool is_absolute = post_.arcs == ArcForm::kAbsolute;
      const double value = is_absolute ? arc.centre[axis] : arc.centre[axis] - arc.from[axis];
      words.push_back(arc_word(kCentreLetters[i], value));
    }
    return words;
  }

  /// Writes an arc in `parts` parts: as smaller arcs with a radius, or as lines.
  void write_parts(const SortedLine& line, const ProgramArc& arc, int parts, int motion) {
    constexpr int kDigitsOfParts = 4;  // Number of decimals if the post gives none.
    const double scale = std::pow(10.0, post_.decimals.value_or(kDigitsOfParts));
    SortedLine part = line;
    for (const Vector3d& point : divided(arc, parts)) {
      for (std::size_t i = 0; i < 3; ++i) {
        part.axes[i].reset();
        const double value = std::round(point[static_cast<Index>(i)] * scale) / scale;
        const bool is_last = point == arc.to;
        if (value == place_[i] && !(is_last && line.axes[i])) continue;
        part.axes[i] = is_last && line.axes[i] ? *line.axes[i] : value;
      }
      std::vector<std::string> radius;
      if (motion != kLineMotion) radius.push_back(arc_word('R', arc.radius()));
      write_element(part, motion, radius);
      part = {};
    }
  }

  /// Writes one motion. An axis has a word if `line` gives its value, or if the post repeats all
  /// words.
  void write_element(const SortedLine& line, int motion, const std::vector<std::string>& arc) {
    std::vector<std::string> words = line.codes;
    if (motion != written_motion_ || post_.repeat != Repeat::kNothing) {
      words.push_back(replaced(fmt::format("G{}", motion)));
    }
    written_motion_ = motion;
    for (std::size_t i = 0; i < 3; ++i) {
      if (line.axes[i]) place_[i] = line.axes[i];
      if (!place_[i] || (!line.axes[i] && post_.repeat != Repeat::kAll)) continue;
      const int places = post_.decimals.value_or(kMaxWordDecimals);
      words.push_back(kAxisLetters[i] + decimal_text(*place_[i], places, post_.has_points));
    }
    words.insert(words.end(), arc.begin(), arc.end());
    if (line.feed) feed_ = *line.feed;
    const bool repeats_feed = post_.repeat == Repeat::kAll && motion != 0 && !feed_.empty();
    if (line.feed || repeats_feed) words.push_back(feed_);
    words.insert(words.end(), line.values.begin(), line.values.end());
    add_line(words);
  }

  const Post& post_;
  std::string text_;
  std::optional<std::uint32_t> number_;  ///< Number of the last numbered line.
  /// Whether a cut has begun and has not ended; see mark_cut().
  bool in_cut_ = false;
  int motion_ = 0;
  int written_motion_ = -1;
  Plane plane_ = Plane::kXY;
  std::optional<Plane> written_plane_;
  std::array<std::optional<double>, 3> place_{};
  std::string feed_;  ///< The last feed as a word, such as `F1200`.
};

}  // namespace

std::string posted(std::string_view program, const Post& post) {
  PostWriter writer{post};
  writer.add_raw(post.header);
  surface::TextLines lines{program};
  while (const std::optional<std::string_view> line = lines.next()) writer.write(*line);
  writer.add_raw(post.footer);
  return writer.text();
}

}  // namespace sim::post
