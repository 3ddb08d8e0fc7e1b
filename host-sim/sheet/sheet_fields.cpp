#include "host-sim/sheet/sheet_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host-sim/report/nearest_name.hpp"
#include "host-sim/report/printable.hpp"

namespace sim::sheet {
namespace {

using nlohmann::json;

const json kNoValue{};

/// Returns a value as the file writes it, shortened for a message.
std::string shown(const json& value) {
  constexpr std::size_t kMaxShown = 40;
  std::string text =
      value.dump(-1, ' ', false, json::error_handler_t::replace).substr(0, 4 * kMaxShown);
  text = printable_line(text);
  return text.size() > kMaxShown ? text.substr(0, kMaxShown) + "..." : text;
}

}  // namespace

SheetFields::SheetFields(const json& object,
                         std::string pointer,
                         const std::vector<std::string>& keys,
                         std::vector<drawing::Fault>& faults)
    : object_{object}, pointer_{std::move(pointer)}, faults_{faults} {
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(keys, key) != keys.end()) continue;
    bad(printable_line(key),
        fmt::format(
            "there is no such key; keys are {}{}", fmt::join(keys, ", "), did_you_mean(key, keys)),
        "");
  }
}

bool SheetFields::has(const char* key) const { return object_.contains(key); }

void SheetFields::bad(const std::string& key, std::string reason, std::string remedy) {
  if (faults_.size() >= drawing::kMaxFaults) return;
  const std::string place = key.empty() ? pointer_ : pointer_ + "/" + key;
  faults_.push_back({drawing::FaultKind::kBadEntity,
                     {.name = place.empty() ? "/" : place},
                     {},
                     std::move(reason),
                     std::move(remedy)});
}

double SheetFields::number(const char* key, double otherwise, const FieldRange& range) {
  const auto found = object_.find(key);
  if (found == object_.end()) return otherwise;
  const std::string wanted = fmt::format("write {:.10g} to {:.10g}{}{}",
                                         range.min,
                                         range.max,
                                         *range.unit == '\0' ? "" : " ",
                                         range.unit);
  if (!found->is_number()) {
    bad(key, fmt::format("{} is no number", shown(*found)), wanted);
    return otherwise;
  }
  const double value = found->get<double>();
  if (std::isfinite(value) && value >= range.min && value <= range.max) return value;
  bad(key, fmt::format("{} is out of range", shown(*found)), wanted);
  return otherwise;
}

std::size_t SheetFields::whole(const char* key, std::size_t otherwise, const FieldRange& range) {
  const double value = number(key, static_cast<double>(otherwise), range);
  if (value == std::floor(value)) return static_cast<std::size_t>(value);
  bad(key,
      fmt::format("{} is no whole number", value),
      fmt::format("write {:.10g} to {:.10g}", range.min, range.max));
  return otherwise;
}

const json& SheetFields::of_type(const char* key, bool is_type, const char* wanted) {
  const auto found = object_.find(key);
  if (found == object_.end()) return kNoValue;
  if (is_type) return *found;
  bad(key, fmt::format("{} is no {}", shown(*found), wanted), fmt::format("write a {}", wanted));
  return kNoValue;
}

bool SheetFields::flag(const char* key, bool otherwise) {
  const auto found = object_.find(key);
  const bool fits = found != object_.end() && found->is_boolean();
  const json& value = of_type(key, fits, "true or false");
  return value.is_null() ? otherwise : value.get<bool>();
}

std::string SheetFields::text(const char* key, const std::string& otherwise) {
  const auto found = object_.find(key);
  const bool fits =
      found != object_.end() && found->is_string() && !found->get_ref<const std::string&>().empty();
  const json& value = of_type(key, fits, "text in quotes");
  return value.is_null() ? otherwise : value.get<std::string>();
}

const json& SheetFields::array(const char* key) {
  const auto found = object_.find(key);
  return of_type(key, found != object_.end() && found->is_array(), "list [...]");
}

const json& SheetFields::object(const char* key) {
  const auto found = object_.find(key);
  return of_type(key, found != object_.end() && found->is_object(), "group {...}");
}

}  // namespace sim::sheet
