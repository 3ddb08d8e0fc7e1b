#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/motion/motors/shaper_grid.hpp"
#include "planner/motion/segment/planned_slice.hpp"
#include "planner/motion/segment/segment_rate.hpp"

namespace cnc::motion {

/// The beam or spindle output over a part of a cell, and the output changes at the start of that
/// part.
struct OutputPiece {
  std::uint16_t ticks = 0;
  std::uint16_t start = 0;  ///< Duty at the start of the piece; 65535 is full output.
  std::uint16_t end = 0;
  OutputChanges outputs{};

  [[nodiscard]] bool constant() const { return start == end; }
};

/// Delays the outputs until the shaped motion reaches the position for which they were planned. The
/// outputs are stored as a queue of pieces, cell by cell.
///
/// The boundaries between pieces keep their times. An output that stays constant is one piece.
/// Pieces of a cell are joined to one piece with the same energy in two cases. In the first case,
/// the pieces are so short that the queue of segments would run empty. In the second case, the
/// queue of pieces is full. Then output changes move to the start of the joined piece, too. (Both
/// cases occur only in a long row of blocks of a few µm that are driven at full speed under M4.)
class OutputDelay {
 public:
  static constexpr std::size_t kMaxPieces = 384;

  /// Forgets all pieces.
  /// @param cells_held number of cells between planning and output, at most ShaperGrid::kMaxPlaces
  void clear(std::uint32_t cells_held);

  /// Adds the output of a slice, up to `end_tick` of the cell that is being filled.
  void add(const PlannedSlice& slice, std::uint32_t end_tick);
  /// Adds a constant output of `duty`, up to `end_tick` of the cell that is being filled.
  void hold(float duty, std::uint32_t end_tick) {
    add({.start_duty = duty, .end_duty = duty}, end_tick);
  }
  /// Closes the cell that is being filled. @pre the last `end_tick` was the end of the cell
  void close_cell();

  /// Takes the oldest piece. @pre at least one whole cell is stored
  [[nodiscard]] OutputPiece take();

 private:
  [[nodiscard]] std::size_t newest() const { return (oldest_ + count_ - 1) % kMaxPieces; }
  void append(const OutputPiece& piece);
  [[nodiscard]] bool joins(const OutputPiece& piece) const;
  void join(const OutputPiece& piece);

  std::array<OutputPiece, kMaxPieces> pieces_{};
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  std::size_t in_cell_ = 0;  ///< Number of pieces in the cell that is being filled.
  /// Number of stored pieces from which on the pieces of a cell are joined.
  std::size_t max_joinable_ = 0;
  std::uint32_t tick_ = 0;  ///< Tick up to which the cell is filled.
  /// Output changes of slices that are shorter than a tick. The next piece contains them.
  OutputChanges pending_{};
  SegmentRate rate_{};
};

static_assert(2 * ShaperGrid::kMaxPlaces <= OutputDelay::kMaxPieces,
              "each cell on the way has room for a piece, and as many again");

}  // namespace cnc::motion
