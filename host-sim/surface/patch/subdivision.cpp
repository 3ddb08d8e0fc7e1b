#include "host-sim/surface/patch/subdivision.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

/// The worse direction of a split is tried if the flatness of its halves is below this share of
/// the whole's; a third of the flatness is left of a split along the curvature, all of it across.
constexpr double kHelpfulShare = 0.9;

/// Rectangle number `index` of 2^halvings equal ones of an interval.
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

/// A rectangle within a patch.
struct Rectangle {
  Fraction u;
  Fraction v;

  [[nodiscard]] std::pair<Rectangle, Rectangle> halves(bool along_u) const {
    if (along_u) return {{u.half(0), v}, {u.half(1), v}};
    return {{u, v.half(0)}, {u, v.half(1)}};
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

/// Finds the fewest pieces by dynamic programming over the rectangles that halvings make.
class FewestPieces {
 public:
  FewestPieces(const GridPatch& patch, const FlatnessLimit& limit) : patch_{patch}, limit_{limit} {}

  std::vector<GridPatch> pieces() {
    count(Rectangle{});
    std::vector<GridPatch> found;
    std::vector<Rectangle> open{Rectangle{}};
    while (!open.empty()) {
      const Rectangle part = open.back();
      open.pop_back();
      const Choice& choice = choices_.at(part.key());
      if (choice.pieces == 1) {
        found.push_back(part.of(patch_));
        continue;
      }
      const auto [first, second] = part.halves(choice.along_u);
      open.push_back(second);
      open.push_back(first);
    }
    return found;
  }

 private:
  struct Choice {
    double error = 0.0;
    std::uint32_t pieces = 0;  ///< 0 as long as they are not counted.
    bool along_u = false;
  };

  /// Returns what is known of a part, its error at the least.
  Choice& choice_of(const Rectangle& part) {
    const auto [place, is_new] = choices_.try_emplace(part.key());
    if (is_new) place->second.error = chord_error_bound(part.of(patch_).shape, limit_);
    return place->second;
  }

  double error_of_halves(const Rectangle& part, bool along_u) {
    if (!(along_u ? part.u : part.v).can_be_halved()) {
      return std::numeric_limits<double>::infinity();
    }
    const auto [first, second] = part.halves(along_u);
    return std::max(choice_of(first).error, choice_of(second).error);
  }

  std::uint32_t count_of_halves(const Rectangle& part, bool along_u) {
    const auto [first, second] = part.halves(along_u);
    return count(first) + count(second);
  }

  /// Returns the number of pieces of a part. Calls itself at most 2 kMaxHalvings deep.
  std::uint32_t count(
      const Rectangle& part) {  // NOLINT(misc-no-recursion): bounded by the halvings.
    Choice choice = choice_of(part);
    if (choice.pieces > 0) return choice.pieces;
    choice.pieces = 1;
    if (choice.error > limit_.tolerance_mm) split(part, choice);
    choices_[part.key()] = choice;
    return choice.pieces;
  }

  void split(const Rectangle& part, Choice& choice) {  // NOLINT(misc-no-recursion): see count.
    const double along_u = error_of_halves(part, true);
    const double along_v = error_of_halves(part, false);
    choice.along_u = along_u <= along_v;
    if (std::isinf(std::min(along_u, along_v))) return;
    choice.pieces = count_of_halves(part, choice.along_u);
    if (choice.pieces == 2 || std::max(along_u, along_v) > kHelpfulShare * choice.error) return;
    const std::uint32_t other = count_of_halves(part, !choice.along_u);
    if (other >= choice.pieces) return;
    choice.pieces = other;
    choice.along_u = !choice.along_u;
  }

  const GridPatch& patch_;
  const FlatnessLimit& limit_;
  std::unordered_map<std::uint64_t, Choice> choices_;
};

}  // namespace

double chord_error_bound(const BezierPatch& patch, const FlatnessLimit& limit) {
  const FatPlane plane = fat_plane(patch, limit.test);
  if (!limit.slicing_normal) return plane.flatness();
  const double sine = plane.normal.cross(*limit.slicing_normal).norm();
  return std::min(plane.flatness() / sine, diameter(patch));
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
    const auto [first, second] = part.halves(true);
    for (const Rectangle& half : {second, first}) {
      open.push_back(half.halves(false).second);
      open.push_back(half.halves(false).first);
    }
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
