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
  kRadius,     ///< R.
  kLines,      ///< No arcs.
};

enum class CommentForm : std::uint8_t { kBrackets, kSemicolon, kNone };

/// The words of motions that are written although they are as on the line before.
enum class Repeat : std::uint8_t {
  kNothing,
  kMotion,  ///< G0, G1, G2 or G3.
  kAll,     ///< These, X, Y and Z as far as they are known, and F of feeds.
};

/// Numbers of lines, N.
struct LineNumbers {
  std::uint32_t first = 10;
  std::uint32_t step = 10;
  std::uint32_t most = 99'999;  ///< The next line has the first number again.
};

/// How the time of a dwell is written.
struct DwellForm {
  char letter = 'P';
  double per_second = 1.0;  ///< 1000 for milliseconds.
};

/// The form in which a controller wants the text of a program; made without more, the text as it
/// is.
struct Post {
  std::vector<std::string> header{};  ///< Lines before all.
  std::vector<std::string> footer{};  ///< Lines after all.
  /// Lines before the first motion that is no rapid, and before the rapid, or M5, after the last.
  std::vector<std::string> before_cut{};
  std::vector<std::string> after_cut{};
  std::optional<LineNumbers> numbers{};
  std::optional<std::uint8_t> decimals{};         ///< At most, for X, Y and Z.
  std::optional<std::uint8_t> centre_decimals{};  ///< At most, for I, J, K and R.
  bool has_points = false;                        ///< Whole numbers of these end in a point.
  ArcForm arcs = ArcForm::kFromStart;
  /// Planes in which the controller knows arcs; others become lines.
  std::array<bool, 3> arc_planes{true, true, true};
  double arc_tolerance_mm = 0.01;  ///< For lines in place of arcs.
  CommentForm comments = CommentForm::kBrackets;
  Repeat repeat = Repeat::kNothing;
  bool has_blanks = false;  ///< Between words.
  std::string line_end = "\n";
  DwellForm dwell{};
  /// The words in place of G and M words, which are as in `M8`; S alone may be left out.
  std::map<std::string, std::string> words{};

  /// Returns whether all arcs of a plane stay arcs.
  [[nodiscard]] bool knows_arcs(cnc::Plane plane) const {
    return arcs != ArcForm::kLines && arc_planes[static_cast<std::size_t>(plane)];
  }
};

/// Reads a post file: `[format]` and `[words]` with `KEY = VALUE` on each line, `[header]`,
/// `[footer]`, `[before-cut]` and `[after-cut]` with lines that are written as they stand. In the
/// first two, blank lines and those that begin with `#` do not count, nor does what follows a ` #`
/// of `[format]`. Throws std::invalid_argument with `NAME:LINE`, the reason and a remedy.
[[nodiscard]] Post read_post(std::string_view text, const std::string& name);

/// Returns a program of the program makers in the form of a post. Motions stay as they are but for
/// the rounding of the post's decimals: arcs of more than a quarter of a turn are divided for R,
/// and arcs that the controller does not know are lines, whose ends are on the arc and which leave
/// it by no more than the tolerance. Words of planes are written before arcs that need them.
/// Throws std::invalid_argument for a line that no program maker writes.
/// @pre the program is in mm and absolute, and centres of arcs are from their starts
[[nodiscard]] std::string posted(std::string_view program, const Post& post);

}  // namespace sim::post
