#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "planner/base/axes.hpp"

namespace sim::post {

enum class ArcForm : std::uint8_t {
  kFromStart,  ///< Centres as I, J and K relative to the arc's start.
  /// Centres as I, J and K in the coordinates of the program, not relative to the arc.
  kAbsolute,
  kRadius,  ///< No centres: the radius as R.
  kLines,   ///< No arcs: lines replace them.
};

enum class CommentForm : std::uint8_t { kBrackets, kSemicolon, kNone };

/// The words that each motion has, even if the previous motion had the same words with the same
/// values.
enum class Repeat : std::uint8_t {
  kNothing,
  kMotion,  ///< Only the word G0, G1, G2 or G3.
  /// G0, G1, G2 or G3; X, Y and Z once their values are known; and F of motions that are no rapids.
  kAll,
};

/// Line numbers, which are written as words N.
struct LineNumbers {
  std::uint32_t first = 10;
  std::uint32_t step = 10;
  std::uint32_t most = 99'999;  ///< Greatest number. The next line has number `first` again.
};

/// The form in which the time of a dwell is written.
struct DwellForm {
  char letter = 'P';
  /// Number of units of time in a second: 1000 if times are in milliseconds.
  double per_second = 1.0;
};

/// The form in which a controller requires the text of a program. A default Post leaves programs
/// unchanged.
struct Post {
  std::vector<std::string> header{};  ///< Lines that come before the program.
  std::vector<std::string> footer{};  ///< Lines that come after the program.
  /// Lines around each cut. `before_cut` comes before the first motion of the cut that is no rapid.
  /// `after_cut` comes before the first rapid or M5 after the cut.
  std::vector<std::string> before_cut{};
  std::vector<std::string> after_cut{};
  std::optional<LineNumbers> numbers{};
  std::optional<std::uint8_t> decimals{};         ///< Greatest number of decimals of X, Y and Z.
  std::optional<std::uint8_t> centre_decimals{};  ///< Greatest number of decimals of I, J, K and R.
  bool has_points = false;  ///< Whether whole numbers of X, Y, Z, I, J, K and R end in a point.
  ArcForm arcs = ArcForm::kFromStart;
  /// Planes in which the controller accepts arcs. In other planes arcs become lines.
  std::array<bool, 3> arc_planes{true, true, true};
  double arc_tolerance_mm = 0.01;  ///< Greatest deviation of the lines that replace an arc.
  CommentForm comments = CommentForm::kBrackets;
  Repeat repeat = Repeat::kNothing;
  bool has_blanks = false;  ///< Whether words are separated by a blank.
  std::string line_end = "\n";
  DwellForm dwell{};
  /// Replacements of words, keyed by the word to replace: G and M words, for example `M8`, and S.
  /// An empty text leaves the word out. S can only be left out.
  std::map<std::string, std::string> words{};

  /// Returns whether arcs in a plane are written as arcs.
  [[nodiscard]] bool knows_arcs(cnc::Plane plane) const {
    return arcs != ArcForm::kLines && arc_planes[static_cast<std::size_t>(plane)];
  }
};

/// Reads a post file. Its sections `[format]` and `[words]` have `KEY = VALUE` on each line. The
/// lines of `[header]`, `[footer]`, `[before-cut]` and `[after-cut]` are written unchanged. In
/// `[format]` and `[words]`, blank lines and lines that begin with `#` are ignored. In `[format]`,
/// the end of a line that begins with ` #` is ignored, too. Throws std::invalid_argument with
/// `NAME:LINE`, the reason and a remedy.
[[nodiscard]] Post read_post(std::string_view text, const std::string& name);

/// Returns `program` in the form of a post. Motions change only by the rounding to the post's
/// decimals, with two exceptions. With ArcForm::kRadius, arcs of more than a quarter of a turn are
/// divided. Arcs that the controller does not accept become lines, whose ends are on the arc and
/// which deviate from it by at most the tolerance. A word G17, G18 or G19 that changes the plane is
/// delayed until an arc, G41 or G42 requires it. Throws std::invalid_argument for a line that no
/// program maker writes.
/// @pre the program is in mm and absolute, and centres of arcs are relative to their starts
[[nodiscard]] std::string posted(std::string_view program, const Post& post);

}  // namespace sim::post
