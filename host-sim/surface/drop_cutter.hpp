#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/part_tree.hpp"
#include "planner/surface/drop.hpp"

namespace sim::surface {

/// The tool over a mesh: at which height it first touches any of its facets, their edges or
/// corners, coming down along Z. A tree of parts leaves out all that cannot be higher than what was
/// found already, so that a place costs about as much over a million facets as over some thousand.
/// Lengths are mm. Any thread may ask, as nothing changes.
class DropCutter {
 public:
  /// The facet that was touched, with which the next place near by begins.
  struct Hint {
    std::uint32_t facet = 0;
  };

  /// @pre the mesh has a facet, and its indices are those of points
  DropCutter(const Mesh& mesh, const cnc::surface::Profile& profile);

  /// Returns the height of the tool's tip, with its axis at this X and Y; cnc::surface::kNoContact
  /// where nothing is under the tool.
  [[nodiscard]] double tip_height(const Eigen::Vector2d& place) const;
  /// The same, sooner where the hint is that of a place near by.
  [[nodiscard]] double tip_height(const Eigen::Vector2d& place, Hint& hint) const;

  /// Returns whether anything is under the tool; soonest where that of the hint still is.
  [[nodiscard]] bool has_contact(const Eigen::Vector2d& place, Hint& hint) const;

  [[nodiscard]] const cnc::surface::Profile& profile() const { return profile_; }

 private:
  struct Facet {
    cnc::surface::FacetContact contact;
    std::array<Eigen::Vector3d, 3> corners;
    double top = 0.0;
    std::uint8_t edges = 0;  ///< Bit i: the edge from corner i on is tried with this facet.
  };
  struct Search;

  void try_facet(std::uint32_t number, Search& search) const;
  /// Searches facets that the tool touches higher than at the height found so far.
  /// @param is_enough the first one ends the search
  void search_tree(Search& search, bool is_enough = false) const;

  cnc::surface::Profile profile_;
  PartTree tree_;
  std::vector<Facet> facets_;  ///< In the order of the tree.
};

}  // namespace sim::surface
