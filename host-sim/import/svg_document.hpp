#pragma once

#include <cstddef>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>

#include "host-sim/import/sketch.hpp"
#include "host-sim/import/svg_cascade.hpp"
#include "host-sim/import/svg_markup.hpp"

namespace sim::drawing {

/// An SVG document: its elements by id, its style sheets, and the places of both in the file.
class SvgDocument {
 public:
  SvgDocument(const std::string& source, Sketch& sketch);

  /// Parses the file. False, and a fault, where it is no SVG document.
  [[nodiscard]] bool load();
  [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }

  /// Returns the first element of an id; none where there is none.
  [[nodiscard]] pugi::xml_node find(std::string_view id) const;
  /// Returns the element that `href` or `xlink:href` names in this document; else none.
  [[nodiscard]] pugi::xml_node linked(const pugi::xml_node& node) const;
  [[nodiscard]] SvgProperties properties_of(const pugi::xml_node& node);

  /// Returns name, id and place of an element.
  [[nodiscard]] Entity entity_of(const pugi::xml_node& node) const;
  void report_bad(const pugi::xml_node& node, std::string reason, std::string remedy);

  /// Counts an element that is drawn. False where there are too many; the first of them is a fault.
  [[nodiscard]] bool count(const pugi::xml_node& node);
  [[nodiscard]] bool is_full() const { return elements_ > most_elements_ || sketch_.full(); }

 private:
  void read_sheet(const pugi::xml_node& style);
  void read_sheet_text(const pugi::xml_node& style, const pugi::xml_node& text);

  Sketch& sketch_;
  SvgMarkup markup_;
  pugi::xml_document document_;
  std::unordered_map<std::string_view, pugi::xml_node> ids_;
  SvgCascade cascade_;
  std::size_t most_elements_;
  std::size_t elements_ = 0;
  bool told_of_steps_ = false;
};

/// Returns `href`, or else `xlink:href`.
[[nodiscard]] std::string_view svg_link(const pugi::xml_node& node);

/// Returns whether an element is one of SVG's, and not of a drawing program's own.
[[nodiscard]] bool is_svg_element(const pugi::xml_node& node);

}  // namespace sim::drawing
