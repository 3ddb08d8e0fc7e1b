#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cnc {

/// Axes of the machine in the order of every array, mask bit and report.
enum class Axis : std::uint8_t { kX, kY, kZ, kA, kB, kC };

inline constexpr std::size_t kAxisCount = 6;
/// Number of the linear axes X Y Z, in mm; A B C are in degrees.
inline constexpr std::size_t kLinearAxisCount = 3;
inline constexpr std::array<char, kAxisCount> kAxisLetters{'X', 'Y', 'Z', 'A', 'B', 'C'};

template <typename Item>
using AxisArray = std::array<Item, kAxisCount>;

[[nodiscard]] constexpr std::size_t index_of(Axis axis) { return static_cast<std::size_t>(axis); }

/// Plane of an arc, selected by G17, G18 or G19 (RS274/NGC 3.5.7).
enum class Plane : std::uint8_t { kXY, kZX, kYZ };

/// First, second and normal axis of a plane, right-handed: as seen against the normal, a
/// counter-clockwise arc (G3) turns from `first` to `second`.
struct PlaneAxes {
  std::size_t first;
  std::size_t second;
  std::size_t normal;
};

[[nodiscard]] constexpr PlaneAxes axes_of(Plane plane) {
  constexpr std::array<PlaneAxes, 3> kAxes{{{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}};
  return kAxes[static_cast<std::size_t>(plane)];
}

}  // namespace cnc
