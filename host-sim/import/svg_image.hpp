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

/// Reads `image` elements, whose pictures are in the document itself or in files below the folder
/// of the document. The layers of pictures get the colour kPictureColour.
class SvgImages {
 public:
  SvgImages(SvgDocument& document, Sketch& sketch, SvgClips& clips)
      : document_{document}, sketch_{sketch}, clips_{clips} {}

  /// Adds the picture of an element to the sketch. Reports a picture that cannot be read.
  void read(const pugi::xml_node& node, const SvgProperties& properties, SvgStyle style);

 private:
  using Image = std::shared_ptr<const picture::GreyImage>;

  /// A picture to which the document links; the image is null if it cannot be read.
  struct Linked {
    Image image{};
    std::string file{};
  };

  const Linked& linked(std::string_view link, const Entity& entity);
  Linked embedded(std::string_view data, const Entity& entity);
  Linked beside(std::string_view link, const Entity& entity);
  /// Returns the map from pixels of the picture to mm; nothing if the element has no size.
  [[nodiscard]] std::optional<Transform> map_of(const pugi::xml_node& node,
                                                const SvgProperties& properties,
                                                const picture::GreyImage& image,
                                                SvgStyle& style);
  /// Returns the part of a picture that is visible within the clips of the style. Returns null if
  /// nothing is visible, or if the comparison would take too much work.
  [[nodiscard]] Image clipped(const Image& image,
                              const Transform& to_mm,
                              const SvgStyle& style,
                              const Entity& entity);

  SvgDocument& document_;
  Sketch& sketch_;
  SvgClips& clips_;
  /// Pictures, keyed by link. The document owns the characters of the keys.
  std::map<std::string_view, Linked> linked_;
  std::size_t clip_steps_ = 0;
};

}  // namespace sim::drawing
