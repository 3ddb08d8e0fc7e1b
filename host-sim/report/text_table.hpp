#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// Columns of text that line up on a terminal, whatever the script.
class TextTable {
 public:
  enum class Align { kLeft, kRight };

  struct Column {
    std::string heading;
    Align align = Align::kRight;
  };

  explicit TextTable(std::vector<Column> columns) : columns_{std::move(columns)} {}

  /// One text for each column. @pre cells.size() == number of columns
  void add_row(std::vector<std::string> cells);

  /// Heading and rows, `indent` spaces before each, two spaces between columns,
  /// none at the end of a line. `heading_style` is a terminal sequence such as
  /// "\033[1m", reset at the end of the heading; empty for none.
  [[nodiscard]] std::string text(std::size_t indent = 0, std::string_view heading_style = "") const;

 private:
  [[nodiscard]] std::vector<std::size_t> widths() const;
  [[nodiscard]] std::string line(const std::vector<std::string>& cells,
                                 const std::vector<std::size_t>& widths) const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace sim
