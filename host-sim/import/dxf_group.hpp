#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/place.hpp"

namespace sim::drawing {

/// Two lines of a DXF file: what a value means, and the value.
struct DxfGroup {
  int code = 0;
  std::string_view value;  ///< Without blanks around it.
  std::size_t line = 0;    ///< Of the value, from 1.
  std::string_view raw;    ///< The value with blanks around it.
};

/// Reads group after group. A copy remembers the place.
class DxfCursor {
 public:
  explicit DxfCursor(std::string_view text) : rest_{text} {}

  /// Nothing at the end of the text, and where a code is no number.
  std::optional<DxfGroup> next();

  [[nodiscard]] std::size_t line() const { return line_; }
  /// The code that was no number; empty at the end of the text.
  [[nodiscard]] std::string_view bad_code() const { return bad_code_; }

 private:
  std::string_view take_line();  ///< With blanks around it, without its end.

  std::string_view rest_;
  std::string_view bad_code_;
  std::size_t line_ = 0;
};

/// Everything from one group 0 to the next. Numbers that are none are remembered.
class DxfEntity {
 public:
  std::string_view type;
  std::size_t line = 0;
  std::vector<DxfGroup> groups;

  [[nodiscard]] std::string_view text(int code) const;
  [[nodiscard]] std::optional<double> number(int code) const;
  [[nodiscard]] double number(int code, double otherwise) const;
  /// Rounded towards 0, and between ±10⁹.
  [[nodiscard]] int whole(int code, int otherwise) const;
  /// `code` and `code` + 10.
  [[nodiscard]] Place place(int code) const;
  [[nodiscard]] std::vector<double> numbers(int code) const;
  [[nodiscard]] std::vector<Place> places(int code) const;

  /// Leaves out the subclass of this name, and all that follows it.
  void drop_part(std::string_view subclass);

  /// A coordinate, length, angle or flag that is no finite number; the first.
  [[nodiscard]] const DxfGroup* bad_number() const;
};

/// A finite number and nothing else.
[[nodiscard]] std::optional<double> dxf_number(std::string_view value);

}  // namespace sim::drawing
