#pragma once

#include <string>
#include <vector>

#include "host-sim/knowledge/operation_record.hpp"
#include "host-sim/knowledge/test_grid.hpp"

namespace sim {

/// Returns the form of a grid as JSON: a row for each square and each slot, with empty values that
/// the user fills in.
[[nodiscard]] std::string form_of(const TestGrid& grid);

/// Content of a form that was filled in.
struct MeasuredGrid {
  std::string material{};
  std::vector<OperationRecord> operations{};  ///< One for each square with the result `good`.
  std::vector<std::string> notes{};           ///< Notes on values that are missing or assumed.
};

/// Person and day for a form that does not name them.
struct FormPerson {
  std::string by{};
  std::string on{};  ///< Day of the measurement, YYYY-MM-DD.
};

/// Reads a form. Squares with the result `good` become operations. The kerf is the mean over the
/// slots of the measured width minus the path width, and is not known if no slot was measured.
/// Throws std::invalid_argument `FILE: /pointer: reason; remedy` for: a text that is no such form,
/// numbers out of range, slots whose kerfs differ by more than 0.3 mm, a form without a good
/// square, and a form that names neither person nor day.
[[nodiscard]] MeasuredGrid read_form(const std::string& text,
                                     const std::string& file,
                                     const FormPerson& person);

}  // namespace sim
