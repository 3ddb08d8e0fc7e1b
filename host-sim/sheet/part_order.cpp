#include "host-sim/sheet/part_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "host-sim/report/printable.hpp"

namespace sim::sheet {
namespace {

void report(Sheet& sheet, const SheetPart& part, std::string reason, std::string remedy) {
  sheet.faults.push_back({drawing::FaultKind::kBadEntity,
                          {.name = part.pointer + "/after"},
                          {},
                          std::move(reason),
                          std::move(remedy)});
}

/// Returns, for each part, the numbers of the parts that must be cut before it. Reports a fault for
/// each name that the sheet cannot fulfil.
std::vector<std::vector<std::size_t>> parts_before(Sheet& sheet) {
  std::map<std::string, std::size_t> number_of;
  for (std::size_t i = 0; i < sheet.parts.size(); ++i) number_of.emplace(sheet.parts[i].name, i);
  std::vector<std::vector<std::size_t>> before(sheet.parts.size());
  for (std::size_t i = 0; i < sheet.parts.size(); ++i) {
    for (const std::string& name : sheet.parts[i].after) {
      const auto found = number_of.find(name);
      if (found != number_of.end()) {
        before[i].push_back(found->second);
        if (!sheet.locked || found->second < i) continue;
        report(sheet,
               sheet.parts[i],
               fmt::format("part \"{}\" comes later in the file, and the order is locked",
                           printable_line(name)),
               "move that part up, or leave \"locked\" out");
        continue;
      }
      report(sheet,
             sheet.parts[i],
             fmt::format("no part is called \"{}\"", printable_line(name)),
             "use the \"name\" of a part of this sheet");
    }
  }
  return before;
}

/// Returns the names of parts that wait for each other in a circle, so that none of them has a
/// rank.
std::string circle_from(std::size_t part,
                        const Sheet& sheet,
                        const std::vector<std::vector<std::size_t>>& before,
                        const std::vector<char>& has_turn) {
  std::vector<std::size_t> way;
  std::size_t here = part;
  while (std::ranges::find(way, here) == way.end()) {
    way.push_back(here);
    here = *std::ranges::find_if(before[here], [&](std::size_t other) { return !has_turn[other]; });
  }
  way.erase(way.begin(), std::ranges::find(way, here));
  std::string text;
  for (const std::size_t each : way) {
    text += fmt::format("\"{}\" after ", printable_line(sheet.parts[each].name));
  }
  return text + fmt::format("\"{}\"", printable_line(sheet.parts[here].name));
}

}  // namespace

void give_turns(Sheet& sheet) {
  const auto before = parts_before(sheet);
  std::vector<char> has_turn(sheet.parts.size(), 0);
  // Each pass through the loop assigns its number, as rank, to all parts whose predecessors already
  // have a rank.
  for (std::size_t turn = 0;; ++turn) {
    std::vector<std::size_t> ready;
    for (std::size_t i = 0; i < sheet.parts.size(); ++i) {
      const auto is_done = [&](std::size_t other) { return has_turn[other] != 0; };
      if (has_turn[i] == 0 && std::ranges::all_of(before[i], is_done)) ready.push_back(i);
    }
    if (ready.empty()) break;
    for (const std::size_t part : ready) {
      sheet.parts[part].turn = turn;
      has_turn[part] = 1;
    }
  }
  const auto stuck = std::ranges::find(has_turn, 0);
  if (stuck == has_turn.end()) return;
  const auto part = static_cast<std::size_t>(stuck - has_turn.begin());
  report(sheet,
         sheet.parts[part],
         fmt::format("parts wait for each other in a circle: {}",
                     circle_from(part, sheet, before, has_turn)),
         "remove one of them from an \"after\"");
}

}  // namespace sim::sheet
