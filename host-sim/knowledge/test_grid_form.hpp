#pragma once

#include <string>
#include <vector>

#include "host-sim/knowledge/operation_record.hpp"
#include "host-sim/knowledge/test_grid.hpp"

namespace sim {

/// Returns the form of a grid, JSON: a row for each square and each slot, what is to be measured
/// still empty.
[[nodiscard]] std::string form_of(const TestGrid& grid);

/// What a form that was filled in says.
struct MeasuredGrid {
  std::string material{};
  std::vector<OperationRecord> operations{};  ///< A row for each square that is good.
  std::vector<std::string> notes{};           ///< What lacks, or is assumed.
};

/// Who filled in a form, where the form does not say so itself.
struct FormPerson {
  std::string by{};
  std::string on{};  ///< YYYY-MM-DD.
};

/// Reads a form. Squares of result `good` become operations; the kerf is the mean of measured minus
/// path width over the slots, and not known where none was measured. Throws std::invalid_argument
/// `FILE: /pointer: reason; remedy` for what is no such form, numbers out of range, slots whose
/// kerfs differ by more than 0.3 mm, a form without a good square, and one that names neither
/// person nor day.
[[nodiscard]] MeasuredGrid read_form(const std::string& text,
                                     const std::string& file,
                                     const FormPerson& person);

}  // namespace sim
