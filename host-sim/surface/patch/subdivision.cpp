#include "host-sim/surface/patch/subdivision.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

/// Maximum ratio of the halves' error to the error before the split at which a direction of a split
/// counts as helpful. The direction with the greater error is tried only if both directions help or
/// neither does. For a ruled patch, halving the curved parameter leaves a quarter of the error;
/// halving the straight parameter leaves the complete error.
constexpr double kHelpfulShare = 0.9;

/// Part number `index`, counted from 0, of the 2^halvings equal parts of an interval.
struct Fraction {
  std::uint32_t halvings = 0;
  std::uint32_t index = 0;

  [[nodiscard]] Fraction half(std::uint32_t which) const {
    return {halvings + 1, 2 * index + which};
  }
  [[nodiscard]] Interval of(Interval whole) const {
    const double scale = std::ldexp(whole.to - whole.from, -static_cast<int>(halvings));
    return {whole.from + scale * index, whole.from + scale * (index + 1)};
  }
  [[nodiscard]] std::uint64_t key() const { return (std::uint64_t{1} << halvings) + index; }
  [[nodiscard]] bool can_be_halved() const { return halvings < kMaxHalvings; }
};

enum class Split : std::uint8_t { kNone, kAlongU, kAlongV, kInFour };

/// A rectangle within the parameters of a patch.
struct Rectangle {
  Fraction u;
  Fraction v;

  [[nodiscard]] bool can_be(Split split) const {
    return (split == Split::kAlongV || u.can_be_halved()) &&
           (split == Split::kAlongU || v.can_be_halved());
  }
  [[nodiscard]] std::vector<Rectangle> parts(Split split) const {
    if (split == Split::kAlongU) return {{u.half(0), v}, {u.half(1), v}};
    if (split == Split::kAlongV) return {{u, v.half(0)}, {u, v.half(1)}};
    return {{u.half(0), v.half(0)},
            {u.half(0), v.half(1)},
            {u.half(1), v.half(0)},
            {u.half(1), v.half(1)}};
  }
  [[nodiscard]] std::uint64_t key() const { return u.key() << 32U | v.key(); }
  [[nodiscard]] GridPatch of(const GridPatch& patch) const {
    return {u.of(patch.u), v.of(patch.v), patch.shape.part(u.of({}), v.of({}))};
  }
};

double diameter(const BezierPatch& patch) {
  Eigen::AlignedBox3d box;
  for (const BezierCurve& row : patch.rows) {
    for (const Vector3d& point : row.controls) box.extend(point);
  }
  return box.diagonal().norm();
}

/// Finds a division of a patch into few flat pieces by repeated halving, with dynamic programming
/// over the rectangles. Counting the pieces of a split stops when the count exceeds the number of
/// pieces of another split.
class FewestPieces {
 public:
  FewestPieces(const GridPatch& patch, const FlatnessLimit& limit) : patch_{patch}, limit_{limit} {}

  std::vector<GridPatch> pieces() {
    count(Rectangle{}, kMore - 1);
    std::vector<GridPatch> found;
    std::vector<Rectangle> open{Rectangle{}};
    while (!open.empty()) {
      const Rectangle part = open.back();
      open.pop_back();
      const Split split = choices_.at(part.key()).split;
      if (split == Split::kNone) {
        found.push_back(part.of(patch_));
        continue;
      }
      const std::vector<Rectangle> parts = part.parts(split);
      open.insert(open.end(), parts.rbegin(), parts.rend());
    }
    return found;
  }

 private:
  static constexpr std::uint32_t kMore = std::numeric_limits<std::uint32_t>::max();

  struct Choice {
    double error = 0.0;
    std::uint32_t pieces = 0;  ///< Number of pieces; 0 until it is known.
    /// Limit at which a count stopped: the number of pieces is greater.
    std::uint32_t more_than = 0;
    Split split = Split::kNone;
  };

  /// Returns the entry of a rectangle. Computes the rectangle's error if the entry is new.
  Choice& choice_of(const Rectangle& part) {
    const auto [place, is_new] = choices_.try_emplace(part.key());
    if (is_new) place->second.error = chord_error_bound(part.of(patch_).shape, limit_);
    return place->second;
  }

  double error_of_parts(const Rectangle& part, Split split) {
    if (!part.can_be(split)) return std::numeric_limits<double>::infinity();
    double error = 0.0;
    for (const Rectangle& half : part.parts(split)) error = std::max(error, choice_of(half).error);
    return error;
  }

  static void note(Choice& choice, Split split, std::uint32_t pieces) {
    choice.split = split;
    choice.pieces = pieces;
  }

  /// Returns the number of pieces of a rectangle; kMore if the number exceeds `most`. The recursion
  /// is at most 2 kMaxHalvings deep, because each level adds at least one halving.
  std::uint32_t count(const Rectangle& part,  // NOLINT(misc-no-recursion): bounded by the halvings.
                      std::uint32_t most) {
    Choice& choice = choice_of(part);
    if (choice.pieces == 0 && choice.error <= limit_.tolerance_mm) choice.pieces = 1;
    if (choice.pieces == 0 && most > choice.more_than) count_splits(part, most, choice);
    if (choice.pieces == 0) choice.more_than = std::max(choice.more_than, most);
    return choice.pieces == 0 || choice.pieces > most ? kMore : choice.pieces;
  }

  void count_splits(const Rectangle& part,  // NOLINT(misc-no-recursion): see count.
                    std::uint32_t most,
                    Choice& choice) {
    const double along_u = error_of_parts(part, Split::kAlongU);
    if (along_u <= limit_.tolerance_mm) return note(choice, Split::kAlongU, 2);
    const double along_v = error_of_parts(part, Split::kAlongV);
    if (along_v <= limit_.tolerance_mm) return note(choice, Split::kAlongV, 2);
    if (std::isinf(std::min(along_u, along_v))) {
      return note(choice, Split::kNone, 1);
    }
    const bool u_is_better = along_u <= along_v;
    std::vector<Split> splits{Split::kInFour, u_is_better ? Split::kAlongU : Split::kAlongV};
    const auto helps = [&choice](double error) { return error <= kHelpfulShare * choice.error; };
    if (helps(std::max(along_u, along_v)) || !helps(std::min(along_u, along_v))) {
      splits.push_back(u_is_better ? Split::kAlongV : Split::kAlongU);
    }
    for (const Split split : splits) {
      const std::uint32_t pieces = count_parts(part, split, most);
      if (pieces == kMore) continue;
      note(choice, split, pieces);
      most = pieces - 1;
    }
  }

  std::uint32_t count_parts(const Rectangle& part,  // NOLINT(misc-no-recursion): see count.
                            Split split,
                            std::uint32_t most) {
    if (!part.can_be(split)) return kMore;
    const std::vector<Rectangle> parts = part.parts(split);
    std::uint32_t pieces = 0;
    auto left = static_cast<std::uint32_t>(parts.size());
    for (const Rectangle& next : parts) {
      --left;
      if (pieces + left >= most) return kMore;
      const std::uint32_t more = count(next, most - pieces - left);
      if (more == kMore) return kMore;
      pieces += more;
    }
    return pieces;
  }

  const GridPatch& patch_;
  const FlatnessLimit& limit_;
  std::unordered_map<std::uint64_t, Choice> choices_;
};

}  // namespace

double chord_error_bound(const BezierPatch& patch, const FlatnessLimit& limit) {
  const FatPlane plane = fat_plane(patch, limit.test);
  if (!limit.slicing_normal) return plane.flatness();
  const double sine = std::max(plane.normal.cross(*limit.slicing_normal).norm(), limit.min_sine);
  const double size = diameter(patch);
  return plane.flatness() < sine * size ? plane.flatness() / sine : size;
}

std::vector<GridPatch> quartered(const GridPatch& patch, const Excess& excess) {
  std::vector<GridPatch> pieces;
  std::vector<Rectangle> open{Rectangle{}};
  while (!open.empty()) {
    const Rectangle part = open.back();
    open.pop_back();
    GridPatch piece = part.of(patch);
    if (!part.u.can_be_halved() || excess(piece.shape) <= 0.0) {
      pieces.push_back(std::move(piece));
      continue;
    }
    const std::vector<Rectangle> parts = part.parts(Split::kInFour);
    open.insert(open.end(), parts.rbegin(), parts.rend());
  }
  return pieces;
}

std::vector<GridPatch> quartered(const GridPatch& patch, const FlatnessLimit& limit) {
  return quartered(patch, [&limit](const BezierPatch& piece) {
    return chord_error_bound(piece, limit) - limit.tolerance_mm;
  });
}

std::vector<GridPatch> halved(const GridPatch& patch, const FlatnessLimit& limit) {
  return FewestPieces{patch, limit}.pieces();
}

std::vector<GridPatch> flat_pieces(const PatchSurface& surface, const FlatnessLimit& limit) {
  std::vector<GridPatch> all;
  for (const GridPatch& patch : surface.patches) {
    const std::vector<GridPatch> pieces = halved(patch, limit);
    all.insert(all.end(), pieces.begin(), pieces.end());
  }
  return all;
}

}  // namespace sim::surface::patch
