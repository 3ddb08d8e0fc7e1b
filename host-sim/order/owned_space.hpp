#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "planner/order/storage.hpp"

namespace sim::order {

/// Storage of an algorithm of the planner on the heap, in the size that the algorithm requires. The
/// system provides each page of memory only when it is first used.
template <typename Space>
class OwnedSpace {
 public:
  template <typename Sizes>
  explicit OwnedSpace(const Sizes& sizes) {
    const std::size_t words =
        (cnc::order::bytes_for<Space>(sizes) + sizeof(double) - 1) / sizeof(double);
    // NOLINTNEXTLINE(modernize-avoid-c-arrays): a vector would write to the entire block.
    block_ = std::make_unique_for_overwrite<double[]>(words);
    space_ =
        cnc::order::space_in<Space>(std::as_writable_bytes(std::span{block_.get(), words}), sizes);
  }

  [[nodiscard]] const Space& operator*() const { return space_; }
  [[nodiscard]] const Space* operator->() const { return &space_; }

 private:
  std::unique_ptr<double[]> block_;  // NOLINT(modernize-avoid-c-arrays)
  Space space_;
};

}  // namespace sim::order
