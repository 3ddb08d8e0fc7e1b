#include "host-sim/import/svg_clips.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/svg_shapes.hpp"

namespace sim::drawing {
namespace {

constexpr std::size_t kMaxClipsOfClips = 8;
constexpr const char* kReleaseClip =
    "release the clip in the drawing program and cut the shape there";

std::vector<Shape> rectangle(const Place& size) {
  const Place a{0.0, 0.0};
  const Place b{size.x(), 0.0};
  const Place d{0.0, size.y()};
  return {Line{a, b}, Line{b, size}, Line{size, d}, Line{d, a}};
}

void transform(SvgSubpaths& subpaths, const Transform& transform) {
  for (std::vector<Shape>& shapes : subpaths) {
    for (Shape& shape : shapes) shape = transformed(shape, transform);
  }
}

}  // namespace

std::optional<Transform> svg_own_transform(const SvgProperties& properties,
                                           const SvgViewport& viewport) {
  const std::string_view text = properties.get("transform");
  if (text.empty()) return Transform{};
  auto own = svg_transform(text);
  const std::string_view origin = properties.get("transform-origin");
  if (!own || origin.empty()) return own;
  const auto place = svg_origin(origin, viewport);
  if (!place) return {};
  return moved_by(*place) * *own * moved_by(-*place);
}

SvgClips::SvgClips(SvgDocument& document, Sketch& sketch)
    : document_{document}, sketch_{sketch}, comparison_{sketch.share_of(kMaxClipSteps)} {}

// Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
void SvgClips::enter(const pugi::xml_node& node,
                     const SvgProperties& properties,
                     const std::optional<OutlineBox>& box,
                     SvgStyle& style) {
  const std::string_view value = properties.get("clip-path");
  if (value.empty() || value == "none") return;
  const pugi::xml_node clip_path = document_.find(svg_reference(value));
  if (local_name(clip_path) != "clipPath") {
    document_.report_bad(node,
                         fmt::format("clip-path \"{:.60}\" is not known", value),
                         "all of the element is read; release the clip in the drawing program");
    return;
  }
  Transform to_mm = style.to_mm;
  if (std::string_view{clip_path.attribute("clipPathUnits").value()} == "objectBoundingBox") {
    if (!box || !(box->width() > 0.0) || !(box->height() > 0.0)) {
      document_.report_bad(
          node, "its clip is in units of its bounding box, which only a shape has", kReleaseClip);
      return;
    }
    to_mm = to_mm * moved_by(box->least) * scaled_by(box->width(), box->height());
  }
  const SvgProperties own = document_.properties_of(clip_path);
  const auto transform = svg_own_transform(own, style.viewport);
  if (transform) to_mm = to_mm * *transform;
  ClipRegion clip{.name = fmt::format("clip path \"{:.60}\"", clip_path.attribute("id").value()),
                  .remedy = kReleaseClip,
                  .areas{}};
  add_paths(clip_path, to_mm, style, clip);
  style.clips.push_back(std::make_shared<const ClipRegion>(std::move(clip)));
  if (depth_ >= kMaxClipsOfClips) return;
  ++depth_;
  SvgStyle around = style;
  around.to_mm = to_mm;
  enter(clip_path, own, {}, around);
  style.clips = std::move(around.clips);
  --depth_;
}

void SvgClips::add_paths(const pugi::xml_node& clip_path,
                         const Transform& to_mm,
                         SvgStyle style,
                         ClipRegion& clip) {
  inherit(document_.properties_of(clip_path), style);
  for (const pugi::xml_node& child : clip_path.children()) {
    if (child.type() != pugi::node_element) continue;
    if (!document_.count(child)) return;
    add_path(child, to_mm, style, clip);
  }
}

void SvgClips::add_path(pugi::xml_node child,
                        const Transform& to_mm,
                        SvgStyle style,
                        ClipRegion& clip) {
  Transform own = to_mm;
  for (int links = 0; links < 2; ++links) {
    const SvgProperties properties = document_.properties_of(child);
    inherit(properties, style);
    if (properties.get("display") == "none" || !style.is_visible) return;
    const auto transform = svg_own_transform(properties, style.viewport);
    if (!transform)
      return document_.report_bad(child, "its transform cannot be read", "correct it");
    own = own * *transform;
    const std::string_view name = local_name(child);
    if (is_svg_shape(name)) {
      SvgPen pen;
      const SvgShapeFault wrong = draw_svg_shape(name, properties, style.viewport, pen);
      if (!wrong.is_error) return;
      if (!wrong.reason.empty()) return document_.report_bad(child, wrong.reason, "correct it");
      drawing::transform(pen.subpaths(), own);
      clip.add(pen.subpaths(), fill_rule_of(style.clip_rule));
      return;
    }
    const pugi::xml_node target = document_.linked(child);
    if (name != "use" || !target) break;
    own = own * moved_by(svg_place(properties, style.viewport));
    child = target;
  }
  const std::string_view name = local_name(child);
  if (name == "title" || name == "desc" || name == "metadata") return;
  document_.report_bad(child,
                       fmt::format("<{:.40}> in a clip path is ignored", name),
                       "make it a path; content that it clips may be left out");
}

void SvgClips::enter_viewport(const pugi::xml_node& node, const Place& size, SvgStyle& style) {
  const std::string_view overflow = document_.properties_of(node).get("overflow");
  if (overflow == "visible" || overflow == "auto") return;
  ClipRegion clip{.name = fmt::format("edge of the viewport of {}", document_.entity_of(node).name),
                  .remedy = "give it overflow=\"visible\", or cut the shape there",
                  .areas{}};
  SvgSubpaths edge{rectangle(size)};
  transform(edge, style.to_mm);
  clip.add(edge, FillRule::kNonZero);
  style.clips.push_back(std::make_shared<const ClipRegion>(std::move(clip)));
}

void SvgClips::keep_visible(const pugi::xml_node& node,
                            const SvgStyle& style,
                            SvgSubpaths& subpaths) {
  if (style.clips.empty()) return;
  std::erase_if(subpaths, [&](const std::vector<Shape>& shapes) {
    return !shapes.empty() && !is_visible(node, style, shapes);
  });
}

bool SvgClips::is_visible(const pugi::xml_node& node,
                          const SvgStyle& style,
                          const std::vector<Shape>& shapes) {
  std::optional<FillRule> fill;
  if (style.has_fill()) fill = fill_rule_of(style.fill_rule);
  const auto [sight, clip] = comparison_.compare(shapes, style.clips, fill);
  if (sight == Sight::kTooMuch) {
    document_.report_bad(node, "its clip has too many curves to be compared", kReleaseClip);
  } else if (sight == Sight::kNothing) {
    sketch_.ignore("shapes outside of their clip are not visible", document_.entity_of(node));
  } else if (sight == Sight::kPart) {
    document_.report_bad(
        node, fmt::format("it crosses the {} and is left out", clip->name), clip->remedy);
  }
  return sight == Sight::kWhole;
}

}  // namespace sim::drawing
