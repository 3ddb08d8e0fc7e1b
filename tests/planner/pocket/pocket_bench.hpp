#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "planner/pocket/clearing.hpp"

namespace cnc::pocket {

/// A pocket with storage for its passes, on the heap, which only tests may use.
class PocketBench {
 public:
  static constexpr std::size_t kElements = 8192;
  static constexpr std::size_t kLoops = 1024;
  static constexpr std::size_t kPassElements = 200'000;

  PocketBench& add(double x, double y, double bulge = 0.0) {
    vertices_.push_back({x, y, bulge});
    return *this;
  }
  PocketBench& close() {
    loop_ends_.push_back(static_cast<std::uint32_t>(vertices_.size()));
    return *this;
  }
  PocketBench& rectangle(double x0, double y0, double x1, double y1) {
    return add(x0, y0).add(x1, y0).add(x1, y1).add(x0, y1).close();
  }
  PocketBench& circle(double x, double y, double radius) {
    return add(x + radius, y, 1.0).add(x - radius, y, 1.0).close();
  }
  PocketBench& round_island(double x, double y, double radius) {
    return add(x + radius, y, -1.0).add(x - radius, y, -1.0).close();
  }
  void forget() {
    vertices_.clear();
    loop_ends_.clear();
  }
  /// Appends the pocket of paper 5.
  PocketBench& paper() {
    const double chord = std::hypot(90.0 - 130.0, 200.0 - 110.0);
    const double half_sweep = std::asin(0.5 * chord / 100.0);
    return add(10, 10)
        .add(130, 10)
        .add(130, 110, -std::tan(0.5 * half_sweep))
        .add(90, 200)
        .add(10, 110)
        .close();
  }

  [[nodiscard]] contour::ContourView<double> pocket() const {
    return {{vertices_.data(), vertices_.size()}, {loop_ends_.data(), loop_ends_.size()}};
  }
  Result<std::uint32_t, ClearingError> clear(const ClearingOptions<double>& options) {
    return clear_pocket<double>(pocket(), options, space_->space(), passes_);
  }
  [[nodiscard]] PassList<double>& passes() { return passes_; }
  [[nodiscard]] ClearingSpace<double> space() { return space_->space(); }

 private:
  using Space = BoundedClearingSpace<double, kElements, 4 * kElements, kLoops>;

  std::vector<contour::Vertex<double>> vertices_;
  std::vector<std::uint32_t> loop_ends_;
  std::unique_ptr<Space> space_ = std::make_unique<Space>();
  std::vector<contour::Vertex<double>> pass_vertices_{kPassElements};
  std::vector<std::uint32_t> pass_loop_ends_ = std::vector<std::uint32_t>(kPassElements / 2);
  std::vector<AreaRange> pass_ranges_{kPassElements / 2};
  std::vector<PassNote<double>> notes_{kPassElements / 2};
  PassList<double> passes_{{{pass_vertices_.data(), pass_vertices_.size()},
                            {pass_loop_ends_.data(), pass_loop_ends_.size()},
                            {pass_ranges_.data(), pass_ranges_.size()}},
                           {notes_.data(), notes_.size()}};
};

}  // namespace cnc::pocket
