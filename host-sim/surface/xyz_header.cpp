#include "host-sim/surface/xyz_header.hpp"

namespace sim::surface {
namespace {

/// Returns 0, 1 or 2 if `name` is the name of X, Y or Z, else 3.
std::size_t axis_of_name(std::string_view name) {
  if (name.empty()) return 3;
  const char letter = name.front() >= 'X' && name.front() <= 'Z'
                          ? static_cast<char>(name.front() - 'X' + 'x')
                          : name.front();
  if (letter < 'x' || letter > 'z') return 3;
  const bool alone =
      name.size() == 1 || std::string_view{" _[(/:"}.find(name[1]) != std::string_view::npos;
  return alone ? static_cast<std::size_t>(letter - 'x') : 3;
}

}  // namespace

std::optional<XyzColumns> columns_of_header(const XyzFields& header) {
  XyzColumns columns{};
  std::array<std::size_t, 4> found{};
  for (std::size_t i = 0; i < header.listed(); ++i) {
    const std::size_t axis = axis_of_name(header.fields[i]);
    ++found[axis];
    if (axis < 3) columns[axis] = i;
  }
  if (found[0] != 1 || found[1] != 1 || found[2] != 1) return {};
  return columns;
}

}  // namespace sim::surface
