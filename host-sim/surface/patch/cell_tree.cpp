#include "host-sim/surface/patch/cell_tree.hpp"

#include <algorithm>

namespace sim::surface::patch {

CellTree::CellTree(std::size_t rows, std::size_t columns)
    : height_{static_cast<std::uint32_t>(rows - 1)},
      width_{static_cast<std::uint32_t>(columns - 1)},
      cells_{Cell{0, 0, height_, width_, 0}},
      numbers_(std::size_t{height_} * width_, 0) {}

std::vector<std::uint32_t> CellTree::cells_around(std::uint32_t row, std::uint32_t column) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t r = row - std::min(row, 1U); r <= std::min(row, height_ - 1); ++r) {
    for (std::uint32_t c = column - std::min(column, 1U); c <= std::min(column, width_ - 1); ++c) {
      found.push_back(cell_at(r, c));
    }
  }
  return found;
}

void CellTree::split(std::uint32_t number) {
  std::vector<std::uint32_t> wanted{number};
  // Each step divides a cell, or adds a coarser neighbour that must be divided first. The loop
  // ends, because an added neighbour has a smaller depth than the cell.
  while (!wanted.empty()) {
    const std::uint32_t next = wanted.back();
    const std::vector<std::uint32_t> before = coarser_neighbours(cells_[next]);
    if (!before.empty()) {
      wanted.push_back(before.front());
      continue;
    }
    wanted.pop_back();
    divide(next);
  }
}

void CellTree::divide(std::uint32_t number) {
  const Cell whole = cells_[number];
  const std::uint32_t middle_row = whole.row + whole.height() / 2;
  const std::uint32_t middle_column = whole.column + whole.width() / 2;
  bool is_first = true;
  for (const bool below : {false, true}) {
    for (const bool right : {false, true}) {
      const Cell part{below ? middle_row : whole.row,
                      right ? middle_column : whole.column,
                      below ? whole.end_row : middle_row,
                      right ? whole.end_column : middle_column,
                      whole.depth + 1};
      if (part.height() == 0 || part.width() == 0) continue;
      add(part, is_first ? number : static_cast<std::uint32_t>(cells_.size()));
      is_first = false;
    }
  }
}

void CellTree::add(const Cell& cell, std::uint32_t number) {
  if (number == cells_.size()) cells_.emplace_back();
  cells_[number] = cell;
  for (std::uint32_t row = cell.row; row < cell.end_row; ++row) {
    const auto begin = numbers_.begin() + static_cast<std::ptrdiff_t>(std::size_t{row} * width_);
    std::fill(begin + cell.column, begin + cell.end_column, number);
  }
}

std::vector<std::uint32_t> CellTree::coarser_neighbours(const Cell& cell) const {
  std::vector<std::uint32_t> found;
  // A coarser neighbour is next to the complete side of the cell. So it is enough to check one
  // quadrilateral next to each side.
  const auto note = [&](std::uint32_t row, std::uint32_t column) {
    const std::uint32_t number = cell_at(row, column);
    if (cells_[number].depth < cell.depth && cells_[number].can_be_split()) found.push_back(number);
  };
  if (cell.row > 0) note(cell.row - 1, cell.column);
  if (cell.end_row < height_) note(cell.end_row, cell.column);
  if (cell.column > 0) note(cell.row, cell.column - 1);
  if (cell.end_column < width_) note(cell.row, cell.end_column);
  return found;
}

}  // namespace sim::surface::patch
