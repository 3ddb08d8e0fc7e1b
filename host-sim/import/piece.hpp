#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/import/drawing.hpp"
#include "host-sim/import/outline_box.hpp"
#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// A contour on its way into the drawing, with its chords.
struct Piece {
  DrawnContour contour;
  std::vector<Place> outline;  ///< Within kChordToleranceMm; the first place again at the end.
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

/// Fills in chords, box, length and, of a closed one, area.
void measure(Piece& piece);

/// Work left for a search that has no bound worth having: a drawing that takes
/// more is told so instead of a user waiting for minutes.
class Budget {
 public:
  explicit Budget(std::size_t steps) : left_{steps} {}
  /// False when it is used up.
  bool spend(std::size_t steps) {
    left_ = steps > left_ ? 0 : left_ - steps;
    return left_ != 0;
  }
  [[nodiscard]] bool exhausted() const { return left_ == 0; }

 private:
  std::size_t left_;
};

/// Joins chains of one layer whose ends are within the gap. Ends that stay alone
/// become faults of the sketch, with `remedy` beside that of closing them.
/// @param mends_gaps as ImportOptions has it
[[nodiscard]] std::vector<Piece> join(Sketch& sketch,
                                      std::vector<Piece> chains,
                                      double gap_mm,
                                      bool mends_gaps,
                                      const std::string& remedy);

/// Leaves out what runs along an earlier piece of its layer, and says so.
void drop_duplicates(Sketch& sketch, std::vector<Piece>& pieces, double gap_mm);

/// Finds pieces that lie on an earlier one of another layer, and notes them.
void find_coincident(Sketch& sketch, std::vector<Piece>& pieces, double gap_mm);

/// Finds depth and parent of closed pieces.
void nest(Sketch& sketch, std::vector<Piece>& pieces);

/// All of it: what a reader gathered becomes a drawing.
/// @param mm_per_unit by which it was read, for messages
[[nodiscard]] Drawing assemble(Sketch& sketch,
                               const std::string& file,
                               const ImportOptions& options,
                               double mm_per_unit);

}  // namespace sim::drawing
