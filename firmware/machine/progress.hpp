#pragma once

#include <cstdint>
#include <type_traits>

#include "planner/base/axes.hpp"
#include "planner/motion/block/source_line.hpp"

namespace cnc {

/// How far a program had come when it was interrupted: the line that was driven, or one
/// before it, and where the motors were while the tool worked last, in steps of the machine.
struct Progress {
  motion::SourceLine line{};  ///< Number 0: of no program.
  AxisArray<std::int32_t> steps{};

  [[nodiscard]] bool any() const { return line.number != 0; }
  bool operator==(const Progress&) const = default;
};

/// The same in memory that a restart leaves alone, where anything may stand after power-up: so it
/// has no constructor.
class KeptProgress {
 public:
  void keep(const Progress& progress);
  /// None where what stands here was not kept.
  [[nodiscard]] Progress progress() const;

 private:
  [[nodiscard]] std::uint32_t check() const;

  std::uint32_t line_;
  AxisArray<std::int32_t> steps_;
  std::uint32_t check_;
};
static_assert(std::is_trivially_default_constructible_v<KeptProgress>);

}  // namespace cnc
