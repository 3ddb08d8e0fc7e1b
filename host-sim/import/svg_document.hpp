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

/// An SVG document, with its elements by id, its style sheets, and the positions of both in the
/// file.
class SvgDocument {
 public:
  SvgDocument(const std::string& source, Sketch& sketch);

  /// Parses the file. Returns false, and reports a fault, if the file is no SVG document.
  [[nodiscard]] bool load();
  [[nodiscard]] pugi::xml_node root() const { return document_.document_element(); }

  /// Returns the first element with an id; an empty node if there is none.
  [[nodiscard]] pugi::xml_node find(std::string_view id) const;
  /// Returns the element of this document that `href` or `xlink:href` names; an empty node if there
  /// is none.
  [[nodiscard]] pugi::xml_node linked(const pugi::xml_node& node) const;
  [[nodiscard]] SvgProperties properties_of(const pugi::xml_node& node);

  /// Returns the entity for an element: its name with its id, and its position in the file.
  [[nodiscard]] Entity entity_of(const pugi::xml_node& node) const;
  void report_bad(const pugi::xml_node& node, std::string reason, std::string remedy);

  /// Counts an element that is drawn. Returns false if there are too many elements. Reports a fault
  /// at the first element beyond the limit.
  [[nodiscard]] bool count(const pugi::xml_node& node);
  [[nodiscard]] bool is_full() const { return elements_ > max_elements_ || sketch_.full(); }

 private:
  void read_sheet(const pugi::xml_node& style);
  void read_sheet_text(const pugi::xml_node& style, const pugi::xml_node& text);

  Sketch& sketch_;
  SvgMarkup markup_;
  pugi::xml_document document_;
  std::unordered_map<std::string_view, pugi::xml_node> ids_;
  SvgCascade cascade_;
  std::size_t max_elements_;
  std::size_t elements_ = 0;
  bool told_of_steps_ = false;
};

/// Returns the value of `href`, or that of `xlink:href` if there is no `href`.
[[nodiscard]] std::string_view svg_link(const pugi::xml_node& node);

/// Returns whether an element belongs to SVG. Drawing programs add elements of other vocabularies.
[[nodiscard]] bool is_svg_element(const pugi::xml_node& node);

}  // namespace sim::drawing
