#include "host-sim/import/dxf_drawer.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <utility>

#include "host-sim/import/dxf_kinds.hpp"
#include "host-sim/import/dxf_letters.hpp"
#include "host-sim/text/lettering.hpp"

namespace sim::drawing {
namespace {

constexpr int kByBlock = 0;
constexpr int kByLayer = 256;

/// Splits curves into rows. A new row begins where a curve does not begin at the end of the curve
/// before it.
std::vector<std::vector<Shape>> rows_of(std::vector<Shape> shapes) {
  std::vector<std::vector<Shape>> rows;
  for (Shape& shape : shapes) {
    const bool goes_on = !rows.empty() && distance(end_of(rows.back().back()), start_of(shape)) <=
                                              1.0e-9 * (1.0 + start_of(shape).norm());
    if (!goes_on) rows.emplace_back();
    rows.back().push_back(std::move(shape));
  }
  return rows;
}

}  // namespace

DxfLayer DxfDrawer::layer_record(const DxfEntity& entity, const DxfInstance& within) const {
  const std::string_view own = entity.text(8);
  return tables_.layer(own.empty() || own == "0" ? std::string_view{within.layer} : own);
}

std::string DxfDrawer::hidden(const DxfEntity& entity, const DxfInstance& within) const {
  if (entity.whole(67, 0) == 1) return "entities in paper space are not drawn";
  if (entity.whole(60, 0) == 1) return "invisible entities are not drawn";
  const DxfLayer layer = layer_record(entity, within);
  if (layer.hidden.empty() || (entity.type == "INSERT" && !layer.is_frozen())) return {};
  return fmt::format("layer {:.60} is {}: its entities are not drawn", layer.name, layer.hidden);
}

Entity DxfDrawer::described(const DxfEntity& entity, const DxfInstance& within) {
  std::string name = fmt::format("{:.40}", entity.type);
  if (!entity.text(5).empty()) name += fmt::format(" {:.40}", entity.text(5));
  if (within.line != 0) name += fmt::format(" of the INSERT of line {}", within.line);
  return {.name = std::move(name),
          .line = entity.line,
          .layer = sketch_.layer(layer_of(entity, within))};
}

Layer DxfDrawer::layer_of(const DxfEntity& entity, const DxfInstance& within) const {
  const DxfLayer record = layer_record(entity, within);
  Layer layer{.name = record.name, .colour = within.colour};
  const int index = entity.whole(62, kByLayer);
  if (const auto rgb = entity.number(420)) {
    layer.colour = dxf_colour(*rgb);
  } else if (index == kByLayer) {
    layer.colour = record.colour;
  } else if (index != kByBlock) {
    layer.colour = fmt::format("ACI {}", std::abs(index));
  }
  return layer;
}

std::string DxfDrawer::line_type_of(const DxfEntity& entity, const DxfInstance& within) const {
  const std::string own = dxf_key(entity.text(6));
  if (own.empty() || own == "BYLAYER") return layer_record(entity, within).line_type;
  return own == "BYBLOCK" ? within.line_type : own;
}

void DxfDrawer::add(const DxfEntity& entity, const DxfInstance& within, DxfShapes drawn) {
  const Entity named = described(entity, within);
  if (!drawn.wrong.empty()) return refuse(entity, within, std::move(drawn.wrong));
  if (drawn.shapes.empty()) {
    return sketch_.note({FaultKind::kIgnored,
                         named,
                         within.to_mm(entity.place(10)),
                         "it has no length",
                         "it is left out"});
  }
  for (const std::string& note : drawn.notes) {
    sketch_.note(fmt::format("{:.40} {}", entity.type, note), named);
  }
  const std::string line_type = line_type_of(entity, within);
  if (tables_.is_dashed(line_type)) {
    sketch_.note(
        fmt::format("line type {:.60}: the whole line is drawn, without its gaps", line_type),
        named);
  }
  for (Shape& shape : drawn.shapes) shape = transformed(shape, within.to_mm);
  const std::size_t index = sketch_.add_entity(named);
  for (std::vector<Shape>& row : rows_of(std::move(drawn.shapes))) {
    if (!is_visible(row, named, within.clips)) continue;
    if (!sketch_.add({std::move(row), index})) return;
  }
}

/// Returns whether a row of curves is drawn. A row that crosses the edge of a clip is a fault, and
/// a row outside of the clips is left out with a note, as in SVG.
bool DxfDrawer::is_visible(const std::vector<Shape>& row,
                           const Entity& named,
                           const ClipRegions& clips) {
  const auto [sight, clip] = comparison_.compare(row, clips, {});
  if (sight == Sight::kNothing) {
    sketch_.ignore("entities outside of the boundary of their block (XCLIP) are not visible",
                   named);
  } else if (sight != Sight::kWhole) {
    const std::string reason =
        sight == Sight::kPart
            ? fmt::format("it crosses the {} (XCLIP) and is left out", clip->name)
            : fmt::format("it has too many curves to be compared with the {} (XCLIP)", clip->name);
    sketch_.report({FaultKind::kBadEntity, named, start_of(row.front()), reason, clip->remedy});
  }
  return sight == Sight::kWhole;
}

void DxfDrawer::add_text(const DxfEntity& entity, const DxfInstance& within) {
  constexpr int kInvisible = 1;
  const Entity named = described(entity, within);
  const bool is_attribute = entity.type == "ATTRIB" || entity.type == "ATTDEF";
  if (is_attribute && (entity.whole(70, 0) & kInvisible) != 0) {
    return sketch_.ignore("invisible attributes are not drawn", named);
  }
  const DxfStyle style = tables_.style(entity.text(7));
  DxfLetters letters = dxf_letters(entity, style, sketch_.lettering());
  if (!letters.wrong.empty()) return refuse(entity, within, std::move(letters.wrong));
  for (const std::string& note : letters.notes) {
    sketch_.note({FaultKind::kText,
                  named,
                  {},
                  fmt::format("{:.40} {}", entity.type, note),
                  "check it in the picture of --svg, or convert it in the drawing program "
                  "(TXTEXP)"});
  }
  if (letters.lines.empty()) {
    return sketch_.ignore(fmt::format("{:.40} has no letters", entity.type), named);
  }
  for (LetterLine& line : letters.lines) {
    line.to_mm = within.to_mm * line.to_mm;
    add_letters(sketch_, named, line, [&](const std::vector<Shape>& row) {
      return is_visible(row, named, within.clips);
    });
  }
  if (letters.lines.back().font == style.font) note_style(entity, style, named);
}

/// Adds a note if letters are drawn in another font than the style names.
void DxfDrawer::note_style(const DxfEntity& entity, const DxfStyle& style, const Entity& named) {
  const std::string& used = sketch_.lettering().font_name();
  const std::string& family = style.font.family;
  if (style.file.empty() || used.empty() || sketch_.lettering().is_stroked()) return;
  if (!family.empty() && used.starts_with(family)) return;
  sketch_.note({FaultKind::kText,
                named,
                {},
                fmt::format("style {:.60} names the font {:.60}: {} is used instead",
                            entity.text(7).empty() ? "STANDARD" : entity.text(7),
                            family.empty() ? style.file : family,
                            used),
                "install the font, or convert the letters in the drawing program (TXTEXP)"});
}

void DxfDrawer::leave_out(const DxfEntity& entity, const DxfInstance& within) {
  DxfKind kind = dxf_kind(entity.type);
  std::string what = fmt::format("{:.40} {}", entity.type, kind.reason);
  if (kind.role == DxfRole::kUnread) {
    return refuse(entity, within, std::move(what), std::move(kind.remedy));
  }
  const Entity named = described(entity, within);
  if (kind.role == DxfRole::kLetters) {
    return sketch_.leave_out_text(named, entity.text(1), std::move(kind.remedy));
  }
  sketch_.ignore(what, named, std::move(kind.remedy));
}

void DxfDrawer::refuse(const DxfEntity& entity,
                       const DxfInstance& within,
                       std::string reason,
                       std::string remedy) {
  sketch_.report(
      {FaultKind::kBadEntity, described(entity, within), {}, std::move(reason), std::move(remedy)});
}

}  // namespace sim::drawing
