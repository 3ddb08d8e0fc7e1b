#include "host-sim/import/svg_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <pugixml.hpp>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/svg_clips.hpp"
#include "host-sim/import/svg_document.hpp"
#include "host-sim/import/svg_image.hpp"
#include "host-sim/import/svg_origin.hpp"
#include "host-sim/import/svg_shapes.hpp"
#include "host-sim/import/svg_style.hpp"
#include "host-sim/import/svg_text.hpp"

namespace sim::drawing {
namespace {

constexpr double kMillimetresPerPx = 25.4 / 96.0;
constexpr const char* kMend = "it is left out; correct it";

template <std::size_t count>
bool is_one_of(std::string_view name, const std::array<std::string_view, count>& names) {
  return std::ranges::find(names, name) != names.end();
}

constexpr std::array<std::string_view, 4> kGroups{"g", "a", "switch", "svg"};
constexpr std::array<std::string_view, 7> kLetters{
    "text", "tspan", "textPath", "flowRoot", "flowPara", "altGlyph", "tref"};
// Elements that draw nothing, or only draw where another element refers to them.
constexpr std::array<std::string_view, 15> kSilent{"title",
                                                   "desc",
                                                   "metadata",
                                                   "defs",
                                                   "symbol",
                                                   "style",
                                                   "namedview",
                                                   "linearGradient",
                                                   "radialGradient",
                                                   "pattern",
                                                   "marker",
                                                   "filter",
                                                   "script",
                                                   "mask",
                                                   "clipPath"};

/// Collects the first letters of the texts within an element.
class WordCollector final : public pugi::xml_tree_walker {
 public:
  bool for_each(pugi::xml_node& node) override {
    constexpr std::size_t kEnoughBytes = 200;
    words += node.value();
    return words.size() < kEnoughBytes;
  }
  std::string words;
};

/// Returns the first letters of the texts within an element, at any depth.
std::string words_of(pugi::xml_node node) {
  WordCollector words;
  node.traverse(words);
  return std::move(words.words);
}

/// Returns whether a child of `switch` can be drawn. It must require no extension, and its language
/// must be English or not given.
bool is_taken(const pugi::xml_node& child) {
  if (child.type() != pugi::node_element || child.attribute("requiredExtensions")) return false;
  const pugi::xml_attribute language = child.attribute("systemLanguage");
  if (!language) return true;
  std::string_view list = language.value();
  while (!list.empty()) {
    const std::size_t comma = std::min(list.size(), list.find(','));
    const std::string_view one = css_trimmed(list.substr(0, comma));
    if (one == "en" || one.starts_with("en-")) return true;
    list.remove_prefix(std::min(list.size(), comma + 1));
  }
  return false;
}

OutlineBox box_of(const SvgSubpaths& subpaths) {
  OutlineBox box;
  for (const std::vector<Shape>& shapes : subpaths) {
    for (const Place& place : outline_of(shapes, kClipChordMm)) box.include(place);
  }
  return box;
}

class SvgReader {
 public:
  SvgReader(const std::string& text, Sketch& sketch)
      : document_{text, sketch}, sketch_{sketch}, clips_{document_, sketch} {}

  void read() {
    if (document_.load()) read_root(document_.root());
  }

 private:
  /// Returns the width or height of a document or symbol, or `otherwise` if the attribute is
  /// missing.
  double extent(const pugi::xml_node& node,
                const char* name,
                const SvgViewport& around,
                SvgDirection direction,
                double otherwise) {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute || std::string_view{attribute.value()} == "auto") return otherwise;
    const auto length = svg_length(attribute.value(), around, direction);
    if (length && *length > 0.0) return *length;
    document_.report_bad(
        node, fmt::format("{}=\"{}\" is no size", name, attribute.value()), "give it in mm");
    return otherwise;
  }

  void read_root(const pugi::xml_node& root) {
    const auto box = svg_view_box(root.attribute("viewBox").value());
    SvgStyle style;
    // A drawing without a size is as large as its viewBox, in px.
    const SvgViewport page{box ? box->size.x() : 100.0, box ? box->size.y() : 100.0};
    if (!box && root.attribute("viewBox")) {
      document_.report_bad(root, "the viewBox is no box", "give it as x y width height");
    }
    const double width = extent(root, "width", page, SvgDirection::kAcross, page.width);
    const double height = extent(root, "height", page, SvgDirection::kUpright, page.height);
    style.to_mm = moved_by({0.0, height * kMillimetresPerPx}) *
                  scaled_by(kMillimetresPerPx, -kMillimetresPerPx);
    enter_box(root, {width, height}, style);
    const SvgProperties properties = document_.properties_of(root);
    if (properties.get("display") == "none") return;
    inherit(properties, style);
    read_children(root, style);
  }

  /// Sets the user units for the content of a viewport, by its `viewBox`.
  static void enter_box(const pugi::xml_node& node, const Place& size, SvgStyle& style) {
    const auto box = svg_view_box(node.attribute("viewBox").value());
    style.viewport.width = box ? box->size.x() : size.x();
    style.viewport.height = box ? box->size.y() : size.y();
    if (!box) return;
    const char* const aspect = node.attribute("preserveAspectRatio").value();
    style.to_mm = style.to_mm * svg_fit(*box, {size.x(), size.y()}, aspect);
  }

  /// Sets the layer of the style if a group is a layer. Layers are the groups directly in the
  /// document, and the groups that Inkscape marks as layers.
  static void enter_layer(const pugi::xml_node& node, SvgStyle& style) {
    const std::string_view mode = node.attribute("inkscape:groupmode").value();
    if (mode != "layer" && (style.depth != 1 || local_name(node) != "g")) return;
    const std::string_view label = node.attribute("inkscape:label").value();
    const std::string_view name = label.empty() ? node.attribute("id").value() : label;
    if (!name.empty()) style.layer = name;
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_children(const pugi::xml_node& node, const SvgStyle& style) {
    if (style.depth >= kDeepestNesting) {
      document_.report_bad(
          node, fmt::format("nested deeper than {} groups", kDeepestNesting), "ungroup it");
      return;
    }
    const bool is_switch = local_name(node) == "switch";
    for (const pugi::xml_node& child : node.children()) {
      if (document_.is_full()) return;
      if (child.type() != pugi::node_element || (is_switch && !is_taken(child))) continue;
      read_element(child, style);
      if (is_switch) return;
    }
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_element(const pugi::xml_node& node, SvgStyle style, const pugi::xml_node& use = {}) {
    if (!document_.count(node)) return;
    const std::string_view name = local_name(node);
    if (!is_svg_element(node)) {
      if (!is_one_of(name, kSilent)) refuse_element(node.name(), node);
      return;
    }
    if (is_one_of(name, kSilent)) return;
    const SvgProperties properties = document_.properties_of(node);
    if (properties.get("display") == "none") return;
    ++style.depth;
    inherit(properties, style);
    const auto transform = svg_own_transform(properties, style.viewport);
    if (!transform) {
      const std::string_view text = properties.get("transform");
      return document_.report_bad(
          node, fmt::format("transform=\"{:.40}\" is no transform", text), kMend);
    }
    style.to_mm = style.to_mm * *transform;
    note_effects(node, properties);
    if (is_svg_shape(name)) return read_shape(node, properties, style);
    if (name == "image") return images_.read(node, properties, style);
    clips_.enter(node, properties, {}, style);
    if (is_one_of(name, kGroups)) {
      enter_layer(node, style);
      if (name == "svg") enter_document(node, use, properties, style);
      read_children(node, style);
    } else if (name == "use") {
      read_use(node, properties, style);
    } else if (is_one_of(name, kLetters)) {
      read_letters(node, style);
    } else {
      refuse_element(name, node);
    }
  }

  /// Adds notes about properties that change the appearance of an element and are not supported.
  void note_effects(const pugi::xml_node& node, const SvgProperties& properties) {
    const auto note = [&](const char* name, const char* what) {
      const std::string_view value = properties.get(name);
      if (!value.empty() && value != "none") sketch_.ignore(what, document_.entity_of(node));
    };
    note("mask", "masks are ignored: all of the path is read");
    note("filter", "filters are ignored");
    for (const char* const marker : {"marker", "marker-start", "marker-mid", "marker-end"}) {
      note(marker, "markers of lines are left out");
    }
  }

  /// Enters a nested document. Width and height of the `use` that refers to it take precedence.
  void enter_document(const pugi::xml_node& node,
                      const pugi::xml_node& use,
                      const SvgProperties& properties,
                      SvgStyle& style) {
    const SvgViewport around = style.viewport;
    style.to_mm = style.to_mm * moved_by(svg_place(properties, around));
    const auto length = [&](const char* name, SvgDirection direction, double whole) {
      return extent(use.attribute(name) ? use : node, name, around, direction, whole);
    };
    const Place size{length("width", SvgDirection::kAcross, around.width),
                     length("height", SvgDirection::kUpright, around.height)};
    clips_.enter_viewport(node, size, style);
    enter_box(node, size, style);
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_use(const pugi::xml_node& node, const SvgProperties& properties, SvgStyle style) {
    const std::string_view link = svg_link(node);
    const pugi::xml_node target = document_.linked(node);
    if (!target) {
      return document_.report_bad(node,
                                  fmt::format("no element has the name \"{:.60}\"", link),
                                  "embed the element that it links");
    }
    if (std::ranges::find(used_, target) != used_.end() || style.depth >= kDeepestNesting) {
      return document_.report_bad(
          node, fmt::format("\"{:.60}\" uses itself", link), "remove the circular reference");
    }
    style.to_mm = style.to_mm * moved_by(svg_place(properties, style.viewport));
    used_.push_back(target);
    if (local_name(target) == "symbol") {
      read_symbol(node, target, style);
    } else {
      // NOLINTNEXTLINE(readability-suspicious-call-argument): `node` is the `use` element.
      read_element(target, style, node);
    }
    used_.pop_back();
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_symbol(const pugi::xml_node& use, const pugi::xml_node& symbol, SvgStyle style) {
    const SvgProperties properties = document_.properties_of(symbol);
    if (properties.get("display") == "none") return;
    enter_document(symbol, use, properties, style);
    inherit(properties, style);
    ++style.depth;
    read_children(symbol, style);
  }

  void refuse_element(std::string_view name, const pugi::xml_node& node) {
    sketch_.ignore(fmt::format("<{:.40}> is nothing to cut", name), document_.entity_of(node));
  }

  std::size_t layer_of(const SvgStyle& style) {
    return sketch_.layer({style.layer, style.sorting_colour()});
  }

  /// Returns whether the style paints anything visible. If it does not, adds a note with the
  /// reason, except for an element that is hidden.
  bool is_seen(const pugi::xml_node& node, const SvgStyle& style) {
    if (!style.is_visible) return false;
    if (style.is_clear) {
      sketch_.ignore("shapes of opacity 0", document_.entity_of(node));
    } else if (!style.has_stroke() && !style.has_fill()) {
      sketch_.ignore("shapes with neither stroke nor fill", document_.entity_of(node));
    } else {
      return true;
    }
    return false;
  }

  void read_letters(const pugi::xml_node& node, const SvgStyle& style) {
    if (!is_seen(node, style)) return;
    Entity entity = document_.entity_of(node);
    entity.layer = layer_of(style);
    if (sketch_.text() == TextMode::kSkip || !is_laid_out(node)) {
      return sketch_.leave_out_text(entity, words_of(node));
    }
    text_.read(node, style);
  }

  /// Returns whether an element gives the positions of its letters. Letters that flow within a
  /// region have none.
  static bool is_laid_out(const pugi::xml_node& node) { return local_name(node) == "text"; }

  void read_shape(const pugi::xml_node& node, const SvgProperties& properties, SvgStyle style) {
    if (!is_seen(node, style)) return;
    SvgPen pen;
    const SvgShapeFault wrong = draw_svg_shape(local_name(node), properties, style.viewport, pen);
    if (!wrong.is_error) return sketch_.ignore(wrong.reason, document_.entity_of(node), kMend);
    if (!wrong.reason.empty()) return document_.report_bad(node, wrong.reason, kMend);
    if (local_name(document_.find(svg_reference(style.fill))) == "pattern") {
      sketch_.ignore("patterns are ignored: only the outline of the shape is read",
                     document_.entity_of(node));
    }
    SvgSubpaths& subpaths = pen.subpaths();
    if (properties.has("clip-path")) clips_.enter(node, properties, box_of(subpaths), style);
    for (std::vector<Shape>& shapes : subpaths) {
      for (Shape& shape : shapes) shape = transformed(shape, style.to_mm);
    }
    clips_.keep_visible(node, style, subpaths);
    Entity entity = document_.entity_of(node);
    entity.layer = layer_of(style);
    entity.fill_rule = fill_rule_of(style.fill_rule);
    entity.is_filled = style.has_fill();
    entity.has_outline = style.has_stroke();
    const std::size_t index = sketch_.add_entity(std::move(entity));
    for (std::vector<Shape>& shapes : subpaths) {
      if (!sketch_.add({std::move(shapes), index})) return;
    }
  }

  SvgDocument document_;
  Sketch& sketch_;
  SvgClips clips_;
  SvgText text_{document_, sketch_, clips_};
  SvgImages images_{document_, sketch_, clips_};
  std::vector<pugi::xml_node> used_;
};

}  // namespace

void read_svg(const std::string& text, Sketch& sketch) {
  SvgReader{text, sketch}.read();
  note_burn(sketch, text);
}

}  // namespace sim::drawing
