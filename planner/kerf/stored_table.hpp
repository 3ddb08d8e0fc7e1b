#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "planner/kerf/kerf_table.hpp"

namespace cnc::kerf {

/// Memory for one table on the controller.
class StoredTable {
 public:
  static constexpr std::size_t kMaxRows = 8;
  /// Capacity for bands: five powers for each thickness.
  static constexpr std::size_t kMaxBands = 40;
  /// Capacity for points, which only rows without a law have.
  static constexpr std::size_t kMaxPoints = 48;

  [[nodiscard]] TableView<float> view() const {
    return {{name_.data(), name_size_},
            unit,
            {rows_.data(), row_count_},
            {bands_.data(), band_count_},
            {points_.data(), point_count_}};
  }

  /// Returns memory for `count` items, which the caller must fill. @pre `count` is within the
  /// capacity
  [[nodiscard]] std::span<Row<float>> make_rows(std::size_t count) {
    row_count_ = std::min(count, kMaxRows);
    return {rows_.data(), row_count_};
  }
  [[nodiscard]] std::span<Band> make_bands(std::size_t count) {
    band_count_ = std::min(count, kMaxBands);
    return {bands_.data(), band_count_};
  }
  [[nodiscard]] std::span<Point> make_points(std::size_t count) {
    point_count_ = std::min(count, kMaxPoints);
    return {points_.data(), point_count_};
  }
  /// Sets the name, cut off at kLongestName characters.
  void set_name(std::string_view name) {
    name_size_ = std::min(name.size(), name_.size());
    std::copy_n(name.begin(), name_size_, name_.begin());
  }

  HeatUnit unit = HeatUnit::kWattMinutesPerMillimetre;

 private:
  std::array<char, kLongestName> name_{};
  std::size_t name_size_ = 0;
  std::array<Row<float>, kMaxRows> rows_{};
  std::size_t row_count_ = 0;
  std::array<Band, kMaxBands> bands_{};
  std::size_t band_count_ = 0;
  std::array<Point, kMaxPoints> points_{};
  std::size_t point_count_ = 0;
};

}  // namespace cnc::kerf
