#pragma once

#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "host-sim/import/svg_clips.hpp"
#include "host-sim/import/svg_document.hpp"
#include "host-sim/import/svg_style.hpp"

namespace sim::drawing {

/// Reads `image` elements: pictures within the document, or in files below its folder. Their layers
/// have the colour kPictureColour.
class SvgImages {
 public:
  SvgImages(SvgDocument& document, Sketch& sketch, SvgClips& clips)
      : document_{document}, sketch_{sketch}, clips_{clips} {}

  /// Keeps the picture of an element; what cannot be read is reported.
  void read(const pugi::xml_node& node, const SvgProperties& properties, SvgStyle style);

 private:
  using Image = std::shared_ptr<const picture::GreyImage>;

  /// A picture by its link; null where it cannot be read.
  struct Linked {
    Image image{};
    std::string file{};
  };

  const Linked& linked(std::string_view link, const Entity& entity);
  Linked embedded(std::string_view data, const Entity& entity);
  Linked beside(std::string_view link, const Entity& entity);
  /// Returns the map of the picture's pixels; nothing where it has no size.
  [[nodiscard]] std::optional<Transform> map_of(const pugi::xml_node& node,
                                                const SvgProperties& properties,
                                                const picture::GreyImage& image,
                                                SvgStyle& style);
  /// Returns what is seen of a picture within the clips of the style; null where it is nothing, or
  /// too much to find out.
  [[nodiscard]] Image clipped(const Image& image,
                              const Transform& to_mm,
                              const SvgStyle& style,
                              const Entity& entity);

  SvgDocument& document_;
  Sketch& sketch_;
  SvgClips& clips_;
  std::map<std::string_view, Linked> linked_;  ///< By links, which the document has.
  std::size_t clip_steps_ = 0;
};

}  // namespace sim::drawing
