#include "host-sim/import/filling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "host-sim/contour/known_rows.hpp"
#include "host-sim/contour/outline.hpp"
#include "host-sim/contour/shared_work.hpp"
#include "host-sim/import/doubled_curves.hpp"
#include "host-sim/import/filled_set.hpp"
#include "host-sim/import/filling_notes.hpp"
#include "host-sim/import/overlaps.hpp"
#include "host-sim/import/touching.hpp"

namespace sim::drawing {
namespace {

/// Pieces that may touch each other, as loops of one arrangement.
struct Group {
  std::vector<std::size_t> pieces{};  ///< For each loop, the number of its piece.
  Contour loops{};
  /// Numbers of pieces that have no loop, because no arcs follow them within the tolerance.
  std::vector<std::size_t> without_arcs{};
};

/// A set of pieces, given by their numbers, and the outlines of the area that they fill together.
struct Resolved {
  std::vector<std::size_t> from{};
  FilledSet filled{};
};

/// Numbers, in the arrangement, of the loops of a set and of all edges of these loops.
struct SetParts {
  std::vector<std::uint32_t> loops{};
  std::vector<std::uint32_t> edges{};
};

std::map<std::size_t, SetParts> overlapping_sets(const Arrangement& arrangement,
                                                 std::size_t loops) {
  Overlaps overlaps{arrangement, loops};
  std::map<std::size_t, SetParts> sets;
  for (std::uint32_t loop = 0; loop < loops; ++loop) {
    if (overlaps.overlaps(loop)) sets[overlaps.set_of(loop)].loops.push_back(loop);
  }
  if (sets.empty()) return sets;
  for (std::uint32_t i = 0; i < arrangement.edges().size(); ++i) {
    for (const EdgeOwner& owner : arrangement.owners(arrangement.edges()[i])) {
      if (!overlaps.overlaps(owner.loop)) continue;
      std::vector<std::uint32_t>& row = sets[overlaps.set_of(owner.loop)].edges;
      if (row.empty() || row.back() != i) row.push_back(i);
    }
  }
  return sets;
}

class Filling {
 public:
  Filling(Sketch& sketch, std::vector<Piece>& pieces, bool refuses_crossings)
      : sketch_{sketch},
        pieces_{pieces},
        refuses_crossings_{refuses_crossings},
        unresolved_(pieces.size(), false),
        replaced_(pieces.size(), false),
        notes_{sketch} {}

  [[nodiscard]] std::vector<bool> run() {
    TouchingPieces touching = find_touching(sketch_, pieces_);
    std::map<std::size_t, std::vector<std::size_t>> sets;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (touching.touches[i] && !sketch_.is_of_strokes(pieces_[i].contour.entity)) {
        sets[touching.sets.find(i)].push_back(i);
      }
    }
    std::vector<Group> groups(sets.size());
    std::vector<const std::vector<std::size_t>*> members;
    members.reserve(sets.size());
    for (const auto& [first, set] : sets) members.push_back(&set);
    share_work(groups.size(), [&] {
      return [&, rows = KnownRows{}](std::size_t i) mutable {
        groups[i] = group_of(*members[i], rows);
      };
    });
    for (const Group& group : groups) {
      for (const std::size_t piece : group.without_arcs) unresolved_[piece] = true;
      resolve(group);
    }
    notes_.finish();
    rebuild();
    return std::move(unresolved_);
  }

 private:
  [[nodiscard]] Group group_of(const std::vector<std::size_t>& set, KnownRows& rows) const;
  void resolve(const Group& group);
  [[nodiscard]] std::optional<std::vector<Resolved>> resolved(const Group& group,
                                                              double touch_mm) const;
  [[nodiscard]] std::vector<std::optional<FillingLoop>> filling_of(const Group& group,
                                                                   const SetParts& set) const;
  void replace(const std::vector<std::size_t>& from, const Contour& outlines);
  void give_up(const std::vector<std::size_t>& set);
  void refuse(const std::vector<std::size_t>& set, const Place& crossing);
  void rebuild();

  Sketch& sketch_;
  std::vector<Piece>& pieces_;
  bool refuses_crossings_;
  std::vector<bool> unresolved_;
  std::vector<bool> replaced_;
  /// Outlines, keyed by the number of the first piece that they replace.
  std::map<std::size_t, std::vector<Piece>> outlines_;
  FillingNotes notes_;
};

/// Returns the loops of a set of pieces. Pieces that no arcs follow within the tolerance stay
/// unchanged; they are reported when they are to be cut.
Group Filling::group_of(const std::vector<std::size_t>& set, KnownRows& rows) const {
  Group group;
  const OutlineOptions options{.tolerance_mm = kFillToleranceMm};
  DoubledCurves doubled;
  for (const std::size_t piece : set) doubled.count(pieces_[piece].contour);
  for (const std::size_t piece : set) {
    const FittedContour fitted =
        arcs_of(doubled.with_arcs(pieces_[piece].contour, options, rows), options, rows);
    if (fitted.fault) {
      group.without_arcs.push_back(piece);
      continue;
    }
    auto& vertices = group.loops.vertices;
    vertices.insert(vertices.end(), fitted.vertices.begin(), fitted.vertices.end());
    group.loops.end_loop();
    group.pieces.push_back(piece);
  }
  return group;
}

void Filling::resolve(const Group& group) {
  if (group.pieces.empty()) return;
  for (const double touch_mm : kFillTouchesMm) {
    const auto sets = resolved(group, touch_mm);
    if (!sets) continue;
    for (const Resolved& set : *sets) {
      // A path that runs forth and back along the same line encloses nothing; drop_flat() reports
      // it.
      if (set.filled.outlines.loop_ends.empty()) continue;
      if (refuses_crossings_ && set.from.size() > 1) {
        refuse(set.from, set.filled.crossing);
        continue;
      }
      notes_.add(pieces_, set.from, set.filled);
      replace(set.from, set.filled.outlines);
    }
    return;
  }
  give_up(group.pieces);
}

/// Returns the sets of a group, each with the outlines that replace it. Returns nothing if outlines
/// do not close.
std::optional<std::vector<Resolved>> Filling::resolved(const Group& group, double touch_mm) const {
  Arrangement arrangement;
  if (!arrangement.divide(group.loops.view(), touch_mm)) return std::nullopt;
  std::vector<Resolved> sets;
  for (const auto& [first, set] : overlapping_sets(arrangement, group.pieces.size())) {
    auto filled = fill_set(arrangement, set.edges, filling_of(group, set));
    if (!filled) return std::nullopt;
    Resolved& made = sets.emplace_back(Resolved{.filled = std::move(*filled)});
    for (const std::uint32_t loop : set.loops) made.from.push_back(group.pieces[loop]);
  }
  return sets;
}

/// Returns the fill rule and the shape of each loop of a set; nothing for other loops. The loops of
/// one entity are one shape.
std::vector<std::optional<FillingLoop>> Filling::filling_of(const Group& group,
                                                            const SetParts& set) const {
  std::map<std::tuple<std::size_t, std::size_t, std::string>, std::uint32_t> shapes;
  std::vector<std::optional<FillingLoop>> filling(group.pieces.size());
  for (const std::uint32_t loop : set.loops) {
    const Entity& entity = pieces_[group.pieces[loop]].contour.entity;
    const auto number = static_cast<std::uint32_t>(shapes.size());
    const auto shape = shapes.try_emplace({entity.line, entity.column, entity.name}, number);
    filling[loop] = {entity.is_filled && entity.fill_rule == FillRule::kNonZero,
                     shape.first->second};
  }
  return filling;
}

void Filling::replace(const std::vector<std::size_t>& from, const Contour& outlines) {
  for (const std::size_t piece : from) replaced_[piece] = true;
  const auto view = outlines.view();
  std::vector<Piece>& made = outlines_[from.front()];
  for (std::size_t loop = 0; loop < view.loop_ends.size(); ++loop) {
    Piece& piece = made.emplace_back();
    piece.contour.entity = pieces_[from.front()].contour.entity;
    piece.contour.closed = piece.contour.is_filled = true;
    const std::uint32_t first = view.loop_begin(loop);
    for (std::uint32_t i = first; i < view.loop_ends[loop]; ++i) {
      const std::uint32_t next = i + 1 < view.loop_ends[loop] ? i + 1 : first;
      piece.contour.shapes.push_back(bulge_edge(
          view.vertices[i].point(), view.vertices[next].point(), view.vertices[i].bulge));
    }
    measure(piece);
  }
}

void Filling::give_up(const std::vector<std::size_t>& set) {
  for (const std::size_t piece : set) unresolved_[piece] = true;
  sketch_.report({FaultKind::kCrossing,
                  pieces_[set.front()].contour.entity,
                  pieces_[set.front()].outline.front(),
                  "contours that touch from here on cross each other or themselves so closely that "
                  "their inside cannot be determined",
                  "separate them in the drawing"});
}

void Filling::refuse(const std::vector<std::size_t>& set, const Place& crossing) {
  for (const std::size_t piece : set) unresolved_[piece] = true;
  sketch_.report({FaultKind::kCrossing,
                  pieces_[set.front()].contour.entity,
                  crossing,
                  fmt::format("{} contours cross each other or run along each other, and it is "
                              "not certain which of their areas are meant",
                              set.size()),
                  "separate them, or draw the outline of the area that is meant"});
}

/// Replaces the pieces of each set by their outlines, at the position of the first of these pieces.
void Filling::rebuild() {
  if (outlines_.empty()) return;
  std::vector<Piece> pieces;
  std::vector<bool> unresolved;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (const auto made = outlines_.find(i); made != outlines_.end()) {
      for (Piece& piece : made->second) pieces.push_back(std::move(piece));
    } else if (!replaced_[i]) {
      pieces.push_back(std::move(pieces_[i]));
    }
    unresolved.resize(pieces.size(), unresolved_[i]);
  }
  pieces_ = std::move(pieces);
  unresolved_ = std::move(unresolved);
}

}  // namespace

std::vector<bool> fill(Sketch& sketch, std::vector<Piece>& pieces, bool refuses_crossings) {
  return Filling{sketch, pieces, refuses_crossings}.run();
}

}  // namespace sim::drawing
