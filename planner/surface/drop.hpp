#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>

#include "planner/surface/profile.hpp"

namespace cnc::surface {

/// Heights at which a tool that descends along Z first touches points, edges and facets of a
/// surface. They are the heights that the inverse tool of paper 4 gives, for any tool of a Profile.
/// All lengths are in mm, and a height is the height of the tool's tip.

/// Height if the tool touches nothing.
inline constexpr double kNoContact = -std::numeric_limits<double>::infinity();

/// Returns the greatest height of the tip at which the tool touches the line from `from` to `to`,
/// including its ends. Only the part of the line under the tool counts. The result is kNoContact if
/// no part is under the tool.
/// @param place X and Y of the tool's axis
/// @param min_wanted for a height of at most this value, kNoContact may be returned instead
[[nodiscard]] double height_on_edge(const Profile& profile,
                                    const Eigen::Vector2d& place,
                                    const Eigen::Vector3d& from,
                                    const Eigen::Vector3d& to,
                                    double min_wanted = kNoContact);

/// The point at which a tool touches a plane.
struct PlaneContact {
  double out = 0.0;     ///< Distance from the axis, mm, on the side to which the plane rises.
  double height = 0.0;  ///< Height of the point above the tip, mm.
};

/// Returns the point at which the tool touches a plane. @param slope slope of the plane, mm per mm,
/// ≥ 0
[[nodiscard]] PlaneContact contact_with_plane(const Profile& profile, double slope);

/// Contact of a tool with the inside of a facet. The normal of a facet is constant, so the tool
/// always touches it with the same point of its own surface. All values that do not depend on the
/// tool's position are computed once.
class FacetContact {
 public:
  /// Prepares a facet. For an upright facet height() always returns kNoContact: a tool never
  /// touches the inside of such a facet without touching one of its edges, so checking the edges is
  /// enough.
  FacetContact(const Profile& profile,
               const Eigen::Vector3d& a,
               const Eigen::Vector3d& b,
               const Eigen::Vector3d& c);

  /// Returns the tip's height if the tool's point of contact is within the facet; kNoContact
  /// otherwise.
  [[nodiscard]] double height(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d beside = place - corner_;
    const double first = inwards_[0].dot(beside);
    const double second = inwards_[1].dot(beside);
    if (first < 0.0 || second < 0.0 || first + second > whole_) return kNoContact;
    return height_ + gradient_.dot(beside);
  }

 private:
  /// X and Y of the tool's axis when the tool's point of contact is at `a`, mm.
  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();
  /// Vectors across the two edges that meet at `a`. Their scalar products with the vector from
  /// `corner_` to the tool's axis are at least 0 inside the facet. They add up to `whole_` at the
  /// third edge.
  std::array<Eigen::Vector2d, 2> inwards_{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double whole_ = -1.0;
  double height_ = 0.0;  ///< Height of the tip when the tool's point of contact is at `a`.
  Eigen::Vector2d gradient_ = Eigen::Vector2d::Zero();
};

}  // namespace cnc::surface
