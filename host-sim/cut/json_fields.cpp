#include "host-sim/cut/json_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "host-sim/report/nearest_name.hpp"
#include "host-sim/report/printable.hpp"

namespace sim::cut {
namespace {

using Document = nlohmann::ordered_json;

/// Greatest depth of nesting in a document. Documents that people write are less deep.
constexpr int kDeepestDocument = 8;

/// Returns the line and the column of the byte with number `byte`, for example `3:14`.
std::string line_and_column(const std::string& text, std::size_t byte) {
  const std::string before = text.substr(0, std::min(byte, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n');
  const std::size_t column = start == std::string::npos ? before.size() : before.size() - start - 1;
  return fmt::format("{}:{}", line, std::max<std::size_t>(column, 1));
}

}  // namespace

Document marked_json(const std::string& text,
                     const std::string& file,
                     const char* mark,
                     const char* kind) {
  const auto refuse_deep = [&](int depth, Document::parse_event_t /*event*/, Document& /*value*/) {
    if (depth <= kDeepestDocument) return true;
    throw std::invalid_argument(fmt::format(
        "{}: is nested more than {} deep; a {} is less deep", file, kDeepestDocument, kind));
  };
  Document document;
  try {
    document = Document::parse(text, refuse_deep);
  } catch (const Document::parse_error& error) {
    throw std::invalid_argument(fmt::format("{}:{}: is no JSON here; mend it, or save it again",
                                            file,
                                            line_and_column(text, error.byte)));
  }
  const bool is_marked = document.is_object() && document.contains(mark) && document[mark] == 1;
  if (is_marked) return document;
  throw std::invalid_argument(
      fmt::format("{}: is no {}; write an object with \"{}\": 1", file, kind, mark));
}

JsonFields::JsonFields(const Document& object,
                       std::string file,
                       std::string pointer,
                       const std::vector<std::string>& keys)
    : object_{object}, file_{std::move(file)}, pointer_{std::move(pointer)} {
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(keys, key) != keys.end()) continue;
    refuse(
        key,
        fmt::format(
            "there is no such key; keys are {}{}", fmt::join(keys, ", "), did_you_mean(key, keys)));
  }
}

std::optional<double> JsonFields::number(const char* key, double min, double max) const {
  if (!object_.contains(key)) return std::nullopt;
  const Document& value = object_[key];
  const bool is_fine =
      value.is_number() && value.get<double>() >= min && value.get<double>() <= max;
  if (!is_fine) refuse(key, fmt::format("must be a number from {:g} to {:g}", min, max));
  return value.get<double>();
}

std::optional<std::pair<double, double>> JsonFields::pair(const char* key,
                                                          double min,
                                                          double max) const {
  if (!object_.contains(key)) return std::nullopt;
  const Document& value = object_[key];
  const auto is_fine = [&](const Document& part) {
    return part.is_number() && part.get<double>() >= min && part.get<double>() <= max;
  };
  if (!value.is_array() || value.size() != 2 || !std::ranges::all_of(value, is_fine)) {
    refuse(key, fmt::format("must be two numbers from {:g} to {:g}, such as [300, 200]", min, max));
  }
  return std::pair{value[0].get<double>(), value[1].get<double>()};
}

std::optional<std::string> JsonFields::text(const char* key) const {
  if (!object_.contains(key)) return std::nullopt;
  const Document& value = object_[key];
  if (!value.is_string() || value.get<std::string>().empty()) refuse(key, "must be a text");
  return value.get<std::string>();
}

std::vector<std::string> JsonFields::texts(const char* key) const {
  if (!object_.contains(key)) return {};
  const Document& value = object_[key];
  const auto is_text = [](const Document& part) { return part.is_string(); };
  if (!value.is_array() || !std::ranges::all_of(value, is_text)) {
    refuse(key, R"(must be a list of texts, such as ["$32=1"])");
  }
  return value.get<std::vector<std::string>>();
}

void JsonFields::refuse(const std::string& key, const std::string& reason) const {
  throw std::invalid_argument(
      fmt::format("{}: {}/{}: {}", file_, pointer_, printable_line(key), reason));
}

}  // namespace sim::cut
