#include "host-sim/contour/contour_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/contour/contour_text.hpp"
#include "host-sim/contour/material_side.hpp"
#include "host-sim/report/printable.hpp"

namespace sim {
namespace {

/// Returns whether a text is a drawing. A text whose first line is a single whole number is a DXF,
/// because such a line cannot be a vertex of contours in text.
bool is_drawing(std::string_view text) {
  constexpr std::string_view kByteOrder = "\xEF\xBB\xBF";
  constexpr std::string_view kDigits = "0123456789";
  if (text.starts_with(kByteOrder)) text.remove_prefix(kByteOrder.size());
  text.remove_prefix(std::min(text.size(), text.find_first_not_of(" \t\r\n")));
  if (text.empty()) return false;
  if (std::string_view{"<{["}.find(text.front()) != std::string_view::npos) return true;
  std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  line = line.substr(0, line.find_last_not_of(" \t") + 1);
  return line.find_first_not_of(kDigits) == std::string_view::npos ||
         text.starts_with("AutoCAD Binary DXF");
}

/// Throws FaultyDrawing if the drawing has errors, or letters that are left out, because only `cut`
/// can draw letters. Ignores other entities that are left out because they are no paths.
void throw_faults(const drawing::Drawing& drawn, const std::vector<drawing::Fault>& more) {
  std::string text;
  for (const auto* const faults : {&drawn.faults, &more}) {
    for (const drawing::Fault& fault : *faults) {
      const bool is_text = fault.kind == drawing::FaultKind::kText;
      if (fault.is_error() || is_text) text += printable_line(to_string(fault, drawn.file)) + "\n";
    }
  }
  if (drawn.more_faults != 0) text += "and " + std::to_string(drawn.more_faults) + " more\n";
  if (text.empty() && drawn.contours.empty())
    text = printable_line(drawn.file) + ": the drawing has no contour\n";
  if (!text.empty()) text.pop_back();
  if (!text.empty()) throw FaultyDrawing{text};
}

/// Throws FaultyDrawing if a point is farther from the origin than points of a drawing may be,
/// because larger coordinates would make distances inexact.
void refuse_far(const Contour& contour, const std::string& name) {
  for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
    const ContourVertex& vertex = contour.vertices[i];
    if (std::max(std::abs(vertex.x), std::abs(vertex.y)) <= drawing::kFarthestMm) continue;
    throw FaultyDrawing{
        fmt::format("{}: vertex {} at {:g} {:g}: is farther than 10 km from the origin; check that "
                    "its unit is mm",
                    name,
                    i + 1,
                    vertex.x,
                    vertex.y)};
  }
}

/// Returns the loops of each part separately, in the order of the file.
std::vector<ContourPart> parts_of(const Outline& outline, const drawing::Drawing& drawn) {
  std::map<std::size_t, ContourPart> parts;
  const auto view = outline.contour.view();
  for (std::size_t loop = 0; loop < view.loop_ends.size(); ++loop) {
    const drawing::Entity& entity = drawn.contours[outline.drawn[loop]].entity;
    ContourPart& part = parts[entity.part];
    append_loop(view, loop, part.contour);
    part.layers.push_back(drawn.layers[entity.layer]);
  }
  std::vector<ContourPart> list;
  list.reserve(parts.size());
  for (auto& [number, part] : parts) list.push_back(std::move(part));
  return list;
}

}  // namespace

bool is_contour_text(std::string_view text) {
  if (is_drawing(text)) return false;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin != std::string_view::npos && line[begin] != '#') {
      return std::string_view{"+-.0123456789"}.find(line[begin]) != std::string_view::npos;
    }
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  return false;
}

ContourFile contours_of(const std::string& text,
                        const std::string& file,
                        const OutlineOptions& options,
                        Crossing crossing) {
  const std::string name = file == "-" ? "standard input" : file;
  ContourFile read;
  if (!is_drawing(text)) {
    Contour contour = contour_from_text(text, name);
    refuse_far(contour, name);
    put_material_left(contour);
    const std::size_t loops = contour.loop_ends.size();
    read.parts.push_back({std::move(contour), std::vector<drawing::Layer>(loops)});
    return read;
  }
  const drawing::ImportOptions import{.refuses_crossings = crossing == Crossing::kRefused};
  const drawing::Drawing drawn = drawing::read_drawing(name, text, import);
  const Outline outline = outline_of(drawn, options);
  throw_faults(drawn, outline.faults);
  read.parts = parts_of(outline, drawn);
  for (const drawing::Fault& fault : drawn.faults) {
    if (fault.kind == drawing::FaultKind::kMended) read.notes.push_back(to_string(fault, name));
  }
  return read;
}

}  // namespace sim
