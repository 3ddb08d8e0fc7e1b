#include "host-sim/report/text_table.hpp"

#include <algorithm>

#include "host-sim/report/printable.hpp"
#include "host-sim/report/utf8.hpp"
#include "planner/base/contract.hpp"

namespace sim {

void TextTable::add_row(std::vector<std::string> cells) {
  CNC_ASSERT(cells.size() == columns_.size());
  for (std::string& cell : cells) cell = printable_line(cell);
  rows_.push_back(std::move(cells));
}

std::string TextTable::text(std::size_t indent, std::string_view heading_style) const {
  const std::vector<std::size_t> column_widths = widths();
  const std::string margin(indent, ' ');
  std::vector<std::string> headings;
  for (const Column& column : columns_) headings.push_back(column.heading);
  const std::string reset = heading_style.empty() ? "" : "\033[0m";
  std::string result = margin + std::string{heading_style};
  result += line(headings, column_widths) + reset + "\n";
  for (const auto& row : rows_) result += margin + line(row, column_widths) + "\n";
  return result;
}

std::vector<std::size_t> TextTable::widths() const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    std::size_t width = display_width(columns_[i].heading);
    for (const auto& row : rows_) width = std::max(width, display_width(row[i]));
    result.push_back(width);
  }
  return result;
}

std::string TextTable::line(const std::vector<std::string>& cells,
                            const std::vector<std::size_t>& widths) const {
  std::string result;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) result += "  ";
    const bool left = columns_[i].align == Align::kLeft;
    result += left ? pad_right(cells[i], widths[i]) : pad_left(cells[i], widths[i]);
  }
  result.erase(result.find_last_not_of(' ') + 1);
  return result;
}

}  // namespace sim
