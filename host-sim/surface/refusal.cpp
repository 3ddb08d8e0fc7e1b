#include "host-sim/surface/refusal.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace sim::surface {

void refuse(const std::string& name,
            std::size_t line,
            std::string_view reason,
            std::string_view remedy) {
  if (line == 0) throw std::invalid_argument(fmt::format("{}: {}; {}", name, reason, remedy));
  throw std::invalid_argument(fmt::format("{}:{}: {}; {}", name, line, reason, remedy));
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string safe{text.substr(0, kLongest)};
  for (char& c : safe) {
    if (c < ' ' || c > '~') c = '?';
  }
  if (text.size() > kLongest) safe += "...";
  return safe;
}

}  // namespace sim::surface
