#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/import/drawing.hpp"
#include "host-sim/import/outline_box.hpp"
#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// A contour that has not yet been added to the drawing, with its chords.
struct Piece {
  DrawnContour contour;
  /// Ends of the chords, which are within kChordToleranceMm of the curves. A closed outline repeats
  /// its first point at its end.
  std::vector<Place> outline;
  OutlineBox box;
};

[[nodiscard]] inline double distance_to_chord(const Place& place,
                                              const Place& start,
                                              const Place& end) {
  const Place chord = end - start;
  const double squared = chord.squaredNorm();
  const double share =
      squared == 0.0 ? 0.0 : std::clamp(dot(place - start, chord) / squared, 0.0, 1.0);
  return distance(place, start + chord * share);
}

/// Computes the chords, box and length of a piece and, if it is closed, its area.
void measure(Piece& piece);

/// Remaining work of a search that could take minutes for some drawings. When all of it is spent,
/// the search ends, and a fault reports that it is incomplete.
class Budget {
 public:
  explicit Budget(std::size_t steps) : left_{steps} {}
  /// Subtracts steps from the budget. Returns false if no steps are left.
  bool spend(std::size_t steps) {
    left_ = steps > left_ ? 0 : left_ - steps;
    return left_ != 0;
  }
  [[nodiscard]] bool exhausted() const { return left_ == 0; }

 private:
  std::size_t left_;
};

/// Returns the pieces that result when chains of one layer are joined at ends within `gap_mm` of
/// each other. Reports ends without a partner as faults of the sketch. The remedy of such a fault
/// is to close the contour, or the text `remedy`.
/// @param mends_gaps see ImportOptions::mends_gaps
[[nodiscard]] std::vector<Piece> join(Sketch& sketch,
                                      std::vector<Piece> chains,
                                      double gap_mm,
                                      bool mends_gaps,
                                      const std::string& remedy);

/// Removes pieces that run along an earlier piece of their layer, and reports them.
void drop_duplicates(Sketch& sketch, std::vector<Piece>& pieces, double gap_mm);

/// Finds pieces that run along an earlier piece of another layer, and adds notes about them.
void find_coincident(Sketch& sketch, std::vector<Piece>& pieces, double gap_mm);

/// Finds the depth and parent of closed pieces, and the contours around open pieces.
void nest(Sketch& sketch, std::vector<Piece>& pieces);

/// Converts the sketch that a reader filled to a drawing, by all steps that are declared above.
/// @param mm_per_unit millimetres per unit with which the file was read, for messages
[[nodiscard]] Drawing assemble(Sketch& sketch,
                               const std::string& file,
                               const ImportOptions& options,
                               double mm_per_unit);

}  // namespace sim::drawing
