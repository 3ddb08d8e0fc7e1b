#include "host-sim/post/program_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace sim::post {

std::vector<cnc::gcode::Word> words_in(std::string_view line) {
  cnc::gcode::LineReader reader{line};
  std::vector<cnc::gcode::Word> words;
  bool is_sound = !reader.begin(false);
  while (is_sound && !reader.at_end()) {
    cnc::gcode::Word word;
    is_sound = !reader.read(word) && !reader.at_more_values();
    words.push_back(word);
  }
  if (is_sound) return words;
  throw std::invalid_argument(
      fmt::format("`{}` is not a line of G-code that a post can write", line));
}

double number_of(const cnc::gcode::Word& word) {
  constexpr double kBillion = 1.0e9;
  const double size = word.value.whole + word.value.billionths / kBillion;
  return word.value.minus ? -size : size;
}

std::string decimal_text(double value, int decimals, bool has_point) {
  const double scale = std::pow(10.0, decimals);
  const double rounded = std::round(value * scale) / scale;
  std::string text = fmt::format("{:.{}f}", rounded == 0.0 ? 0.0 : rounded, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  if (has_point && text.find('.') == std::string::npos) text += '.';
  return text;
}

}  // namespace sim::post
