#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/import/filled_set.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// Adds notes about contours that were replaced by the outlines of the area that they fill. All
/// contours that only lost small loops, for example at the corners of boxes, have one common note.
class FillingNotes {
 public:
  explicit FillingNotes(Sketch& sketch) : sketch_{sketch} {}

  /// Adds a note about a set of pieces.
  /// @param from numbers of the pieces that `filled` replaces
  void add(const std::vector<Piece>& pieces,
           const std::vector<std::size_t>& from,
           const FilledSet& filled);
  /// Adds the common note, and a note about the sets that exceed the limit of notes. Must be called
  /// once, at the end.
  void finish();

 private:
  static constexpr std::size_t kMaxNotes = 50;

  Sketch& sketch_;
  std::size_t notes_ = 0;
  std::size_t more_ = 0;  ///< Number of sets without a separate note.
  double more_unseen_mm_ = 0.0;
  std::size_t mended_ = 0;  ///< Number of contours that only lost small loops.
  /// Number of small loops that the contours counted by `mended_` have lost.
  std::size_t loops_ = 0;
  Extent greatest_{};
  std::optional<Entity> first_{};
};

}  // namespace sim::drawing
