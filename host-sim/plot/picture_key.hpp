#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// A scale of colours with its numbers.
struct ColourScale {
  std::string heading;          ///< With its unit.
  std::vector<Colour> colours;  ///< From the least number to the greatest, two at least.
  double least = 0.0;
  double most = 1.0;  ///< Above the least.
};

enum class SampleShape : std::uint8_t { kLine, kArea };

/// An entry of a key: what a line or an area of a colour is.
struct KeySample {
  SampleShape shape = SampleShape::kLine;
  std::string colour;
  double width_px = 2.0;
  std::string dashes_px{};
  std::string label;
};

/// The explanations beside a picture.
struct PictureKey {
  std::vector<ColourScale> scales;  ///< One at most is usual.
  std::vector<KeySample> samples;
  std::vector<std::string> notes;  ///< Lines of text below all.
};

/// Appends a key from the top of a box downwards.
void add_key(std::string& out, const Box& box, const PictureKey& key);

/// Returns a multiple of a round step as text, with as many decimals as the step needs.
[[nodiscard]] std::string tick_text(double value, double step);

}  // namespace sim
