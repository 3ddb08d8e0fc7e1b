#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/part_tree.hpp"
#include "planner/surface/drop.hpp"

namespace sim::surface {

/// Finds the height at which a tool that comes down along Z first touches any facet of a mesh, or
/// an edge or corner of a facet. A tree of parts skips all facets that cannot be higher than the
/// contact found so far, so that a point costs about as much over a million facets as over a few
/// thousand. Lengths are mm. All threads may call the const functions at once.
class DropCutter {
 public:
  /// The facet that was touched last. The search at a point near by begins with this facet.
  struct Hint {
    std::uint32_t facet = 0;
  };

  /// @pre the mesh has at least one facet, and all its indices are valid
  DropCutter(const Mesh& mesh, const cnc::surface::Profile& profile);

  /// Returns the height of the tool's tip with the tool's axis at this X and Y;
  /// cnc::surface::kNoContact if nothing is under the tool.
  [[nodiscard]] double tip_height(const Eigen::Vector2d& place) const;
  /// Returns the same height. The search is faster if the hint comes from a point near by.
  [[nodiscard]] double tip_height(const Eigen::Vector2d& place, Hint& hint) const;

  /// Returns whether anything is under the tool. The search is fastest if the hint's facet still
  /// is.
  [[nodiscard]] bool has_contact(const Eigen::Vector2d& place, Hint& hint) const;

  [[nodiscard]] const cnc::surface::Profile& profile() const { return profile_; }

 private:
  struct Facet {
    cnc::surface::FacetContact contact;
    std::array<Eigen::Vector3d, 3> corners;
    double top = 0.0;
    std::uint8_t edges = 0;  ///< Bit i: this facet tests the edge that starts at its corner i.
  };
  struct Search;

  void try_facet(std::uint32_t number, Search& search) const;
  /// Searches for facets that the tool touches at a greater height than the greatest one found so
  /// far.
  /// @param is_enough whether the first such facet ends the search
  void search_tree(Search& search, bool is_enough = false) const;

  cnc::surface::Profile profile_;
  PartTree tree_;
  std::vector<Facet> facets_;  ///< Facets in the order of the tree.
};

}  // namespace sim::surface
