#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/place.hpp"

namespace sim::drawing {

/// A group of a DXF file. It consists of two lines: a code, which gives the meaning of the value,
/// and the value.
struct DxfGroup {
  int code = 0;
  std::string_view value;  ///< Value, without the blanks around it.
  std::size_t line = 0;    ///< Number of the line of the value, from 1.
  std::string_view raw;    ///< Value, with the blanks around it.
};

/// Reads the groups of a text one by one. A copy of the cursor continues from the same position in
/// the text.
class DxfCursor {
 public:
  explicit DxfCursor(std::string_view text) : rest_{text} {}

  /// Returns the next group; nothing at the end of the text, or if the code is no number.
  std::optional<DxfGroup> next();

  [[nodiscard]] std::size_t line() const { return line_; }
  /// Returns the code that is no number, at which next() ended; empty if next() ended at the end of
  /// the text.
  [[nodiscard]] std::string_view bad_code() const { return bad_code_; }

 private:
  /// Returns the next line, including the blanks around its text, without the line end.
  std::string_view take_line();

  std::string_view rest_;
  std::string_view bad_code_;
  std::size_t line_ = 0;
};

/// An entity of a DXF file: its groups, from one group 0 to the next. Values that should be numbers
/// but are none are stored, too, and bad_number() returns the first of them.
class DxfEntity {
 public:
  std::string_view type;
  std::size_t line = 0;
  std::vector<DxfGroup> groups;

  [[nodiscard]] std::string_view text(int code) const;
  [[nodiscard]] std::optional<double> number(int code) const;
  [[nodiscard]] double number(int code, double otherwise) const;
  /// Returns the value of a code, rounded towards 0 and limited to ±10⁹; `otherwise` if the entity
  /// has no such code.
  [[nodiscard]] int whole(int code, int otherwise) const;
  /// Returns the point whose coordinates have the codes `code` and `code` + 10.
  [[nodiscard]] Place place(int code) const;
  [[nodiscard]] std::vector<double> numbers(int code) const;
  [[nodiscard]] std::vector<Place> places(int code) const;

  /// Removes the groups of the subclass with this name, and all later groups.
  void drop_part(std::string_view subclass);

  /// Returns the first group whose value should be a coordinate, length, angle or flag but is no
  /// finite number; null if there is none.
  [[nodiscard]] const DxfGroup* bad_number() const;
};

/// Returns the number in a value; nothing if the value contains anything else, or if the number is
/// not finite.
[[nodiscard]] std::optional<double> dxf_number(std::string_view value);

}  // namespace sim::drawing
