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
  kFromStart,  ///< Centres as I, J and K from the arc's start.
  kAbsolute,   ///< Centres as I, J and K in the coordinates of the program.
  kRadius,     ///< Radius as R.
  kLines,      ///< Arcs become lines.
};

enum class CommentForm : std::uint8_t { kBrackets, kSemicolon, kNone };

/// The words of motions that are repeated even if they are equal to those of the line before.
enum class Repeat : std::uint8_t {
  kNothing,
  kMotion,  ///< The word G0, G1, G2 or G3.
  kAll,     ///< G0, G1, G2 or G3; X, Y and Z if their values are known; and F of feeds.
};

/// Line numbers, written as N.
struct LineNumbers {
  std::uint32_t first = 10;
  std::uint32_t step = 10;
  std::uint32_t most = 99'999;  ///< Greatest number. The line after it has the first number again.
};

/// The form of a dwell's time.
struct DwellForm {
  char letter = 'P';
  double per_second = 1.0;  ///< Units of the time per second; 1000 for milliseconds.
};

/// The form in which a controller requires the text of a program. A default Post leaves the text
/// unchanged.
struct Post {
  std::vector<std::string> header{};  ///< Lines before all other lines.
  std::vector<std::string> footer{};  ///< Lines after all other lines.
  /// Lines around each cut: `before_cut` before its first motion that is no rapid, `after_cut`
  /// before the first rapid or M5 after the cut.
  std::vector<std::string> before_cut{};
  std::vector<std::string> after_cut{};
  std::optional<LineNumbers> numbers{};
  std::optional<std::uint8_t> decimals{};         ///< Greatest number of decimals of X, Y and Z.
  std::optional<std::uint8_t> centre_decimals{};  ///< Greatest number of decimals of I, J, K and R.
  bool has_points = false;  ///< Whole numbers of X, Y, Z, I, J, K and R end in a point.
  ArcForm arcs = ArcForm::kFromStart;
  /// Planes in which the controller accepts arcs. In other planes arcs become lines.
  std::array<bool, 3> arc_planes{true, true, true};
  double arc_tolerance_mm = 0.01;  ///< Tolerance of lines that replace arcs.
  CommentForm comments = CommentForm::kBrackets;
  Repeat repeat = Repeat::kNothing;
  bool has_blanks = false;  ///< A blank is written between words.
  std::string line_end = "\n";
  DwellForm dwell{};
  /// Replacements of G and M words and of S, by the word, for example `M8`. Only S may be replaced
  /// by nothing.
  std::map<std::string, std::string> words{};

  /// Returns whether arcs in a plane stay arcs.
  [[nodiscard]] bool knows_arcs(cnc::Plane plane) const {
    return arcs != ArcForm::kLines && arc_planes[static_cast<std::size_t>(plane)];
  }
};

/// Reads a post file. Its sections `[format]` and `[words]` have `KEY = VALUE` on each line. The
/// lines of `[header]`, `[footer]`, `[before-cut]` and `[after-cut]` are written unchanged. In
/// `[format]` and `[words]`, blank lines and lines that begin with `#` are ignored. In `[format]`,
/// so is the rest of a line from ` #` on. Throws std::invalid_argument with `NAME:LINE`, the reason
/// and a remedy.
[[nodiscard]] Post read_post(std::string_view text, const std::string& name);

/// Returns a program of the program makers in the form of a post. Motions change only by the
/// rounding to the post's decimals, with two exceptions. With R, arcs of more than a quarter of a
/// turn are divided. Arcs that the controller does not accept become lines, whose ends are on the
/// arc and which leave it by no more than the tolerance. Words of planes are written before arcs
/// that need them. Throws std::invalid_argument for a line that no program maker writes.
/// @pre the program is in mm and absolute, and centres of arcs are relative to their starts
[[nodiscard]] std::string posted(std::string_view program, const Post& post);

}  // namespace sim::post
