#include "host-sim/import/svg_document.hpp"

#include <fmt/format.h>

#include <tuple>
#include <vector>

namespace sim::drawing {
namespace {

// Nested `use` elements may double the number of drawn elements at each level. Without a bound, a
// file of one page could fill the memory.
constexpr std::size_t kMaxElements = 500'000;
constexpr std::size_t kMaxSelectorSteps = 100'000'000;
constexpr std::string_view kSvgNamespace = "http://www.w3.org/2000/svg";

/// Collects the elements that have ids, and the style sheets of the document.
class Collector final : public pugi::xml_tree_walker {
 public:
  explicit Collector(std::unordered_map<std::string_view, pugi::xml_node>& ids) : ids_{ids} {}
  bool for_each(pugi::xml_node& node) override {
    const std::string_view id = node.attribute("id").value();
    if (!id.empty()) ids_.emplace(id, node);
    if (local_name(node) == "style") sheets.push_back(node);
    return true;
  }
  std::vector<pugi::xml_node> sheets;

 private:
  std::unordered_map<std::string_view, pugi::xml_node>& ids_;
};

}  // namespace

std::string_view svg_link(const pugi::xml_node& node) {
  const std::string_view link = node.attribute("href").value();
  return link.empty() ? std::string_view{node.attribute("xlink:href").value()} : link;
}

bool is_svg_element(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos || name.substr(0, colon) == "svg") return true;
  const std::string declares = "xmlns:" + std::string{name.substr(0, colon)};
  for (pugi::xml_node at = node; at; at = at.parent()) {
    const pugi::xml_attribute attribute = at.attribute(declares.c_str());
    if (attribute) return attribute.value() == kSvgNamespace;
  }
  return false;
}

SvgDocument::SvgDocument(const std::string& source, Sketch& sketch)
    : sketch_{sketch},
      markup_{source, sketch},
      cascade_{sketch.share_of(kMaxSelectorSteps)},
      max_elements_{sketch.share_of(kMaxElements)} {}

bool SvgDocument::load() {
  if (markup_.is_too_long()) return false;
  const std::string& text = markup_.text();
  const pugi::xml_parse_result parsed =
      document_.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_ws_pcdata);
  if (!parsed) {
    const auto [line, column] = markup_.at(static_cast<std::size_t>(parsed.offset));
    sketch_.refuse(line,
                   column,
                   fmt::format("broken XML: {}", parsed.description()),
                   "export the drawing again");
    return false;
  }
  if (local_name(root()) != "svg") {
    sketch_.refuse(
        1, 0, fmt::format("the document is <{}>, not <svg>", root().name()), "export it as SVG");
    return false;
  }
  Collector collector{ids_};
  document_.traverse(collector);
  for (const pugi::xml_node& sheet : collector.sheets) read_sheet(sheet);
  return true;
}

void SvgDocument::read_sheet(const pugi::xml_node& style) {
  const std::string_view type = css_trimmed(style.attribute("type").value());
  const std::string_view media = css_trimmed(style.attribute("media").value());
  if ((!type.empty() && type != "text/css") ||
      (!media.empty() && media != "all" && media != "screen")) {
    return sketch_.ignore("style sheets of other types and media are not read", entity_of(style));
  }
  for (const pugi::xml_node& text : style.children()) read_sheet_text(style, text);
}

void SvgDocument::read_sheet_text(const pugi::xml_node& style, const pugi::xml_node& text) {
  const auto report = [&](std::size_t offset, const std::string& what) {
    Entity entity = entity_of(style);
    const std::ptrdiff_t begin = text.offset_debug();
    if (begin >= 0) {
      std::tie(entity.line, entity.column) = markup_.at(static_cast<std::size_t>(begin) + offset);
    }
    sketch_.ignore(what, entity, "export with presentation attributes");
  };
  cascade_.add(svg_rules(text.value(), report));
}

pugi::xml_node SvgDocument::find(std::string_view id) const {
  const auto found = ids_.find(id);
  return found == ids_.end() ? pugi::xml_node{} : found->second;
}

pugi::xml_node SvgDocument::linked(const pugi::xml_node& node) const {
  const std::string_view link = svg_link(node);
  return link.starts_with('#') ? find(link.substr(1)) : pugi::xml_node{};
}

SvgProperties SvgDocument::properties_of(const pugi::xml_node& node) {
  SvgProperties properties = cascade_.properties_of(node);
  if (cascade_.is_exhausted() && !told_of_steps_) {
    told_of_steps_ = true;
    sketch_.report(
        {FaultKind::kTooMuch,
         entity_of(node),
         {},
         "the style sheets have too many rules to be compared; from here on they are ignored",
         "export with presentation attributes"});
  }
  return properties;
}

Entity SvgDocument::entity_of(const pugi::xml_node& node) const {
  Entity entity{.name = std::string{local_name(node)}};
  const std::string_view id = node.attribute("id").value();
  if (!id.empty()) entity.name += fmt::format(" \"{}\"", id);
  const std::ptrdiff_t offset = node.offset_debug();
  if (offset > 0) {
    std::tie(entity.line, entity.column) = markup_.at(static_cast<std::size_t>(offset - 1));
  }
  return entity;
}

void SvgDocument::report_bad(const pugi::xml_node& node, std::string reason, std::string remedy) {
  sketch_.report(
      {FaultKind::kBadEntity, entity_of(node), {}, std::move(reason), std::move(remedy)});
}

bool SvgDocument::count(const pugi::xml_node& node) {
  if (++elements_ <= max_elements_) return true;
  if (elements_ == max_elements_ + 1) {
    sketch_.report(
        {FaultKind::kTooMuch,
         entity_of(node),
         {},
         fmt::format("the drawing has more than {} elements; the rest is left out", max_elements_),
         "divide the drawing into several files"});
  }
  return false;
}

}  // namespace sim::drawing
