#include "host-sim/import/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host-sim/report/printable.hpp"

namespace sim::drawing {

std::string_view name_of(FaultKind kind) {
  static constexpr std::array<std::string_view, 16> kNames{"unreadable",
                                                           "bad entity",
                                                           "too much",
                                                           "text",
                                                           "open",
                                                           "branch",
                                                           "too small",
                                                           "duplicate",
                                                           "crossing",
                                                           "no arcs",
                                                           "unchecked",
                                                           "ignored",
                                                           "mended",
                                                           "note",
                                                           "picture",
                                                           "bad picture"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::string to_string(const Fault& fault, const std::string& file) {
  std::string text = printable(file);
  if (fault.entity.line != 0) text += fmt::format(":{}", fault.entity.line);
  if (fault.entity.column != 0) text += fmt::format(":{}", fault.entity.column);
  text += ": ";
  if (!fault.entity.name.empty()) text += fault.entity.name;
  if (fault.place_mm) {
    text += fmt::format("{}at {:.3f} {:.3f}",
                        fault.entity.name.empty() ? "" : " ",
                        fault.place_mm->x(),
                        fault.place_mm->y());
  }
  if (!fault.entity.name.empty() || fault.place_mm) text += ": ";
  text += fault.reason;
  if (!fault.remedy.empty()) text += "; " + fault.remedy;
  return text;
}

bool Drawing::has_errors() const {
  return std::ranges::any_of(faults, [](const Fault& fault) { return fault.is_error(); }) ||
         more_faults != 0;
}

}  // namespace sim::drawing
