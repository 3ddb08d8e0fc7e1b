#include "host-sim/import/fill_across.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "host-sim/import/filling.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {
namespace {

/// Returns whether any group has two or more layers.
bool has_group(const std::vector<std::size_t>& groups) {
  std::set<std::size_t> known;
  for (const std::size_t group : groups) {
    if (group != kAloneInGroup && !known.insert(group).second) return true;
  }
  return false;
}

/// Returns the group number of each layer, with kAloneInGroup replaced by a number that no other
/// layer has.
std::vector<std::size_t> numbered_groups(const std::vector<std::size_t>& groups) {
  std::vector<std::size_t> numbers = groups;
  for (std::size_t layer = 0; layer < numbers.size(); ++layer) {
    if (numbers[layer] == kAloneInGroup) numbers[layer] = kAloneInGroup - 1 - layer;
  }
  return numbers;
}

/// The contours of a drawing as pieces. `doubled` are those that run along another contour; they
/// are stored separately, because a contour and its copy would together fill nothing.
struct SortedPieces {
  std::vector<Piece> filling{};
  std::vector<Piece> doubled{};
};

SortedPieces pieces_of(const Drawing& drawn) {
  SortedPieces pieces;
  pieces.filling.reserve(drawn.contours.size());
  for (const DrawnContour& contour : drawn.contours) {
    Piece& piece = (contour.lies_on ? pieces.doubled : pieces.filling).emplace_back();
    piece.contour = contour;
    piece.contour.parent.reset();
    piece.contour.lies_in.reset();
    piece.contour.lies_on.reset();
    piece.contour.runs_through.clear();
    piece.contour.depth = 0;
    measure(piece);
  }
  return pieces;
}

}  // namespace

bool fill_across(Drawing& drawn,
                 const std::vector<std::size_t>& groups,
                 const ImportOptions& options) {
  if (!has_group(groups)) return false;
  Sketch sketch{options.effort, options.text};
  for (const Layer& layer : drawn.layers) static_cast<void>(sketch.layer(layer));
  sketch.group_layers(numbered_groups(groups));
  auto [pieces, doubled] = pieces_of(drawn);
  static_cast<void>(fill(sketch, pieces));
  if (sketch.faults().empty()) return false;
  drawn.more_faults += sketch.more_faults();
  drawn.faults.insert(drawn.faults.end(),
                      std::make_move_iterator(sketch.faults().begin()),
                      std::make_move_iterator(sketch.faults().end()));
  std::ranges::move(doubled, std::back_inserter(pieces));
  // Sketch for repeated notes. It is dropped, because the same notes were reported when the drawing
  // was read.
  Sketch told{options.effort, options.text};
  find_coincident(told, pieces, options.gap_mm);
  nest(told, pieces);
  drawn.contours.clear();
  for (Piece& piece : pieces) drawn.contours.push_back(std::move(piece.contour));
  return true;
}

}  // namespace sim::drawing
