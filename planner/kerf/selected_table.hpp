#pragma once

#include <cstdint>

#include "planner/kerf/kerf_table.hpp"

namespace cnc::kerf {

/// The kerf table that a program has selected from a list of tables. The owner of the list must
/// prepare the table before the next line is read.
struct SelectedTable {
  std::uint32_t count = 0;  ///< Number of tables in the list.
  std::uint32_t index = 0;
  /// A sound table. It has no rows if the selected table is missing or damaged.
  TableView<float> view{};

  [[nodiscard]] bool holds(std::uint32_t table) const {
    return table == index && !view.rows.empty();
  }
};

}  // namespace cnc::kerf
