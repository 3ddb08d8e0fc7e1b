#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>

#include "planner/surface/profile.hpp"

namespace cnc::surface {

/// Heights at which a tool that descends along Z first touches parts of a surface. This is the
/// inverse tool of paper 4, for any tool of a Profile, on points, edges and facets. All lengths are
/// mm, and a height is that of the tool's tip.

/// Height where the tool touches nothing.
inline constexpr double kNoContact = -std::numeric_limits<double>::infinity();

/// Returns the tip's height on the part of the line from `from` to `to` that is under the tool,
/// with the ends of the line; kNoContact where no part is.
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
  double height = 0.0;  ///< Height above the tip, mm.
};

/// Returns the contact of the tool with a plane. @param slope of the plane, mm per mm, ≥ 0
[[nodiscard]] PlaneContact contact_with_plane(const Profile& profile, double slope);

/// Contact of a tool with the inside of a facet. A facet has one direction, so the tool touches it
/// with the same point of its own surface everywhere. All values that do not depend on the tool's
/// position are computed once.
class FacetContact {
 public:
  /// A facet that stands upright is never touched on its inside alone: its edges are enough.
  FacetContact(const Profile& profile,
               const Eigen::Vector3d& a,
               const Eigen::Vector3d& b,
               const Eigen::Vector3d& c);

  /// Returns the tip's height where the tool's point of contact is within the facet, else
  /// kNoContact.
  [[nodiscard]] double height(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d beside = place - corner_;
    const double first = inwards_[0].dot(beside);
    const double second = inwards_[1].dot(beside);
    if (first < 0.0 || second < 0.0 || first + second > whole_) return kNoContact;
    return height_ + gradient_.dot(beside);
  }

 private:
  /// `a` minus the tool's point of contact, X and Y.
  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();
  /// Vectors across the edges from `a`, so that the sum of both products is `whole_` at the third
  /// edge.
  std::array<Eigen::Vector2d, 2> inwards_{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double whole_ = -1.0;
  double height_ = 0.0;  ///< Height of the tip where the tool's point of contact is at `a`.
  Eigen::Vector2d gradient_ = Eigen::Vector2d::Zero();
};

}  // namespace cnc::surface
