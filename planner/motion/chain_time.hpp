#pragma once

#include <array>
#include <cstddef>

namespace cnc::motion {

/// What of a block decides how fast it can be driven, along its path.
struct ChainPiece {
  float length = 0.0F;        ///< mm.
  float speed = 0.0F;         ///< mm/s at most, turning aside.
  float acceleration = 0.0F;  ///< mm/s².
  float jerk = 0.0F;          ///< mm/s³.
  float bend = 0.0F;          ///< 1/mm of turning; 0 is straight.
};

/// As a piece is driven under a window.
struct PiecePace {
  float cap = 0.0F;           ///< mm/s.
  float acceleration = 0.0F;  ///< mm/s².
};

/// About how long a chain of blocks from rest to rest takes under a window.
///
/// What the plan makes of it, in short: each piece has one acceleration, A or J T; it keeps the
/// speed of a slower piece for half a window around that; and is level for a window
/// between speeding up and braking. Good enough to tell windows of one chain apart, and
/// so much cheaper than planning that it can be asked for several: some 300 operations a piece.
class ChainTime {
 public:
  static constexpr std::size_t kMostPieces = 16;

  /// The chain goes on. What is beyond the room is left out: the rest is taken to be alike.
  void add(const ChainPiece& piece);

  /// s, the window included. @pre window_s > 0
  [[nodiscard]] float seconds(float window_s) const;

 private:
  using Paces = std::array<PiecePace, kMostPieces>;
  [[nodiscard]] float peak_of(float window_s) const;
  [[nodiscard]] Paces paces(float window_s) const;

  std::array<ChainPiece, kMostPieces> pieces_{};
  std::size_t count_ = 0;
};

}  // namespace cnc::motion
