#pragma once

#include <cstddef>

#include "planner/base/result.hpp"
#include "planner/kerf/kerf_lookup.hpp"

namespace cnc::kerf {

/// Kerf tables of several materials, wherever they are kept. Main loop context.
class KerfSource {
 public:
  [[nodiscard]] virtual std::size_t count() const = 0;
  /// The width of the cut in mm, as kerf_width() has it. A table that is damaged is refused as one
  /// without any speed. @pre index < count()
  [[nodiscard]] virtual Result<float, Refusal> width_mm(std::size_t index,
                                                        const Condition& condition) = 0;

 protected:
  ~KerfSource() = default;
};

}  // namespace cnc::kerf
