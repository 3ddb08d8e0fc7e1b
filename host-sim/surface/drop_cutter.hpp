#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/part_tree.hpp"
#include "planner/surface/drop.hpp"

namespace sim::surface {

/// Finds the height at which a tool that comes down along Z first touches a mesh: a facet, an edge
/// or a corner. The search in a tree skips all facets that cannot have a higher contact than the
/// highest contact so far. The time of a search thus hardly depends on the number of facets.
/// Lengths are mm. Several threads may call the const functions at the same time.
class DropCutter {
 public:
  /// Facet of the last contact. The search at a nearby point begins with this facet.
  struct Hint {
    std::uint32_t facet = 0;
  };

  /// @pre the mesh has at least one facet, and all its indices are valid
  DropCutter(const Mesh& mesh, const cnc::surface::Profile& profile);

  /// Returns the height of the tool's tip with the tool's axis at `place` (X, Y);
  /// cnc::surface::kNoContact if nothing is under the tool.
  [[nodiscard]] double tip_height(const Eigen::Vector2d& place) const;
  /// Returns the height of the tool's tip, like the overload without a hint. The search is faster
  /// if `hint` comes from a nearby point. Updates `hint`.
  [[nodiscard]] double tip_height(const Eigen::Vector2d& place, Hint& hint) const;

  /// Returns whether anything is under the tool. The search is fastest if the hint's facet is still
  /// under the tool. Updates `hint`.
  [[nodiscard]] bool has_contact(const Eigen::Vector2d& place, Hint& hint) const;

  [[nodiscard]] const cnc::surface::Profile& profile() const { return profile_; }

 private:
  struct Facet {
    cnc::surface::FacetContact contact;
    std::array<Eigen::Vector3d, 3> corners;
    double top = 0.0;
    /// Edges that are tested with this facet. Bit i is the edge that starts at corner i.
    std::uint8_t edges = 0;
  };
  struct Search;

  void try_facet(std::uint32_t number, Search& search) const;
  /// Updates `search` with all contacts that are higher than its highest contact so far.
  /// @param is_enough whether the first contact ends the search
  void search_tree(Search& search, bool is_enough = false) const;

  cnc::surface::Profile profile_;
  PartTree tree_;
  std::vector<Facet> facets_;  ///< Facets in the order of the tree.
};

}  // namespace sim::surface
