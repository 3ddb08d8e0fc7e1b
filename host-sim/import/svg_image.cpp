#include "host-sim/import/svg_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>

#include "host-sim/import/stroke_colour.hpp"
#include "host-sim/import/svg_shapes.hpp"
#include "host-sim/picture/base64.hpp"

namespace sim::drawing {
namespace {

constexpr const char* kEmbed = "embed it in the drawing, or put it in the folder of the drawing";
constexpr std::string_view kDataScheme = "data:";

/// Returns the value of a hexadecimal digit; nothing for another character.
std::optional<int> hex_digit(char c) {
  constexpr int kTen = 10;
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + kTen;
  if (c >= 'A' && c <= 'F') return c - 'A' + kTen;
  return std::nullopt;
}

/// Returns a link in which escapes such as `%20` are replaced by their characters.
std::string unescaped(std::string_view link) {
  constexpr int kHex = 16;
  std::string text;
  text.reserve(link.size());
  for (std::size_t i = 0; i < link.size(); ++i) {
    text += link[i];
    if (link[i] != '%' || i + 2 >= link.size()) continue;
    const auto high = hex_digit(link[i + 1]);
    const auto low = hex_digit(link[i + 2]);
    if (!high || !low) continue;
    text.back() = static_cast<char>(*high * kHex + *low);
    i += 2;
  }
  return text;
}

/// Returns the reason why a link to a picture is not followed; empty if it names a file below the
/// folder of the drawing.
std::string reason_against(std::string_view name) {
  if (name.empty()) return "it links no picture";
  const std::size_t colon = name.find(':');
  if (colon != std::string_view::npos && colon > 1) {
    return fmt::format("\"{:.60}\" is a web address, which is not downloaded", name);
  }
  if (name.starts_with('/') || name.starts_with('\\') || colon == 1) {
    return fmt::format("\"{:.60}\" is a path on another computer, or an absolute path", name);
  }
  for (std::size_t at = 0; at != std::string_view::npos; at = name.find('/', at)) {
    if (name[at] == '/') ++at;
    if (name.substr(at, 2) == ".." && (at + 2 == name.size() || name[at + 2] == '/')) {
      return fmt::format("\"{:.60}\" is not below the folder of the drawing", name);
    }
  }
  return {};
}

bool is_placeable(const Transform& to_mm, const picture::GreyImage& image) {
  const Place far{static_cast<double>(image.width), static_cast<double>(image.height)};
  return to_mm.finite() && to_mm.determinant() != 0.0 &&
         to_mm.origin.cwiseAbs().maxCoeff() <= kFarthestMm &&
         to_mm(far).cwiseAbs().maxCoeff() <= kFarthestMm;
}

}  // namespace

void SvgImages::read(const pugi::xml_node& node, const SvgProperties& properties, SvgStyle style) {
  if (!style.is_visible) return;
  Entity entity = document_.entity_of(node);
  if (style.is_clear) return sketch_.ignore("pictures of opacity 0", entity);
  entity.layer = sketch_.layer({style.layer, std::string{kPictureColour}});
  const Linked& found = linked(svg_link(node), entity);
  if (!found.image) return;
  const auto to_mm = map_of(node, properties, *found.image, style);
  if (!to_mm) return sketch_.ignore("pictures of no size", entity);
  if (!is_placeable(*to_mm, *found.image)) {
    return sketch_.report_bad_picture(
        entity, "it is flat, or farther than 10 km from the origin", "correct its transform");
  }
  Image seen = clipped(found.image, *to_mm, style, entity);
  if (!seen) return;
  sketch_.add(DrawnPicture{std::move(seen), *to_mm, std::move(entity), found.file});
}

const SvgImages::Linked& SvgImages::linked(std::string_view link, const Entity& entity) {
  const auto known = linked_.find(link);
  if (known != linked_.end()) return known->second;
  const bool is_data = link.starts_with(kDataScheme);
  Linked found = is_data ? embedded(link, entity) : beside(link, entity);
  return linked_.emplace(link, std::move(found)).first->second;
}

SvgImages::Linked SvgImages::embedded(std::string_view data, const Entity& entity) {
  const std::size_t comma = data.find(',');
  const std::string_view type = data.substr(0, comma);
  std::optional<std::string> bytes;
  if (comma != std::string_view::npos && type.ends_with(";base64")) {
    bytes = picture::base64_decoded(unescaped(data.substr(comma + 1)));
  }
  if (bytes) return {sketch_.decode(*bytes, entity), {}};
  sketch_.report_bad_picture(
      entity, fmt::format("\"{:.40}\" is no data in base 64", type), "embed it as PNG or JPEG");
  return {};
}

SvgImages::Linked SvgImages::beside(std::string_view link, const Entity& entity) {
  const std::string name = unescaped(link);
  std::string reason = reason_against(name);
  if (reason.empty() && !sketch_.read_beside()) {
    reason = fmt::format("\"{:.60}\" is a separate file, which is not read here", name);
  }
  if (!reason.empty()) {
    sketch_.report_bad_picture(entity, std::move(reason), kEmbed);
    return {};
  }
  try {
    return {sketch_.decode(sketch_.read_beside()(name), entity), name};
  } catch (const std::exception& error) {
    sketch_.report_bad_picture(entity, fmt::format("it cannot be read: {}", error.what()), kEmbed);
    return {};
  }
}

std::optional<Transform> SvgImages::map_of(const pugi::xml_node& node,
                                           const SvgProperties& properties,
                                           const picture::GreyImage& image,
                                           SvgStyle& style) {
  const auto length = [&](const char* name, SvgDirection direction) {
    return svg_length(properties.get(name), style.viewport, direction);
  };
  const Place own{static_cast<double>(image.width), static_cast<double>(image.height)};
  const auto width = length("width", SvgDirection::kAcross);
  const auto height = length("height", SvgDirection::kUpright);
  const Place size{width ? *width : height.value_or(own.y()) * own.x() / own.y(),
                   height ? *height : width.value_or(own.x()) * own.y() / own.x()};
  if (!(size.x() > 0.0) || !(size.y() > 0.0)) return std::nullopt;
  const Place corner = svg_place(properties, style.viewport);
  OutlineBox box;
  box.include(corner);
  box.include(corner + size);
  clips_.enter(node, properties, box, style);
  style.to_mm = style.to_mm * moved_by(corner);
  const std::string_view aspect = properties.get("preserveAspectRatio");
  if (aspect.find("slice") != std::string_view::npos) clips_.enter_viewport(node, size, style);
  const SvgViewBox pixels{{0.0, 0.0}, own};
  return style.to_mm * svg_fit(pixels, {size.x(), size.y()}, aspect);
}

SvgImages::Image SvgImages::clipped(const Image& image,
                                    const Transform& to_mm,
                                    const SvgStyle& style,
                                    const Entity& entity) {
  if (style.clips.empty()) return image;
  for (const auto& clip : style.clips) {
    clip_steps_ += clip->size() * image->height + image->darkness.size();
  }
  if (clip_steps_ > sketch_.share_of(kMaxClipSteps)) {
    sketch_.report_bad_picture(
        entity, "its clip has too many curves to be compared", "crop the picture itself");
    return nullptr;
  }
  auto seen = std::make_shared<picture::GreyImage>(*image);
  for (const auto& clip : style.clips) clip_picture(*seen, to_mm, *clip);
  const bool is_seen = std::ranges::any_of(seen->cover, [](float share) { return share > 0.0F; });
  if (is_seen) return seen;
  sketch_.ignore("pictures outside of their clip are not visible", entity);
  return nullptr;
}

}  // namespace sim::drawing
