#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>

#include "planner/surface/profile.hpp"

namespace cnc::surface {

/// The heights at which a tool that comes down along Z first touches parts of a surface: the
/// inverse tool of paper 4, for any tool of a Profile, on points, edges and facets. All lengths are
/// mm, and a height is that of the tool's tip.

/// Nothing is touched.
inline constexpr double kNoContact = -std::numeric_limits<double>::infinity();

/// Returns the tip's height on the part of the line from `from` to `to` that is under the tool, its
/// ends included; kNoContact where none of it is.
/// @param place of the tool's axis, X and Y
/// @param least_wanted a height of no more than this may be told as kNoContact
[[nodiscard]] double height_on_edge(const Profile& profile,
                                    const Eigen::Vector2d& place,
                                    const Eigen::Vector3d& from,
                                    const Eigen::Vector3d& to,
                                    double least_wanted = kNoContact);

/// The point at which a tool touches a plane.
struct PlaneContact {
  double out = 0.0;     ///< mm from the axis, on the side to which the plane rises.
  double height = 0.0;  ///< Above the tip.
};

/// @param slope of the plane, mm per mm, ≥ 0
[[nodiscard]] PlaneContact contact_with_plane(const Profile& profile, double slope);

/// A tool on the inside of a facet: as the facet has one direction, the tool touches it with the
/// same point of its own wherever it is. What does not depend on the place is computed once.
class FacetContact {
 public:
  /// A tool never touches the inside alone of a facet that stands upright: its edges are enough.
  FacetContact(const Profile& profile,
               const Eigen::Vector3d& a,
               const Eigen::Vector3d& b,
               const Eigen::Vector3d& c);

  /// Returns the tip's height where the tool's point is within the facet, else kNoContact.
  [[nodiscard]] double height(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d beside = place - corner_;
    const double first = inwards_[0].dot(beside);
    const double second = inwards_[1].dot(beside);
    if (first < 0.0 || second < 0.0 || first + second > whole_) return kNoContact;
    return height_ + gradient_.dot(beside);
  }

 private:
  Eigen::Vector2d corner_ = Eigen::Vector2d::Zero();  ///< `a` less the tool's point.
  /// Across the edges from `a`, so that their sum is `whole_` at the third edge.
  std::array<Eigen::Vector2d, 2> inwards_{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double whole_ = -1.0;
  double height_ = 0.0;  ///< Of the tip where the tool's point is at `a`.
  Eigen::Vector2d gradient_ = Eigen::Vector2d::Zero();
};

}  // namespace cnc::surface
