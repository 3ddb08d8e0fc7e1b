#include "host-sim/surface/xyz_dialect.hpp"

#include <algorithm>
#include <limits>

#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::surface {
namespace {

std::string_view without_quotes(std::string_view field) {
  field = without_blanks_around(field);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
    field = without_blanks_around(field.substr(1, field.size() - 2));
  }
  return field;
}

/// Returns whether blanks separate at least three numbers of `line`. Commas in the line are then
/// decimal marks.
bool has_decimal_commas(std::string_view line) {
  const XyzFields words = XyzDialect{' ', true}.split(line);
  if (words.count < 3) return false;
  const auto is_number = [](std::string_view word) {
    return word.back() != ',' && word.front() != ',' && parsed_comma_number(word).has_value();
  };
  // The first field may be a name, so only the second and the third field are checked.
  return std::all_of(words.fields.begin() + 1, words.fields.begin() + 3, is_number);
}

void add_field(XyzFields& fields, std::string_view field) {
  if (fields.count < XyzFields::kMax) fields.fields[fields.count] = field;
  ++fields.count;
}

}  // namespace

XyzFields XyzDialect::split(std::string_view line) const {
  XyzFields found;
  std::size_t filled = 0;
  while (!line.empty()) {
    std::size_t end = separator == ' ' ? line.find_first_of(" \t") : line.find(separator);
    end = std::min(end, line.size());
    const std::string_view field = without_quotes(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
    if (separator == ' ' && field.empty()) continue;
    add_field(found, field);
    if (!field.empty()) filled = found.count;
  }
  found.count = filled;
  return found;
}

std::optional<double> XyzDialect::number(std::string_view field) const {
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  return decimal_comma ? parsed_comma_number(field) : parsed_number(field);
}

XyzDialect dialect_of(std::string_view text) {
  TextLines lines{text};
  while (const auto next = lines.next()) {
    const std::string_view line = without_comment(*next);
    if (line.find_first_of("0123456789") == std::string_view::npos) continue;
    if (line.find(';') != std::string_view::npos) return {';', true};
    if (line.find(',') == std::string_view::npos) continue;
    return has_decimal_commas(line) ? XyzDialect{' ', true} : XyzDialect{',', false};
  }
  return {};
}

std::string_view without_comment(std::string_view line) {
  line = line.substr(0, line.find('#'));
  return without_blanks_around(line.substr(0, line.find("//")));
}

}  // namespace sim::surface
