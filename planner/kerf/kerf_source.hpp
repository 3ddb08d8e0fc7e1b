#pragma once

#include <cstddef>

#include "planner/base/result.hpp"
#include "planner/kerf/kerf_lookup.hpp"

namespace cnc::kerf {

/// Kerf tables of several materials, wherever they are kept. Main loop context.
class KerfSource {
 public:
  [[nodiscard]] virtual std::size_t count() const = 0;
  /// One of them, until the next call of any member; one that is damaged is refused as a table
  /// without any speed. @pre index < count()
  [[nodiscard]] virtual Result<TableView<float>, Refusal> view(std::size_t index) = 0;

 protected:
  ~KerfSource() = default;
};

}  // namespace cnc::kerf
