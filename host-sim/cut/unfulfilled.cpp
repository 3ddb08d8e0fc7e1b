#include "host-sim/cut/unfulfilled.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace sim::cut {
namespace {

using drawing::FaultKind;

constexpr const char* kMakeRoom = "choose a smaller --corner-loop, or move the parts apart";

}  // namespace

std::vector<drawing::Fault> unfulfilled(const LedCut& cut,
                                        const LayerSettings& settings,
                                        const drawing::Entity& entity,
                                        unsigned tabs) {
  std::vector<drawing::Fault> warnings;
  const Place& start = cut.strokes.front().from;
  const auto warn = [&](const Place& place, std::string reason, std::string remedy) {
    warnings.push_back({FaultKind::kTooSmall, entity, place, std::move(reason), std::move(remedy)});
  };
  const CornerWork& corners = cut.corners;
  if (corners.without_room != 0) {
    warn(corners.first_without.value_or(start),
         fmt::format("{} corners, this one first, have no free space for their loops",
                     corners.without_room),
         kMakeRoom);
  }
  if (corners.smaller != 0) {
    warn(corners.first_smaller.value_or(start),
         fmt::format("{} corners, this one first, have free space for a smaller loop only",
                     corners.smaller),
         kMakeRoom);
  }
  if (!cut.has_leads) {
    warn(start,
         "has no free space for its leads, and is cut without them",
         "shorten them for its layer, or move the parts apart");
  } else if (cut.lead_share < 1.0) {
    warn(start,
         fmt::format("has free space for leads of {:g} % of their length", 100.0 * cut.lead_share),
         "shorten them for its layer, or move the parts apart");
  }
  if (cut.tabs != tabs) {
    warn(start,
         fmt::format("has space for {} of {} tabs", cut.tabs, tabs),
         "choose fewer or narrower tabs for its layer");
  }
  const bool ends_at_tab = settings.start == StartAt::kTab && cut.tabs > 0;
  if (ends_at_tab && (settings.overcut_mm > 0.0 || settings.lead_out.is_asked)) {
    warn(start,
         "ends before a tab, without overcut and lead-out",
         "leave these out for its layer, or let it begin elsewhere than at a tab");
  }
  return warnings;
}

std::vector<drawing::Fault> unfulfilled_on_line(const LayerSettings& settings,
                                                const drawing::Entity& entity,
                                                const Place& start) {
  std::string wishes;
  const auto add = [&wishes](bool is_set, std::string_view key) {
    if (is_set) wishes += fmt::format("{}{}", wishes.empty() ? "" : ", ", key);
  };
  add(settings.lead_in.is_asked, "lead-in");
  add(settings.lead_out.is_asked, "lead-out");
  add(settings.tabs != 0, "tabs");
  add(settings.overcut_mm > 0.0, "overcut");
  add(settings.pierce_s > 0.0, "pierce");
  add(settings.corner_loop_mm > 0.0, "corner-loop");
  add(settings.corner_dwell_s > 0.0, "corner-dwell");
  if (wishes.empty()) return {};
  return {{FaultKind::kTooSmall,
           entity,
           start,
           fmt::format("is cut on its line, without {}", wishes),
           "leave these out for its layer, or cut it with side=waste"}};
}

}  // namespace sim::cut
