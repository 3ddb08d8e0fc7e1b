#pragma once

#include <Eigen/Core>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace sim::surface {

/// Numbers points so that equal points share a number. It is a hash table of point numbers with
/// open addressing that is at most half full.
class PointMerger {
 public:
  PointMerger() : slots_(kFirstSlots, kFree) {}

  /// Returns the number of a point. Adds the point if it is new.
  std::uint32_t number(Eigen::Vector3d point) {
    point.array() += 0.0;  // Gives -0 and 0 the same bits.
    if (2 * points_.size() >= slots_.size()) grow();
    std::size_t slot = hash(point) & (slots_.size() - 1);
    while (slots_[slot] != kFree) {
      if (points_[slots_[slot]] == point) return slots_[slot];
      slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
    return slots_[slot];
  }
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  /// Returns all points in the order of their numbers, and empties the list of points.
  std::vector<Eigen::Vector3d> take_points() { return std::move(points_); }

 private:
  static constexpr std::uint32_t kFree = 0xFFFF'FFFF;
  static constexpr std::size_t kFirstSlots = 1024;  // Initial number of slots, a power of two.

  static std::uint64_t hash(const Eigen::Vector3d& point) {
    // An odd number near 2⁶⁴ divided by the golden ratio.
    constexpr std::uint64_t kOdd = 0x9E37'79B9'7F4A'7C15;
    std::uint64_t mixed = 0;
    for (const double value : {point.x(), point.y(), point.z()}) {
      mixed = (mixed ^ std::bit_cast<std::uint64_t>(value)) * kOdd;
      mixed ^= mixed >> 32U;
    }
    return mixed;
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kFree);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      std::size_t slot = hash(points_[i]) & (slots_.size() - 1);
      while (slots_[slot] != kFree) slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = static_cast<std::uint32_t>(i);
    }
  }

  std::vector<Eigen::Vector3d> points_;
  std::vector<std::uint32_t> slots_;
};

}  // namespace sim::surface
