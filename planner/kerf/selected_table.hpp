#pragma once

#include <cstdint>

#include "planner/kerf/kerf_table.hpp"

namespace cnc::kerf {

/// The kerf table that a program has selected, out of a list. Whoever keeps the list has it ready
/// before the next line is read.
struct SelectedTable {
  std::uint32_t count = 0;  ///< Of the list.
  std::uint32_t index = 0;
  TableView<float> view{};  ///< Sound; without rows there is none at hand, or it is damaged.

  [[nodiscard]] bool holds(std::uint32_t table) const {
    return table == index && !view.rows.empty();
  }
};

}  // namespace cnc::kerf
