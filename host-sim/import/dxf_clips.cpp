#include "host-sim/import/dxf_clips.hpp"

#include <map>
#include <optional>

#include "host-sim/import/dxf_group.hpp"

namespace sim::drawing {
namespace {

/// An object of which the owner counts.
struct Owned {
  std::string_view type{};
  std::string_view handle{};
  std::string_view owner{};
  bool is_on = true;
};

/// Follows the owners of boundaries: a dictionary of filters, the dictionary of an entity, and the
/// entity.
class ClipFinder {
 public:
  explicit ClipFinder(std::string_view text) : cursor_{text} {}

  std::set<std::string, std::less<>> find() {
    for (auto group = cursor_.next(); group; group = cursor_.next()) take(*group);
    keep();
    std::set<std::string, std::less<>> handles;
    for (const std::string_view filters : boundaries_) {
      const auto extension = owners_.find(filters);
      if (extension == owners_.end()) continue;
      const auto entity = owners_.find(extension->second);
      if (entity != owners_.end()) handles.emplace(entity->second);
    }
    return handles;
  }

 private:
  void take(const DxfGroup& group) {
    if (group.code == 0) {
      keep();
      object_ = {.type = group.value};
    } else if (group.code == 102) {
      // Between braces are handles of others.
      in_braces_ = group.value.starts_with('{');
    } else if (!in_braces_ && group.code == 5) {
      object_.handle = group.value;
    } else if (!in_braces_ && group.code == 330 && object_.owner.empty()) {
      object_.owner = group.value;
    } else if (group.code == 71 && object_.type == "SPATIAL_FILTER") {
      object_.is_on = group.value != "0";
    }
  }

  void keep() {
    in_braces_ = false;
    if (object_.type == "DICTIONARY") owners_.emplace(object_.handle, object_.owner);
    if (object_.type == "SPATIAL_FILTER" && object_.is_on) boundaries_.insert(object_.owner);
  }

  DxfCursor cursor_;
  Owned object_;
  bool in_braces_ = false;
  std::map<std::string_view, std::string_view> owners_;
  std::set<std::string_view> boundaries_;
};

}  // namespace

std::set<std::string, std::less<>> clipped_inserts(std::string_view text) {
  if (text.find("SPATIAL_FILTER") == std::string_view::npos) return {};
  return ClipFinder{text}.find();
}

}  // namespace sim::drawing
