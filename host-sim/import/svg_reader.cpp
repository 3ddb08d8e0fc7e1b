#include "host-sim/import/svg_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <pugixml.hpp>
#include <unordered_map>

#include "host-sim/import/line_table.hpp"
#include "host-sim/import/svg_shapes.hpp"

namespace sim::drawing {
namespace {

constexpr double kMillimetresPerPx = 25.4 / 96.0;
// `use` of `use` doubles them at each level: without a bound, a page of text fills memory.
constexpr std::size_t kMostElements = 500'000;

/// What elements hand down to those within them.
struct Style {
  Transform to_mm;
  SvgViewport viewport;
  std::string layer;
  std::string stroke = "none";
  std::string fill = "black";
  std::string fill_rule = "nonzero";
  bool visible = true;
  std::size_t depth = 0;
};

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name.substr(name.rfind(':') == std::string_view::npos ? 0 : name.rfind(':') + 1);
}

template <std::size_t count>
bool is_one_of(std::string_view name, const std::array<std::string_view, count>& names) {
  return std::ranges::find(names, name) != names.end();
}

constexpr std::array<std::string_view, 4> kGroups{"g", "a", "switch", "svg"};
constexpr std::array<std::string_view, 7> kLetters{
    "text", "tspan", "textPath", "flowRoot", "flowPara", "altGlyph", "tref"};
// Drawn by nothing, or only where something names them.
constexpr std::array<std::string_view, 14> kSilent{"title",
                                                   "desc",
                                                   "metadata",
                                                   "defs",
                                                   "symbol",
                                                   "namedview",
                                                   "linearGradient",
                                                   "radialGradient",
                                                   "pattern",
                                                   "marker",
                                                   "filter",
                                                   "script",
                                                   "mask",
                                                   "clipPath"};

class IdCollector final : public pugi::xml_tree_walker {
 public:
  bool for_each(pugi::xml_node& node) override {
    const std::string_view id = node.attribute("id").value();
    if (!id.empty()) ids.emplace(id, node);
    return true;
  }
  std::unordered_map<std::string_view, pugi::xml_node> ids;
};

class SvgReader {
 public:
  SvgReader(const std::string& text, Sketch& sketch) : text_{text}, lines_{text}, sketch_{sketch} {}

  void read() {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text_.data(), text_.size());
    if (!parsed) {
      const auto [line, column] = lines_.at(static_cast<std::size_t>(parsed.offset));
      sketch_.refuse(line,
                     column,
                     fmt::format("broken XML: {}", parsed.description()),
                     "export the drawing again");
      return;
    }
    const pugi::xml_node root = document.document_element();
    if (local_name(root) != "svg") {
      sketch_.refuse(
          1, 0, fmt::format("the document is <{}>, not <svg>", root.name()), "export it as SVG");
      return;
    }
    document.traverse(ids_);
    read_root(root);
  }

 private:
  [[nodiscard]] Entity entity_of(const pugi::xml_node& node) const {
    Entity entity{.name = std::string{local_name(node)}};
    const std::string_view id = node.attribute("id").value();
    if (!id.empty()) entity.name += fmt::format(" \"{}\"", id);
    const std::ptrdiff_t offset = node.offset_debug();
    if (offset > 0)
      std::tie(entity.line, entity.column) = lines_.at(static_cast<std::size_t>(offset - 1));
    return entity;
  }

  void bad(const pugi::xml_node& node, std::string reason, std::string remedy) {
    sketch_.report(
        {FaultKind::kBadEntity, entity_of(node), {}, std::move(reason), std::move(remedy)});
  }

  /// A length of a document or symbol, or what it is without one.
  double extent(const pugi::xml_node& node,
                const char* name,
                const SvgViewport& around,
                SvgDirection direction,
                double otherwise) {
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute || std::string_view{attribute.value()} == "auto") return otherwise;
    const auto length = svg_length(attribute.value(), around, direction);
    if (length && *length > 0.0) return *length;
    bad(node, fmt::format("{}=\"{}\" is no size", name, attribute.value()), "give it in mm");
    return otherwise;
  }

  void read_root(const pugi::xml_node& root) {
    const auto box = svg_view_box(root.attribute("viewBox").value());
    // Without a size a drawing is as large as its box says, in px.
    const SvgViewport page{box ? box->size.x() : 100.0, box ? box->size.y() : 100.0};
    if (!box && root.attribute("viewBox")) {
      bad(root, "the viewBox is no box", "give it as x y width height");
    }
    const double width = extent(root, "width", page, SvgDirection::kAcross, page.width);
    const double height = extent(root, "height", page, SvgDirection::kUpright, page.height);
    Style style;
    style.to_mm = moved_by({0.0, height * kMillimetresPerPx}) *
                  scaled_by(kMillimetresPerPx, -kMillimetresPerPx);
    style.viewport = {width, height};
    enter_box(root, {width, height}, style);
    inherit(root, style);
    read_children(root, style);
  }

  /// The units of what is in a viewport.
  static void enter_box(const pugi::xml_node& node, const SvgViewport& viewport, Style& style) {
    style.viewport = viewport;
    const auto box = svg_view_box(node.attribute("viewBox").value());
    if (!box) return;
    const char* const aspect = node.attribute("preserveAspectRatio").value();
    style.to_mm = style.to_mm * svg_fit(*box, viewport, aspect);
    style.viewport = {box->size.x(), box->size.y()};
  }

  static void inherit(const pugi::xml_node& node, Style& style) {
    const auto take = [&node](const char* name, std::string& into) {
      const std::string value = svg_property(node, name);
      if (!value.empty() && value != "inherit") into = value;
    };
    take("stroke", style.stroke);
    take("fill", style.fill);
    take("fill-rule", style.fill_rule);
    std::string visibility;
    take("visibility", visibility);
    if (!visibility.empty()) style.visible = visibility == "visible";
  }

  /// Layers are the groups of the document itself, and what Inkscape calls layers.
  static void enter_layer(const pugi::xml_node& node, Style& style) {
    const std::string_view mode = node.attribute("inkscape:groupmode").value();
    if (mode != "layer" && (style.depth != 1 || local_name(node) != "g")) return;
    const std::string_view label = node.attribute("inkscape:label").value();
    const std::string_view name = label.empty() ? node.attribute("id").value() : label;
    if (!name.empty()) style.layer = name;
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_children(const pugi::xml_node& node, const Style& style) {
    if (style.depth >= kDeepestNesting) {
      bad(node, fmt::format("nested deeper than {} groups", kDeepestNesting), "ungroup it");
      return;
    }
    for (const pugi::xml_node& child : node.children()) {
      if (sketch_.full() || elements_ > most_elements_) return;
      if (child.type() == pugi::node_element) read_element(child, style);
    }
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_element(const pugi::xml_node& node, Style style) {
    if (++elements_ > most_elements_) {
      sketch_.report(
          {FaultKind::kTooMuch,
           entity_of(node),
           {},
           fmt::format("more than {} elements are drawn; the rest is left out", most_elements_),
           "cut the drawing in parts"});
      return;
    }
    const std::string_view name = local_name(node);
    if (is_one_of(name, kSilent) || svg_property(node, "display") == "none") return;
    ++style.depth;
    inherit(node, style);
    if (!enter_transform(node, style)) return;
    if (node.attribute("clip-path") || node.attribute("mask")) {
      sketch_.ignore("clips and masks: all of the path is read", entity_of(node));
    }
    if (is_svg_shape(name)) {
      read_shape(name, node, style);
    } else if (is_one_of(name, kGroups)) {
      enter_layer(node, style);
      if (name == "svg") enter_document(node, style);
      read_children(node, style);
    } else if (name == "use") {
      read_use(node, style);
    } else {
      refuse_element(name, node, style);
    }
  }

  bool enter_transform(const pugi::xml_node& node, Style& style) {
    const pugi::xml_attribute attribute = node.attribute("transform");
    if (!attribute) return true;
    const auto transform = svg_transform(attribute.value());
    if (!transform) {
      bad(node,
          fmt::format("transform=\"{:.40}\" is no transform", attribute.value()),
          "it is left out; mend it");
      return false;
    }
    style.to_mm = style.to_mm * *transform;
    return true;
  }

  /// A document within the document, or a symbol.
  void enter_document(const pugi::xml_node& node, Style& style) {
    const auto length = [&](const char* name, SvgDirection direction) {
      return svg_length(node.attribute(name).value(), style.viewport, direction).value_or(0.0);
    };
    const SvgViewport around = style.viewport;
    style.to_mm = style.to_mm * moved_by({length("x", SvgDirection::kAcross),
                                          length("y", SvgDirection::kUpright)});
    enter_box(node,
              {extent(node, "width", around, SvgDirection::kAcross, around.width),
               extent(node, "height", around, SvgDirection::kUpright, around.height)},
              style);
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_use(const pugi::xml_node& node, Style style) {
    std::string_view link = node.attribute("href").value();
    if (link.empty()) link = node.attribute("xlink:href").value();
    const auto found = link.starts_with('#') ? ids_.ids.find(link.substr(1)) : ids_.ids.end();
    if (found == ids_.ids.end()) {
      bad(node, fmt::format("nothing is called \"{:.60}\"", link), "embed what it links");
      return;
    }
    const pugi::xml_node& target = found->second;
    if (std::ranges::find(used_, target) != used_.end() || style.depth >= kDeepestNesting) {
      bad(node, fmt::format("\"{:.60}\" uses itself", link), "take the circle apart");
      return;
    }
    const auto length = [&](const char* name, SvgDirection direction) {
      return svg_length(node.attribute(name).value(), style.viewport, direction).value_or(0.0);
    };
    style.to_mm = style.to_mm * moved_by({length("x", SvgDirection::kAcross),
                                          length("y", SvgDirection::kUpright)});
    used_.push_back(target);
    if (local_name(target) == "symbol") {
      read_symbol(node, target, style);
    } else {
      read_element(target, style);
    }
    used_.pop_back();
  }

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void read_symbol(const pugi::xml_node& use, const pugi::xml_node& symbol, Style style) {
    const SvgViewport around = style.viewport;
    enter_box(symbol,
              {extent(use, "width", around, SvgDirection::kAcross, around.width),
               extent(use, "height", around, SvgDirection::kUpright, around.height)},
              style);
    inherit(symbol, style);
    ++style.depth;
    read_children(symbol, style);
  }

  void refuse_element(std::string_view name, const pugi::xml_node& node, const Style& style) {
    if (is_one_of(name, kLetters)) {
      if (!style.visible) return;
      sketch_.report({FaultKind::kText,
                      entity_of(node),
                      {},
                      "letters are no paths",
                      "convert text to paths in the drawing program"});
    } else if (name == "style") {
      sketch_.ignore("style rules: colours and hiding by class are not read",
                     entity_of(node),
                     "export with presentation attributes");
    } else {
      sketch_.ignore(fmt::format("<{:.40}> is nothing to cut", name), entity_of(node));
    }
  }

  void read_shape(std::string_view name, const pugi::xml_node& node, const Style& style) {
    if (!style.visible) return;
    Entity entity = entity_of(node);
    if (style.stroke == "none" && style.fill == "none") {
      sketch_.ignore("shapes with neither stroke nor fill", entity);
      return;
    }
    // Lines that fill nothing have no rule.
    const bool is_nonzero = style.fill != "none" && style.fill_rule != "evenodd";
    entity.rule = is_nonzero ? FillRule::kNonzero : FillRule::kEvenOdd;
    SvgPen pen;
    const std::string wrong = draw_svg_shape(name, node, style.viewport, pen);
    if (!wrong.empty()) return bad(node, wrong, "it is left out; mend it");
    entity.layer = sketch_.layer({style.layer, style.stroke != "none" ? style.stroke : style.fill});
    const std::size_t index = sketch_.add_entity(std::move(entity));
    for (std::vector<Shape>& shapes : pen.subpaths()) {
      for (Shape& shape : shapes) shape = transformed(shape, style.to_mm);
      if (!sketch_.add({std::move(shapes), index})) return;
    }
  }

  const std::string& text_;
  LineTable lines_;
  Sketch& sketch_;
  IdCollector ids_;
  std::vector<pugi::xml_node> used_;
  std::size_t most_elements_ = sketch_.share_of(kMostElements);
  std::size_t elements_ = 0;
};

}  // namespace

void read_svg(const std::string& text, Sketch& sketch) { SvgReader{text, sketch}.read(); }

}  // namespace sim::drawing
