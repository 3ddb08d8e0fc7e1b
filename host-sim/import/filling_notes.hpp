#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/import/filled_set.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// Notes of contours that were read as what they fill. Those that only lost small loops, as at the
/// corners of boxes, share one note.
class FillingNotes {
 public:
  explicit FillingNotes(Sketch& sketch) : sketch_{sketch} {}

  /// @param from the pieces that `filled` replaces
  void add(const std::vector<Piece>& pieces,
           const std::vector<std::size_t>& from,
           const FilledSet& filled);
  /// Reports what is gathered. Call once, at the end.
  void finish();

 private:
  static constexpr std::size_t kMostNotes = 50;

  Sketch& sketch_;
  std::size_t notes_ = 0;
  std::size_t more_ = 0;  ///< Sets that have no note of their own.
  double more_unseen_mm_ = 0.0;
  std::size_t mended_ = 0;  ///< Contours that only lost small loops.
  std::size_t loops_ = 0;   ///< All of these.
  Extent greatest_{};
  std::optional<Entity> first_{};
};

}  // namespace sim::drawing
