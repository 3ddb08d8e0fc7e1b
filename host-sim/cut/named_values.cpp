#include "host-sim/cut/named_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace sim::cut {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace

NamedValues parse_named_values(std::string_view text, std::string place, std::string_view form) {
  const auto refuse = [&place](const std::string& reason) {
    return std::invalid_argument(fmt::format("{}: {}", place, reason));
  };
  // A name may contain colons, as in `a:b: feed=1`. Keys contain none, so the last colon before the
  // first `=` ends the name.
  const std::size_t equals = text.find('=');
  const std::size_t colon = text.rfind(':', equals);
  if (equals == std::string_view::npos || colon == std::string_view::npos) {
    throw refuse(fmt::format("{}: must be a {}", text, form));
  }
  NamedValues named{std::string{trimmed(text.substr(0, colon))}, {}, place};
  std::string_view rest = text.substr(colon + 1);
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    more = comma != std::string_view::npos;
    const std::string_view pair = trimmed(rest.substr(0, comma));
    if (more) rest.remove_prefix(comma + 1);
    const std::size_t split = pair.find('=');
    if (split == std::string_view::npos)
      throw refuse(fmt::format("{}: has no `=`; write key=value", pair));
    if (pair.find('=', split + 1) != std::string_view::npos) {
      throw refuse(fmt::format("{}: has two `=`; put a comma between settings", pair));
    }
    named.values.emplace_back(trimmed(pair.substr(0, split)), trimmed(pair.substr(split + 1)));
  }
  return named;
}

std::vector<NamedValues> read_named_values(const std::string& text,
                                           const std::string& file,
                                           std::string_view form) {
  std::vector<NamedValues> list;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trimmed(std::string_view{text}.substr(begin, end - begin));
    begin = end + 1;
    ++number;
    if (line.empty() || line.front() == '#') continue;
    list.push_back(parse_named_values(line, fmt::format("{}:{}", file, number), form));
  }
  if (list.empty()) throw std::invalid_argument(fmt::format("{}: has no {}", file, form));
  return list;
}

double number_from(
    std::string_view key, std::string_view text, double least, double most, const char* unit) {
  const std::string range = fmt::format("{} to {} {}", least, most, unit);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    throw std::invalid_argument(fmt::format("{}={}: not a number; write {}", key, text, range));
  }
  if (value < least || value > most) {
    throw std::invalid_argument(fmt::format("{}={}: out of range, {}", key, text, range));
  }
  return value;
}

}  // namespace sim::cut
