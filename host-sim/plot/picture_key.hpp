#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// A scale of colours with numbers.
struct ColourScale {
  std::string heading;  ///< Heading of the scale, with the unit of its numbers.
  /// Colours, from the colour of the smallest number to the colour of the greatest; at least two.
  std::vector<Colour> colours;
  double least = 0.0;
  double most = 1.0;  ///< Greatest number of the scale, above `least`.
};

enum class SampleShape : std::uint8_t { kLine, kArea };

/// An entry of a key, which explains a line or an area of some colour.
struct KeySample {
  SampleShape shape = SampleShape::kLine;
  std::string colour;
  double width_px = 2.0;
  std::string dashes_px{};
  std::string label;
};

/// The key of a picture: the explanations next to it.
struct PictureKey {
  std::vector<ColourScale> scales;  ///< Scales of colours; usually at most one.
  std::vector<KeySample> samples;
  std::vector<std::string> notes;  ///< Notes, which are lines of text at the bottom of the key.
};

/// Appends a key, from the top of a box downwards.
void add_key(std::string& out, const Box& box, const PictureKey& key);

/// Returns a multiple of a round step as text, with as many decimals as the step has.
[[nodiscard]] std::string tick_text(double value, double step);

}  // namespace sim
