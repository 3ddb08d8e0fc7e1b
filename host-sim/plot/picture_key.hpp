#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// A scale of colours with its numbers.
struct ColourScale {
  std::string heading;          ///< Heading with the unit of the numbers.
  std::vector<Colour> colours;  ///< Colours from the smallest number to the greatest; at least two.
  double least = 0.0;
  double most = 1.0;  ///< Greatest number, above `least`.
};

enum class SampleShape : std::uint8_t { kLine, kArea };

/// An entry of a key: the meaning of a line or an area of a colour.
struct KeySample {
  SampleShape shape = SampleShape::kLine;
  std::string colour;
  double width_px = 2.0;
  std::string dashes_px{};
  std::string label;
};

/// The explanations next to a picture.
struct PictureKey {
  std::vector<ColourScale> scales;  ///< Usually at most one.
  std::vector<KeySample> samples;
  std::vector<std::string> notes;  ///< Lines of text at the bottom of the key.
};

/// Appends a key from the top of a box downwards.
void add_key(std::string& out, const Box& box, const PictureKey& key);

/// Returns a multiple of a round step as text, with as many decimals as the step needs.
[[nodiscard]] std::string tick_text(double value, double step);

}  // namespace sim
