#include "host-sim/machine/five_axis_question.hpp"

#include <charconv>
#include <cstdint>

#include "host-sim/machine/five_axis_model.hpp"

namespace sim {

void FiveAxisQuestion::hear(std::string_view statement) {
  const std::size_t equals = statement.find('=');
  if (!statement.starts_with('$') || equals == std::string_view::npos) return;
  std::uint16_t number = 0;
  float value = 0.0F;
  const char* const begin = statement.data();
  const auto [after, fault] = std::from_chars(begin + 1, begin + equals, number);
  if (fault != std::errc{} || after != begin + equals) return;
  const auto read = std::from_chars(begin + equals + 1, begin + statement.size(), value);
  if (read.ec == std::errc{}) static_cast<void>(settings_.set(number, value).ok());
}

Point FiveAxisQuestion::program_for(const Point& axes, double tool_length_mm) const {
  return FiveAxisModel{settings_, tool_length_mm}.program_for(axes);
}

Point FiveAxisQuestion::axes_for(const Point& program, double tool_length_mm) const {
  return FiveAxisModel{settings_, tool_length_mm}.axes_for(program);
}

}  // namespace sim
