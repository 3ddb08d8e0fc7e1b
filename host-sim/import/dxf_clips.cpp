#include "host-sim/import/dxf_clips.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "host-sim/import/dxf_group.hpp"

namespace sim::drawing {
namespace {

/// An object of the file, with its handle and the handle of its owner.
struct Owned {
  std::string_view handle{};
  std::string_view owner{};
  DxfEntity object{};  ///< Groups of the object if it is a boundary; otherwise empty.
};

/// Returns the upper two rows of a matrix of three rows and four columns, whose values are written
/// row by row.
Transform matrix_of(const std::vector<double>& values, std::size_t from) {
  const auto at = [&](std::size_t i) { return values[from + i]; };
  return {.x_axis{at(0), at(4)}, .y_axis{at(1), at(5)}, .origin{at(3), at(7)}};
}

/// Returns the boundary that a SPATIAL_FILTER defines. The first of its two matrices gives the map
/// to the block.
DxfClip clip_of(const DxfEntity& filter) {
  constexpr std::size_t kMatrix = 12;
  constexpr double kTilt = 1.0e-6;
  DxfClip clip{.corners = filter.places(10)};
  const double normal = filter.number(230, 1.0);
  const bool is_level = filter.place(210).norm() <= kTilt && normal > 0.0;
  const std::vector<double> values = filter.numbers(40);
  clip.is_in_plan = is_level && clip.corners.size() >= 2 && values.size() >= 2 * kMatrix;
  clip.has_depths = filter.whole(72, 0) != 0 || filter.whole(73, 0) != 0;
  if (clip.is_in_plan) clip.to_block = matrix_of(values, values.size() - 2 * kMatrix);
  clip.is_in_plan = clip.is_in_plan && std::abs(clip.to_block.determinant()) > 0.0;
  return clip;
}

/// Finds the entity that each boundary clips. The owner of a boundary is a dictionary of filters,
/// whose owner is the dictionary of an entity, whose owner is the entity.
class ClipFinder {
 public:
  explicit ClipFinder(std::string_view text) : cursor_{text} {}

  DxfClips find() {
    for (auto group = cursor_.next(); group; group = cursor_.next()) take(*group);
    keep();
    DxfClips clips;
    for (auto& [filters, clip] : boundaries_) {
      const auto extension = owners_.find(filters);
      if (extension == owners_.end()) continue;
      const auto entity = owners_.find(extension->second);
      if (entity != owners_.end()) clips.emplace(entity->second, std::move(clip));
    }
    return clips;
  }

 private:
  void take(const DxfGroup& group) {
    if (group.code == 0) {
      keep();
      owned_ = {};
      owned_.object.type = group.value;
    } else if (group.code == 102) {
      // Groups between braces contain handles of other objects.
      in_braces_ = group.value.starts_with('{');
    } else if (!in_braces_ && group.code == 5) {
      owned_.handle = group.value;
    } else if (!in_braces_ && group.code == 330 && owned_.owner.empty()) {
      owned_.owner = group.value;
    } else if (owned_.object.type == "SPATIAL_FILTER") {
      owned_.object.groups.push_back(group);
    }
  }

  void keep() {
    in_braces_ = false;
    const DxfEntity& object = owned_.object;
    if (object.type == "DICTIONARY") owners_.emplace(owned_.handle, owned_.owner);
    const bool is_on = object.whole(71, 1) != 0;
    if (object.type == "SPATIAL_FILTER" && is_on) {
      boundaries_.emplace_back(owned_.owner, clip_of(object));
    }
  }

  DxfCursor cursor_;
  Owned owned_;
  bool in_braces_ = false;
  std::map<std::string_view, std::string_view> owners_;
  std::vector<std::pair<std::string_view, DxfClip>> boundaries_;
};

}  // namespace

DxfClips dxf_clips(std::string_view text) {
  if (text.find("SPATIAL_FILTER") == std::string_view::npos) return {};
  return ClipFinder{text}.find();
}

ClipRegion region_of(const DxfClip& clip, const Transform& to_mm, const std::string& insert) {
  std::vector<Place> corners = clip.corners;
  if (corners.size() == 2) {
    const Place a = corners.front();
    const Place c = corners.back();
    corners = {a, {c.x(), a.y()}, c, {a.x(), c.y()}};
  }
  const Transform from_boundary = to_mm * clip.to_block;
  for (Place& corner : corners) corner = from_boundary(corner);
  std::vector<Shape> edges;
  edges.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    edges.emplace_back(Line{corners[i], corners[(i + 1) % corners.size()]});
  }
  ClipRegion region{.name = "boundary of " + insert,
                    .remedy =
                        "explode the block and trim it at the boundary, or delete the "
                        "boundary",
                    .areas{}};
  region.add({std::move(edges)}, FillRule::kEvenOdd);
  return region;
}

}  // namespace sim::drawing
