#include "host-sim/surface/json_heights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "host-sim/surface/raster.hpp"
#include "host-sim/surface/refusal.hpp"

namespace sim::surface {
namespace {

using nlohmann::json;

constexpr int kDeepestHeights = 8;

json parsed_heights(std::string_view text, const std::string& name) {
  const auto shallow = [](int depth, json::parse_event_t /*event*/, json& /*value*/) {
    if (depth > kDeepestHeights) throw std::length_error{"nested too deeply"};
    return true;
  };
  try {
    return json::parse(text, shallow);
  } catch (const json::parse_error& error) {
    const std::size_t at = error.byte == 0 ? 0 : error.byte - 1;
    const std::string_view before = text.substr(0, at);
    const auto line = static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1;
    refuse(name, line, fmt::format("broken JSON at byte {}", at), "export it again");
  } catch (const json::exception&) {
    refuse(name, 0, "has a number that is too great", "correct the number");
  } catch (const std::length_error& error) {
    refuse(name, 0, error.what(), "give width, height and values");
  }
}

std::uint64_t count_of(const json& document, const char* key, const std::string& name) {
  const auto found = document.find(key);
  if (found != document.end() && found->is_number_unsigned()) return found->get<std::uint64_t>();
  refuse(name, 0, fmt::format("has no whole number `{}`", key), "give width, height and values");
}

/// Converts a JSON value to the next height of the raster, mm; NaN for null.
double value_of(const json& value, const Raster& raster, const std::string& name) {
  if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (value.is_number()) return value.get<double>();
  const std::size_t index = raster.heights.size();
  refuse(name,
         0,
         fmt::format("/values/{} in row {}, column {} is neither a number nor null",
                     index,
                     index / raster.columns + 1,
                     index % raster.columns + 1),
         "give a number, or null for a missing height");
}

}  // namespace

GridDraft read_json_heights(std::string_view text,
                            const std::string& name,
                            const ReadOptions& options) {
  const json document = parsed_heights(text, name);
  Raster raster;
  raster.columns = count_of(document, "width", name);
  raster.rows = count_of(document, "height", name);
  require_raster_size(raster.rows, raster.columns, name);
  const auto values = document.find("values");
  if (values == document.end() || !values->is_array()) {
    refuse(name, 0, "has no list `values`", "give width, height and values");
  }
  if (values->size() != raster.rows * raster.columns) {
    refuse(
        name,
        0,
        fmt::format("has {} values for {} rows of {}", values->size(), raster.rows, raster.columns),
        "give width times height values");
  }
  require_pitch(options, name);
  raster.pitch = {options.pitch_mm, options.pitch_mm};
  raster.heights.reserve(values->size());
  for (const json& value : *values) {
    raster.heights.push_back(value_of(value, raster, name) * options.unit_mm);
  }
  GridDraft draft = draft_of(std::move(raster), name);
  draft.height_span_mm = options.height_mm;
  return draft;
}

}  // namespace sim::surface
