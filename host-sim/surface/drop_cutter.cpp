#include "host-sim/surface/drop_cutter.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "host-sim/surface/tried_edges.hpp"

namespace sim::surface {
namespace {

using cnc::surface::kNoContact;

/// A node that is still to be searched, and an upper bound of the tip's height at which the tool
/// touches a facet of the node.
struct OpenPart {
  std::uint32_t node = 0;
  float most = 0.0F;
};

/// Stack of the nodes that are still to be searched on the way down a tree.
class OpenParts {
 public:
  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::size_t size() const { return count_; }
  OpenPart take() { return parts_[--count_]; }
  /// Adds a node to the top of the stack, or below the top entry if this entry has a higher bound.
  /// The first `before` entries keep their positions. The entry with the highest bound is thus
  /// taken next. Its contact may make the other entries unnecessary.
  void add(const OpenPart& part, std::size_t before) {
    parts_[count_++] = part;
    const bool is_lower = count_ - before > 1 && parts_[count_ - 2].most > part.most;
    if (is_lower) std::swap(parts_[count_ - 2], parts_[count_ - 1]);
  }

 private:
  /// Waiting nodes. A node has eight parts, so 2^32 facets need 11 levels. On each level, all parts
  /// except the searched part wait here.
  std::array<OpenPart, 12 * PartTree::kParts> parts_{};
  std::size_t count_ = 0;
};

}  // namespace

struct DropCutter::Search {
  Eigen::Vector2d place;
  double highest = kNoContact;
  std::uint32_t facet = 0;  ///< Facet that the tool touches at `highest`.
};

DropCutter::DropCutter(const Mesh& mesh, const cnc::surface::Profile& profile)
    : profile_{profile}, tree_{mesh, profile} {
  const std::vector<std::uint8_t> edges = tried_edges(mesh, profile.corner_mm > 0.0);
  facets_.reserve(mesh.facets.size());
  for (const std::uint32_t number : tree_.order()) {
    const auto& [a, b, c] = mesh.facets[number];
    const std::array corners{mesh.points[a], mesh.points[b], mesh.points[c]};
    facets_.push_back({{profile, corners[0], corners[1], corners[2]},
                       corners,
                       std::max({corners[0].z(), corners[1].z(), corners[2].z()}),
                       edges[number]});
  }
}

double DropCutter::tip_height(const Eigen::Vector2d& place) const {
  Search search{place};
  search_tree(search);
  return search.highest;
}

double DropCutter::tip_height(const Eigen::Vector2d& place, Hint& hint) const {
  Search search{place};
  if (hint.facet < facets_.size()) try_facet(hint.facet, search);
  search_tree(search);
  hint.facet = search.facet;
  return search.highest;
}

bool DropCutter::has_contact(const Eigen::Vector2d& place, Hint& hint) const {
  Search search{place};
  if (hint.facet < facets_.size()) try_facet(hint.facet, search);
  if (search.highest == kNoContact) search_tree(search, true);
  hint.facet = search.facet;
  return search.highest != kNoContact;
}

void DropCutter::try_facet(std::uint32_t number, Search& search) const {
  const Facet& facet = facets_[number];
  if (facet.top <= search.highest) return;
  double highest = std::max(search.highest, facet.contact.height(search.place));
  for (std::size_t i = 0; i < 3; ++i) {
    if ((facet.edges >> i & 1U) == 0) continue;
    const Eigen::Vector3d& from = facet.corners[i];
    const Eigen::Vector3d& to = facet.corners[(i + 1) % 3];
    if (std::max(from.z(), to.z()) <= highest) continue;
    highest =
        std::max(highest, cnc::surface::height_on_edge(profile_, search.place, from, to, highest));
  }
  if (highest <= search.highest) return;
  search.highest = highest;
  search.facet = number;
}

void DropCutter::search_tree(Search& search, bool is_enough) const {
  OpenParts open;
  open.add({0, std::numeric_limits<float>::infinity()}, 0);
  while (!open.empty()) {
    if (is_enough && search.highest != kNoContact) return;
    const OpenPart next = open.take();
    if (next.most <= search.highest) continue;
    const PartTree::Node& node = tree_.node(next.node);
    const PartTree::Lanes bounds = tree_.bounds(node, search.place);
    const std::size_t before = open.size();
    for (std::size_t i = 0; i < PartTree::kParts; ++i) {
      if (bounds[i] <= search.highest) continue;
      if (node.count[i] == 0) open.add({node.first[i], bounds[i]}, before);
      for (std::uint32_t k = 0; k < node.count[i]; ++k) try_facet(node.first[i] + k, search);
    }
  }
}

}  // namespace sim::surface
