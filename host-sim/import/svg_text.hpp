#pragma once

#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/svg_clips.hpp"
#include "host-sim/import/svg_document.hpp"
#include "host-sim/import/svg_style.hpp"
#include "host-sim/text/lettering.hpp"

namespace sim::drawing {

/// Lays out the letters of a `text` element, with its lines, spans and positions, as outlines or
/// strokes.
class SvgText {
 public:
  SvgText(SvgDocument& document, Sketch& sketch, SvgClips& clips)
      : document_{document}, sketch_{sketch}, clips_{clips} {}

  /// Draws a `text` element. Notes report properties that are not followed.
  void read(const pugi::xml_node& node, const SvgStyle& style);

 private:
  /// A letter, and the positions, offsets and rotation that attributes give to it.
  struct Character {
    std::string bytes;
    std::size_t span;
    std::optional<double> x{};
    std::optional<double> y{};
    double dx = 0.0;
    double dy = 0.0;
    double rotate_deg = 0.0;
  };
  /// A run of letters that have the same style.
  struct Span {
    pugi::xml_node node;
    SvgStyle style;
  };
  struct Glyph {
    std::size_t span;
    text::Strokes strokes;
    Place at;
    double rotate_deg;
  };

  void collect(const pugi::xml_node& node, const SvgStyle& style);
  void collect_child(const pugi::xml_node& child, const SvgStyle& style);
  void append(std::string_view text, std::size_t span);
  void move_characters(const SvgProperties& properties,
                       const SvgViewport& viewport,
                       std::size_t from);
  void note_unfollowed(const pugi::xml_node& node, const SvgProperties& properties);
  /// Lays out the characters of the chunk that begins at the index `from`. Returns the index at
  /// which the next chunk begins.
  std::size_t lay_chunk(std::size_t from);
  /// Lays out the characters from the index `from` up to, but not including, `to`, which belong to
  /// one span.
  void lay_run(std::size_t from, std::size_t to, std::vector<Glyph>& glyphs);
  void draw(const std::vector<Glyph>& glyphs, double shift);

  SvgDocument& document_;
  Sketch& sketch_;
  SvgClips& clips_;
  std::vector<Span> spans_;
  std::vector<Character> characters_;
  Place pen_{0.0, 0.0};
};

}  // namespace sim::drawing
