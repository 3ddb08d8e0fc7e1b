#include "host-sim/import/dxf_group.hpp"

#include <algorithm>
#include <charconv>

namespace sim::drawing {
namespace {

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view kAround = " \t\r";
  const std::size_t from = text.find_first_not_of(kAround);
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(kAround) - from + 1);
}

/// Returns whether a code has values that are coordinates, lengths, angles or flags.
bool is_number_code(int code) { return (code >= 10 && code < 100) || (code >= 210 && code < 240); }

}  // namespace

std::string_view DxfCursor::take_line() {
  const std::size_t end = rest_.find('\n');
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++line_;
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

std::optional<DxfGroup> DxfCursor::next() {
  if (rest_.empty() || !bad_code_.empty()) return {};
  const std::string_view code = without_blanks(take_line());
  if (rest_.empty()) return {};
  DxfGroup group;
  const auto [stop, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
  if (error != std::errc{} || stop != code.data() + code.size()) {
    bad_code_ = code.empty() ? "an empty line" : code;
    return {};
  }
  group.raw = take_line();
  group.value = without_blanks(group.raw);
  group.line = line_;
  return group;
}

std::optional<double> dxf_number(std::string_view value) {
  if (value.starts_with('+')) value.remove_prefix(1);
  double number = 0.0;
  const auto [stop, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc{} || stop != value.data() + value.size()) return {};
  if (!std::isfinite(number)) return {};
  return number;
}

std::string_view DxfEntity::text(int code) const {
  const auto found = std::ranges::find(groups, code, &DxfGroup::code);
  return found == groups.end() ? std::string_view{} : found->value;
}

std::optional<double> DxfEntity::number(int code) const {
  const auto found = std::ranges::find(groups, code, &DxfGroup::code);
  if (found == groups.end()) return {};
  return dxf_number(found->value);
}

double DxfEntity::number(int code, double otherwise) const {
  return number(code).value_or(otherwise);
}

int DxfEntity::whole(int code, int otherwise) const {
  const auto found = number(code);
  return found ? static_cast<int>(std::clamp(*found, -1.0e9, 1.0e9)) : otherwise;
}

Place DxfEntity::place(int code) const { return {number(code, 0.0), number(code + 10, 0.0)}; }

std::vector<double> DxfEntity::numbers(int code) const {
  std::vector<double> all;
  for (const DxfGroup& group : groups) {
    if (group.code == code) all.push_back(dxf_number(group.value).value_or(0.0));
  }
  return all;
}

std::vector<Place> DxfEntity::places(int code) const {
  std::vector<Place> all;
  for (const DxfGroup& group : groups) {
    const double value = dxf_number(group.value).value_or(0.0);
    if (group.code == code) all.emplace_back(value, 0.0);
    if (group.code == code + 10 && !all.empty()) all.back().y() = value;
  }
  return all;
}

void DxfEntity::drop_part(std::string_view subclass) {
  constexpr int kSubclass = 100;
  const auto found = std::ranges::find_if(groups, [&](const DxfGroup& group) {
    return group.code == kSubclass && group.value == subclass;
  });
  groups.erase(found, groups.end());
}

const DxfGroup* DxfEntity::bad_number() const {
  const auto bad = [](const DxfGroup& group) {
    return is_number_code(group.code) && !dxf_number(group.value);
  };
  const auto found = std::ranges::find_if(groups, bad);
  return found == groups.end() ? nullptr : &*found;
}

}  // namespace sim::drawing
