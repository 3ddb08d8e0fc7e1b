#include "host-sim/cut/layer_colour.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

namespace sim::cut {
namespace {

using NamedColour = std::pair<std::string_view, std::uint32_t>;

constexpr std::array<NamedColour, 22> kBasicColours{{
    {"black", 0x000000},   {"silver", 0xC0C0C0},  {"gray", 0x808080},  {"grey", 0x808080},
    {"white", 0xFFFFFF},   {"maroon", 0x800000},  {"red", 0xFF0000},   {"purple", 0x800080},
    {"fuchsia", 0xFF00FF}, {"magenta", 0xFF00FF}, {"green", 0x008000}, {"lime", 0x00FF00},
    {"olive", 0x808000},   {"yellow", 0xFFFF00},  {"navy", 0x000080},  {"blue", 0x0000FF},
    {"teal", 0x008080},    {"aqua", 0x00FFFF},    {"cyan", 0x00FFFF},  {"orange", 0xFFA500},
    {"pink", 0xFFC0CB},    {"brown", 0xA52A2A},
}};

/// Names of basic colours that mean another colour in the LightBurn palette.
constexpr std::array<NamedColour, 6> kPaletteNames{{{"green", 0x00E000},
                                                    {"yellow", 0xD0D000},
                                                    {"orange", 0xFF8000},
                                                    {"cyan", 0x00E0E0},
                                                    {"grey", 0xB4B4B4},
                                                    {"gray", 0xB4B4B4}}};

/// Colours C00 to C29 of the LightBurn palette, 0xRRGGBB.
constexpr std::array<std::uint32_t, 30> kPalette{
    0x000000, 0x0000FF, 0xFF0000, 0x00E000, 0xD0D000, 0xFF8000, 0x00E0E0, 0xFF00FF,
    0xB4B4B4, 0x0000A0, 0xA00000, 0x00A000, 0xA0A000, 0xC08000, 0x00A0FF, 0xA000A0,
    0x808080, 0x7D87B9, 0xBB7784, 0x4A6FE3, 0xD33F6A, 0x8CD78C, 0xF0B98D, 0xF6C4E1,
    0xFA9ED4, 0x500A78, 0xB45A00, 0x004754, 0x86FA88, 0xFFDB66};
constexpr std::array<NamedColour, 2> kToolColours{{{"t1", 0xF36926}, {"t2", 0x0C96D9}}};

/// Colours ACI 1 to 9 of DXF, 0xRRGGBB.
constexpr std::array<std::uint32_t, 9> kAutoCadColours{
    0xFF0000, 0xFFFF00, 0x00FF00, 0x00FFFF, 0x0000FF, 0xFF00FF, 0x000000, 0x808080, 0xC0C0C0};

std::string lower(std::string_view text) {
  std::string result{text};
  std::ranges::transform(
      result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

template <std::size_t kCount>
std::optional<std::uint32_t> found_in(const std::array<NamedColour, kCount>& table,
                                      std::string_view name) {
  for (const auto& [known, colour] : table) {
    if (known == name) return colour;
  }
  return std::nullopt;
}

std::optional<std::uint32_t> whole_number(std::string_view text, int base) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::uint32_t> colour_of_digits(std::string_view digits) {
  const auto value = whole_number(digits, 16);
  if (!value || (digits.size() != 3 && digits.size() != 6)) return std::nullopt;
  if (digits.size() == 6) return value;
  const std::uint32_t red = *value >> 8U;
  const std::uint32_t green = (*value >> 4U) & 0xFU;
  const std::uint32_t blue = *value & 0xFU;
  return 0x11U * ((red << 16U) | (green << 8U) | blue);
}

/// Removes and returns a channel, such as `255` or `100%`, at the beginning of the text, together
/// with commas and blanks before it.
std::optional<std::uint32_t> take_channel(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(", "), text.size()));
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (text.starts_with('%')) {
    value *= 2.55;
    text.remove_prefix(1);
  }
  if (!(value >= 0.0 && value <= 255.0)) return std::nullopt;
  return static_cast<std::uint32_t>(std::lround(value));
}

std::optional<std::uint32_t> colour_of_channels(std::string_view text) {
  std::uint32_t colour = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const auto value = take_channel(text);
    if (!value) return std::nullopt;
    colour = (colour << 8U) | *value;
  }
  return text.find_first_not_of(' ') == text.find(')') ? std::optional{colour} : std::nullopt;
}

/// Returns the colour that a name of the LightBurn palette means, such as `c07` or `t1`.
std::optional<std::uint32_t> palette_colour(std::string_view name) {
  if (name.size() == 3 && name.front() == 'c') {
    const auto number = whole_number(name.substr(1), 10);
    if (number && *number < kPalette.size()) return kPalette[*number];
  }
  return found_in(kToolColours, name);
}

}  // namespace

std::optional<std::uint32_t> colour_from(std::string_view text) {
  const std::string lowered = lower(text);
  const std::string_view view{lowered};
  if (view.starts_with('#')) return colour_of_digits(view.substr(1));
  if (view.starts_with("rgb(")) return colour_of_channels(view.substr(4));
  if (view.starts_with("aci ")) {
    const auto number = whole_number(view.substr(4), 10);
    if (!number || *number == 0 || *number > kAutoCadColours.size()) return std::nullopt;
    return kAutoCadColours[*number - 1];
  }
  return found_in(kBasicColours, view);
}

bool is_colour_named(std::string_view colour, std::string_view name) {
  const auto meant = colour_from(colour);
  if (!meant) return false;
  const std::string lowered = lower(name);
  return colour_from(name) == meant || palette_colour(lowered) == meant ||
         found_in(kPaletteNames, lowered) == meant;
}

}  // namespace sim::cut
