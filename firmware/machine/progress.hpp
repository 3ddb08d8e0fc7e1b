#pragma once

#include <cstdint>
#include <type_traits>

#include "planner/base/axes.hpp"
#include "planner/motion/block/source_line.hpp"

namespace cnc {

/// Progress of an interrupted program: the position at which the tool worked last, in steps, and
/// the number of the line of this position, or of an earlier line.
struct Progress {
  motion::SourceLine line{};  ///< Noted line; number 0 means that no program was interrupted.
  AxisArray<std::int32_t> steps{};

  [[nodiscard]] bool any() const { return line.number != 0; }
  bool operator==(const Progress&) const = default;
};

/// A Progress in memory that survives a restart. After power-up its content is arbitrary, so it has
/// no constructor.
class KeptProgress {
 public:
  void keep(const Progress& progress);
  /// Returns the kept progress. If the content is not valid, returns an empty Progress.
  [[nodiscard]] Progress progress() const;

 private:
  [[nodiscard]] std::uint32_t check() const;

  std::uint32_t line_;
  AxisArray<std::int32_t> steps_;
  std::uint32_t check_;
};
static_assert(std::is_trivially_default_constructible_v<KeptProgress>);

}  // namespace cnc
