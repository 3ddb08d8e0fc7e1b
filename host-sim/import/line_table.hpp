#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace sim::drawing {

/// Finds the line and the column of a byte of a text, both counted from 1.
class LineTable {
 public:
  explicit LineTable(std::string_view text) {
    for (std::size_t i = text.find('\n'); i != std::string_view::npos; i = text.find('\n', i + 1)) {
      starts_.push_back(i + 1);
    }
  }

  [[nodiscard]] std::pair<std::size_t, std::size_t> at(std::size_t offset) const {
    const auto after = std::ranges::upper_bound(starts_, offset);
    return {static_cast<std::size_t>(after - starts_.begin()), offset - *(after - 1) + 1};
  }

 private:
  std::vector<std::size_t> starts_{0};
};

}  // namespace sim::drawing
