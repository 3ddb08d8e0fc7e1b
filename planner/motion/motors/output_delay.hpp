#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/motion/motors/shaper_grid.hpp"
#include "planner/motion/segment/planned_slice.hpp"
#include "planner/motion/segment/segment_rate.hpp"

namespace cnc::motion {

/// The beam or spindle output over a part of a cell, and the output changes at its start.
struct OutputPiece {
  std::uint16_t ticks = 0;
  std::uint16_t start = 0;  ///< Duty at the start, 65535 is full.
  std::uint16_t end = 0;
  OutputChanges outputs{};

  [[nodiscard]] bool constant() const { return start == end; }
};

/// Delays the outputs until the shaped motion reaches the position for which they were planned. It
/// is a queue of pieces, cell by cell.
///
/// Boundaries between pieces keep their tick. An output that stays constant is one piece. Pieces of
/// a cell become one piece with the same energy where they come so fast that a queue of segments
/// would not last, or where the queue here is full. (That takes blocks of a few µm at full speed
/// under M4, for long.) Where the queue is full, output changes move to the start of the joined
/// piece, too.
class OutputDelay {
 public:
  static constexpr std::size_t kMaxPieces = 384;

  /// Forgets all pieces.
  /// @param cells_held number of cells from planning to output, at most kMaxPlaces
  void clear(std::uint32_t cells_held);

  /// Adds the output of a slice, up to `end_tick` of the cell being filled.
  void add(const PlannedSlice& slice, std::uint32_t end_tick);
  /// Keeps the output at `duty` up to `end_tick`.
  void hold(float duty, std::uint32_t end_tick) {
    add({.start_duty = duty, .end_duty = duty}, end_tick);
  }
  /// Closes the cell being filled. @pre add() has come to the end of the cell
  void close_cell();

  /// Takes the oldest piece. @pre there is a whole cell
  [[nodiscard]] OutputPiece take();

 private:
  [[nodiscard]] std::size_t newest() const { return (oldest_ + count_ - 1) % kMaxPieces; }
  void append(const OutputPiece& piece);
  [[nodiscard]] bool joins(const OutputPiece& piece) const;
  void join(const OutputPiece& piece);

  std::array<OutputPiece, kMaxPieces> pieces_{};
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::size_t in_cell_ = 0;       ///< Number of pieces in the cell being filled.
  std::size_t max_joinable_ = 0;  ///< From this count on, all pieces of a cell are joined.
  std::uint32_t tick_ = 0;        ///< Tick up to which the cell is filled.
  OutputChanges pending_{};       ///< Changes of slices shorter than a tick.
  SegmentRate rate_{};
};

static_assert(2 * ShaperGrid::kMaxPlaces <= OutputDelay::kMaxPieces,
              "each cell on the way has room for a piece, and as many again");

}  // namespace cnc::motion
