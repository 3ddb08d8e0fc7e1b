#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// A table whose columns are aligned on a terminal, in any script.
class TextTable {
 public:
  enum class Align { kLeft, kRight };

  struct Column {
    std::string heading;
    Align align = Align::kRight;
  };

  explicit TextTable(std::vector<Column> columns) : columns_{std::move(columns)} {}

  /// Adds a row with one text for each column.
  /// @pre cells.size() == number of columns
  void add_row(std::vector<std::string> cells);

  /// Returns the heading and the rows, with two spaces between columns and none at the end of a
  /// line.
  /// @param indent number of spaces before each line
  /// @param heading_style a terminal sequence such as "\033[1m", reset at the end of the heading;
  /// empty for plain text
  [[nodiscard]] std::string text(std::size_t indent = 0, std::string_view heading_style = "") const;

 private:
  [[nodiscard]] std::vector<std::size_t> widths() const;
  [[nodiscard]] std::string line(const std::vector<std::string>& cells,
                                 const std::vector<std::size_t>& widths) const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace sim
