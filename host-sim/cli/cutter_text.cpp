#include "host-sim/cli/cutter_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace sim {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> words;
  for (;;) {
    const std::size_t end = text.find(separator);
    words.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return words;
    text.remove_prefix(end + 1);
  }
}

/// Words that describe a tool, in the order kind, diameter, other values.
struct CutterWords {
  std::string_view kind = "flat";
  std::string_view diameter;
  std::vector<std::string_view> rest;
};

CutterWords words_of(std::string_view text) {
  CutterWords named;
  const bool has_colons = text.find(':') != std::string_view::npos;
  std::vector<std::string_view> words = split(text, has_colons ? ':' : ',');
  if (has_colons) std::swap(words[0], words[1]);
  named.diameter = words[0];
  if (words.size() < 2) return named;
  named.kind = words[1];
  named.rest.assign(words.begin() + 2, words.end());
  return named;
}

}  // namespace

void refuse_option(const char* option, const std::string& text, std::string_view reason) {
  throw std::invalid_argument(fmt::format("{} {}: {}", option, text, reason));
}

double number_of(const char* option, const std::string& text, std::string_view word) {
  const char* const begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* const end = word.data() + word.size();
  double value = 0.0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (error == std::errc{} && rest == end && std::isfinite(value)) return value;
  refuse_option(option, text, fmt::format("`{}` is no number", word));
}

stock::Cutter cutter_of(const char* option, const std::string& text) {
  const CutterWords words = words_of(text);
  std::vector<double> values;
  values.reserve(words.rest.size());
  for (const std::string_view word : words.rest) values.push_back(number_of(option, text, word));
  stock::Cutter cutter;
  cutter.diameter_mm = number_of(option, text, words.diameter);
  if (words.kind == "flat" && values.empty()) {
    cutter.kind = stock::CutterKind::kFlat;
  } else if (words.kind == "ball" && values.empty()) {
    cutter.kind = stock::CutterKind::kBall;
  } else if (words.kind == "bull" && values.size() == 1) {
    cutter.kind = stock::CutterKind::kBull;
    cutter.corner_radius_mm = values[0];
  } else if (words.kind == "v" && (values.size() == 1 || values.size() == 2)) {
    cutter.kind = stock::CutterKind::kV;
    cutter.included_angle_deg = values[0];
    cutter.tip_diameter_mm = values.size() == 2 ? values[1] : 0.0;
  } else {
    refuse_option(
        option,
        text,
        "must be a diameter in mm and flat, ball, `bull,` and the corner radius in mm, or `v,` "
        "and the included angle in degrees and the tip's diameter, such as 6, 6,ball, "
        "6,bull,0.5 or 6,v,60,0.2; or the kind first, such as ball:6");
  }
  if (const std::string fault = fault_of(cutter); !fault.empty())
    refuse_option(option, text, fault);
  return cutter;
}

}  // namespace sim
