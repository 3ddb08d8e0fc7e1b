#include "host-sim/cut/controller_choice.hpp"

#include <utility>
#include <vector>

#include "host-sim/cut/controller_way.hpp"

namespace sim::cut {

std::string reason_against_controller(const UnbegunCut& cut, bool is_hole, std::size_t loops) {
  const LayerSettings& settings = cut.settings;
  if (cut.is_open) return "it is an open line, which parts share or which is in narrow waste";
  if (cut.is_on_edge) return "it goes along an edge that parts share";
  if (loops != 1) return "the kerf divides it into several paths";
  if (settings.tabs != 0 && !is_hole) return "it has tabs";
  if (settings.corner_loop_mm > 0.0 || settings.corner_dwell_s > 0.0) {
    return "it has corner loops or dwells";
  }
  return {};
}

void keep_what_the_controller_finds(UnbegunCut& cut, const Outline& outline, const LeadRoom& room) {
  std::vector<Beginning> found;
  for (const Beginning& beginning : cut.beginnings) {
    const LedCut led = with_leads(cut.path, cut.settings, 0, room, beginning);
    const ControllerWay way = controller_way(outline.strokes, led.strokes, cut.settings, room);
    if (way.reason.empty()) found.push_back(beginning);
  }
  if (!found.empty()) cut.beginnings = std::move(found);
}

}  // namespace sim::cut
