#include "host-sim/sheet/sheet_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "host-sim/import/line_table.hpp"
#include "host-sim/report/printable.hpp"
#include "host-sim/sheet/part_order.hpp"
#include "host-sim/sheet/sheet_fields.hpp"

namespace sim::sheet {
namespace {

using drawing::FaultKind;
using nlohmann::json;

constexpr const char* kMark = "kerfline_sheet";
constexpr int kDeepestSheet = 8;
constexpr FieldRange kPlaces{-kMaxPlaceMm, kMaxPlaceMm, "mm"};
constexpr FieldRange kAngles{-360.0, 360.0, "degrees"};
constexpr FieldRange kCounts{1.0, static_cast<double>(kMaxCopies), ""};

std::string stem_of(const std::string& drawing) {
  return std::filesystem::path{drawing}.stem().string();
}

/// Reads one sheet file from its JSON document.
class SheetReader {
 public:
  explicit SheetReader(Sheet& sheet) : sheet_{sheet} {}

  void read(const json& document) {
    if (!document.is_object() || !document.contains(kMark)) {
      return refuse(1,
                    0,
                    fmt::format("no object with \"{}\": 1", kMark),
                    "docs/sheets.md describes the file");
    }
    SheetFields fields{document, "", {kMark, "stock", "parts", "locked"}, sheet_.faults};
    static_cast<void>(fields.number(kMark, 1.0, {1.0, 1.0, "(the only version)"}));
    sheet_.locked = fields.flag("locked", false);
    read_stock(fields);
    const json& parts = fields.array("parts");
    if (parts.empty()) {
      fields.bad(
          "parts", "there is no part to cut", "list at least one part, with its \"drawing\"");
    } else if (parts.size() > kMaxParts) {
      fields.bad("parts",
                 fmt::format("there are {} parts", parts.size()),
                 fmt::format("list at most {} parts, each with any number of places", kMaxParts));
    } else {
      for (std::size_t i = 0; i < parts.size(); ++i) read_part(parts[i], i);
      give_turns(sheet_);
    }
  }

  void refuse(std::size_t line, std::size_t column, std::string reason, std::string remedy) {
    sheet_.faults.push_back({FaultKind::kUnreadable,
                             {.line = line, .column = column},
                             {},
                             std::move(reason),
                             std::move(remedy)});
  }

 private:
  void read_stock(SheetFields& all) {
    const json& value = all.object("stock");
    if (value.is_null()) {
      if (!all.has("stock")) all.bad("stock", "is missing", "give its width_mm and height_mm");
      return;
    }
    SheetFields fields{
        value, "/stock", {"width_mm", "height_mm", "margin_mm", "skeleton"}, sheet_.faults};
    const std::size_t before = sheet_.faults.size();
    for (const char* key : {"width_mm", "height_mm"}) {
      if (!fields.has(key)) fields.bad(key, "is missing", "give the size of the stock in mm");
    }
    Stock stock{.width_mm = fields.number("width_mm", 1.0, {0.1, kMaxSheetMm, "mm"}),
                .height_mm = fields.number("height_mm", 1.0, {0.1, kMaxSheetMm, "mm"})};
    const double half = 0.5 * std::min(stock.width_mm, stock.height_mm);
    stock.margin_mm = fields.number("margin_mm", 0.0, {0.0, half, "mm, half the stock"});
    stock.keeps_skeleton = fields.flag("skeleton", false);
    if (sheet_.faults.size() == before) sheet_.stock = stock;
  }

  void read_part(const json& value, std::size_t index) {
    const std::string pointer = fmt::format("/parts/{}", index);
    if (!value.is_object()) {
      SheetFields{json::object(), pointer, {}, sheet_.faults}.bad(
          "", "is no part", R"(write {"drawing": "FILE"} at least)");
      return;
    }
    const std::size_t before = sheet_.faults.size();
    SheetFields fields{value,
                       pointer,
                       {"drawing",
                        "name",
                        "copies",
                        "places",
                        "x_mm",
                        "y_mm",
                        "angle_deg",
                        "mirror",
                        "step_x_mm",
                        "step_y_mm",
                        "columns",
                        "after"},
                       sheet_.faults};
    SheetPart part{.name = {}, .drawing = fields.text("drawing", ""), .places = {}};
    part.pointer = pointer;
    if (!fields.has("drawing")) fields.bad("drawing", "is missing", "name the file of the part");
    part.name = fields.text("name", stem_of(part.drawing));
    if (!part.name.empty() && !names_.insert(part.name).second) {
      fields.bad("name",
                 fmt::format("there is another part \"{}\"", printable_line(part.name)),
                 "give each part a name of its own, or list all places in one part");
    }
    part.places = fields.has("places") ? listed_places(fields) : grid_of_places(fields);
    part.after = names_before(fields);
    copies_ += part.places.size();
    if (copies_ > kMaxCopies) {
      fields.bad("copies",
                 fmt::format("there are {} copies up to here", copies_),
                 fmt::format("place at most {} on one sheet", kMaxCopies));
    }
    if (sheet_.faults.size() == before) sheet_.parts.push_back(std::move(part));
  }

  static std::vector<std::string> names_before(SheetFields& fields) {
    std::vector<std::string> names;
    if (!fields.has("after")) return names;
    for (const json& name : fields.array("after")) {
      if (name.is_string()) names.push_back(name.get<std::string>());
      if (!name.is_string())
        fields.bad("after", "contains a value that is no name", R"(write ["NAME", "NAME"])");
    }
    return names;
  }

  std::vector<Placing> listed_places(SheetFields& fields) {
    for (const char* key :
         {"x_mm", "y_mm", "angle_deg", "mirror", "step_x_mm", "step_y_mm", "columns"}) {
      if (!fields.has(key)) continue;
      fields.bad(
          key, "is used together with \"places\"", "use one of them: a list of places, or a grid");
    }
    const json& list = fields.array("places");
    std::vector<Placing> places;
    if (list.is_null()) return places;
    for (std::size_t i = 0; i < list.size() && i <= kMaxCopies; ++i) {
      const std::string pointer = fmt::format("{}/places/{}", fields.pointer(), i);
      if (!list[i].is_object()) {
        fields.bad(fmt::format("places/{}", i), "is no place", R"(write {"x_mm": X, "y_mm": Y})");
        continue;
      }
      SheetFields place{list[i], pointer, {"x_mm", "y_mm", "angle_deg", "mirror"}, sheet_.faults};
      places.push_back(placing_of(place));
    }
    const std::size_t copies = fields.whole("copies", list.empty() ? 1 : list.size(), kCounts);
    if (list.empty()) {
      fields.bad("places", "is empty", "list a place for each copy");
    } else if (copies != list.size()) {
      fields.bad("copies",
                 fmt::format("{} copies, but {} places", copies, list.size()),
                 "leave \"copies\" out, or list a place for each copy");
    }
    return places;
  }

  static Placing placing_of(SheetFields& fields) {
    Placing placing;
    placing.at_mm = {fields.number("x_mm", 0.0, kPlaces), fields.number("y_mm", 0.0, kPlaces)};
    placing.angle_deg = fields.number("angle_deg", 0.0, kAngles);
    placing.mirror = fields.flag("mirror", false);
    return placing;
  }

  /// Returns the positions of the copies in a grid. The first copy is at the position that the
  /// fields give. The other copies follow row by row.
  static std::vector<Placing> grid_of_places(SheetFields& fields) {
    const Placing first = placing_of(fields);
    const std::size_t copies = fields.whole("copies", 1, kCounts);
    const std::size_t columns = fields.whole("columns", copies, kCounts);
    const Place step{fields.number("step_x_mm", 0.0, kPlaces),
                     fields.number("step_y_mm", 0.0, kPlaces)};
    if (copies > 1 && columns > 1 && step.x() == 0.0) {
      fields.bad("step_x_mm", "copies in a row need a distance", "give it in mm");
    }
    if (copies > columns && step.y() == 0.0) {
      fields.bad("step_y_mm", "rows need a distance", "give it in mm");
    }
    std::vector<Placing> places(copies, first);
    for (std::size_t i = 0; i < copies; ++i) {
      const std::size_t row = i / columns;
      const Place way{step.x() * static_cast<double>(i - row * columns),
                      step.y() * static_cast<double>(row)};
      places[i].at_mm += way;
    }
    return places;
  }

  Sheet& sheet_;
  std::set<std::string> names_;
  std::size_t copies_ = 0;
};

/// Stops the parser at values that are nested too deeply, and at objects with a repeated key, which
/// it would accept silently.
class StrictEvents {
 public:
  bool operator()(int depth, json::parse_event_t event, const json& value) {
    if (depth > kDeepestSheet) throw std::length_error{"nested too deeply for a sheet file"};
    if (event == json::parse_event_t::object_start) keys_.emplace_back();
    if (event == json::parse_event_t::object_end) keys_.pop_back();
    if (event != json::parse_event_t::key) return true;
    const auto& key = value.get_ref<const std::string&>();
    if (!keys_.back().insert(key).second) {
      throw std::length_error{
          fmt::format("the key \"{}\" occurs twice in one object", printable_line(key))};
    }
    return true;
  }

 private:
  std::vector<std::set<std::string>> keys_;
};

}  // namespace

bool is_sheet(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{' &&
         text.find("\"kerfline_sheet\"") != std::string_view::npos;
}

Sheet read_sheet(const std::string& file, const std::string& text) {
  Sheet sheet{.file = file, .parts = {}};
  SheetReader reader{sheet};
  const auto events = std::make_shared<StrictEvents>();
  const auto check = [events](int depth, json::parse_event_t event, const json& value) {
    return (*events)(depth, event, value);
  };
  try {
    reader.read(json::parse(text, check));
  } catch (const json::parse_error& error) {
    const auto [line, column] = drawing::LineTable{text}.at(error.byte == 0 ? 0 : error.byte - 1);
    reader.refuse(line, column, "broken JSON", "mend it here, or just before");
  } catch (const json::exception&) {
    reader.refuse(1, 0, "a number is too great", "write a smaller number");
  } catch (const std::length_error& error) {
    reader.refuse(1, 0, error.what(), "mend it; docs/sheets.md has the format");
  }
  return sheet;
}

std::string text_of(const Sheet& sheet) {
  nlohmann::ordered_json json;
  json[kMark] = 1;
  if (sheet.stock) {
    json["stock"] = {{"width_mm", sheet.stock->width_mm},
                     {"height_mm", sheet.stock->height_mm},
                     {"margin_mm", sheet.stock->margin_mm},
                     {"skeleton", sheet.stock->keeps_skeleton}};
  }
  if (sheet.locked) json["locked"] = true;
  json["parts"] = nlohmann::ordered_json::array();
  for (const SheetPart& part : sheet.parts) {
    nlohmann::ordered_json row;
    row["drawing"] = part.drawing;
    row["name"] = part.name;
    if (!part.after.empty()) row["after"] = part.after;
    row["places"] = nlohmann::ordered_json::array();
    for (const Placing& placing : part.places) {
      nlohmann::ordered_json place{{"x_mm", placing.at_mm.x()}, {"y_mm", placing.at_mm.y()}};
      if (placing.angle_deg != 0.0) place["angle_deg"] = placing.angle_deg;
      if (placing.mirror) place["mirror"] = true;
      row["places"].push_back(place);
    }
    json["parts"].push_back(row);
  }
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace sim::sheet
