#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/motion/motors/shaper_grid.hpp"
#include "planner/motion/segment/planned_slice.hpp"
#include "planner/motion/segment/segment_rate.hpp"

namespace cnc::motion {

/// The beam or spindle output over a part of a cell, and the outputs at its start.
struct OutputPiece {
  std::uint16_t ticks = 0;
  std::uint16_t start = 0;  ///< Duty, 65535 is full.
  std::uint16_t end = 0;
  OutputChanges outputs{};

  [[nodiscard]] bool constant() const { return start == end; }
};

/// What the outputs are to do, from when it is planned until the shaped motion comes
/// there: a queue of pieces, cell by cell.
///
/// Boundaries between pieces keep their tick. What goes on evenly is one piece. Where pieces come
/// so fast that a queue of segments would not last, or more than there is room for (blocks of a few
/// µm at full speed under M4, for long), those of one cell become one with the same energy; for
/// want of room, outputs change with it.
class OutputDelay {
 public:
  static constexpr std::size_t kMostPieces = 384;

  /// Forgets everything.
  /// @param cells_held between what is planned and what goes out, at most kMostPlaces
  void clear(std::uint32_t cells_held);

  /// The output goes on until `end_tick` of the cell being filled.
  void add(const PlannedSlice& slice, std::uint32_t end_tick);
  /// It stays at `duty` until there.
  void hold(float duty, std::uint32_t end_tick) {
    add({.start_duty = duty, .end_duty = duty}, end_tick);
  }
  /// @pre add() has come to the end of the cell
  void close_cell();

  /// The oldest piece. @pre there is a whole cell
  [[nodiscard]] OutputPiece take();

 private:
  [[nodiscard]] std::size_t newest() const { return (oldest_ + count_ - 1) % kMostPieces; }
  void append(const OutputPiece& piece);
  [[nodiscard]] bool joins(const OutputPiece& piece) const;
  void join(const OutputPiece& piece);

  std::array<OutputPiece, kMostPieces> pieces_{};
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::size_t in_cell_ = 0;        ///< Of the cell being filled.
  std::size_t most_joinable_ = 0;  ///< With more, pieces of a cell are joined whatever they are.
  std::uint32_t tick_ = 0;         ///< How far it is filled.
  OutputChanges pending_{};        ///< Of slices shorter than a tick.
  SegmentRate rate_{};
};

static_assert(2 * ShaperGrid::kMostPlaces <= OutputDelay::kMostPieces,
              "each cell on the way has room for a piece, and as many again");

}  // namespace cnc::motion
