#include "host-sim/knowledge/test_grid_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "host-sim/cut/json_fields.hpp"
#include "host-sim/import/clb_reader.hpp"
#include "host-sim/knowledge/experiment.hpp"

namespace sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormMark = "kerfline_test_grid";
constexpr double kGreatestKerfMm = 5.0;
constexpr double kGreatestSpreadMm = 0.3;
constexpr double kGreatestPercent = 100.0;
constexpr double kGreatestFormFeed = from_thousandths(cnc::kerf::kMaxSpeedUmMin);
constexpr double kMinFormFeed = from_thousandths(cnc::kerf::kMinSpeedUmMin);
constexpr double kWidestSlotMm = 200.0;
constexpr double kMaxPasses = 1000.0;
constexpr double kWidestLineMm = 100.0;

/// Reader of a form that the user has filled in.
class FormReader {
 public:
  FormReader(const std::string& text, std::string file, const FormPerson& person)
      : file_{std::move(file)},
        form_(cut::marked_json(text, file_, kFormMark, "form of a test grid")),
        person_{person} {}

  MeasuredGrid read() {
    drop_empty(form_);
    const cut::JsonFields fields{form_,
                                 file_,
                                 "",
                                 {kFormMark,
                                  "about",
                                  "material",
                                  "thickness_mm",
                                  "laser",
                                  "kind",
                                  "passes",
                                  "interval_mm",
                                  "measured_by",
                                  "measured_on",
                                  "squares",
                                  "slots"}};
    MeasuredGrid found{.material = fields.text("material").value_or("")};
    if (found.material.empty() || found.material.size() > drawing::kLongestMaterialName) {
      fields.refuse("material",
                    fmt::format("must be the name of the material, of up to {} bytes",
                                drawing::kLongestMaterialName));
    }
    common_ = common_of(fields);
    if (common_.kind == "cut") common_.kerf_mm = kerf(found.notes);
    read_squares(found);
    return found;
  }

 private:
  /// Removes fields that are not filled in: null or an empty text.
  static void drop_empty(Json& object) {
    for (auto field = object.begin(); field != object.end();) {
      const bool is_empty = field->is_null() || (field->is_string() && field->empty()) ||
                            (field->is_string() && field->get<std::string>().empty());
      if (is_empty) {
        field = object.erase(field);
      } else {
        ++field;
      }
    }
  }

  OperationRecord common_of(const cut::JsonFields& fields) const {
    OperationRecord common{.kind = fields.text("kind").value_or(""),
                           .laser = fields.text("laser").value_or("")};
    if (common.kind != "cut" && common.kind != "fill") {
      fields.refuse("kind", R"(must be "cut" or "fill", as in the form that was written)");
    }
    const double thickness_mm =
        fields.number("thickness_mm", 0.0, drawing::kGreatestThicknessMm).value_or(0.0);
    if (thickness_mm > 0.0) common.thickness_um = to_thousandths(thickness_mm);
    if (common.thickness_um == 0U) common.thickness_um.reset();
    common.passes =
        static_cast<std::uint32_t>(fields.number("passes", 1.0, kMaxPasses).value_or(1.0));
    common.interval_mm = fields.number("interval_mm", 0.005, kWidestLineMm);
    const std::string by = fields.text("measured_by").value_or(person_.by);
    const std::string on = fields.text("measured_on").value_or(person_.on);
    if (by.empty())
      fields.refuse("measured_by", "must be the name of the person who measured; or give --by");
    if (!is_date(on)) {
      fields.refuse("measured_on", "must be the day, such as \"2026-11-30\"; or give --on");
    }
    common.origin = {true, by, on, std::filesystem::path{file_}.filename().string()};
    return common;
  }

  const Json& rows(const Json& object, const std::string& key, const std::string& pointer) const {
    constexpr std::size_t kMaxRows = 10'000;
    const bool is_list =
        object.contains(key) && object[key].is_array() && object[key].size() <= kMaxRows;
    if (!is_list) refuse(pointer, "must be the list as `kerf test-grid` wrote it");
    return object[key];
  }

  [[noreturn]] void refuse(const std::string& pointer, const std::string& reason) const {
    throw std::invalid_argument(fmt::format("{}: {}: {}", file_, pointer, reason));
  }

  /// Returns a row without its empty fields.
  Json row_of(const Json& rows, std::size_t index, const std::string& pointer) const {
    Json row = rows[index];
    if (!row.is_object()) refuse(pointer, "must be an object");
    drop_empty(row);
    return row;
  }

  static double number_of(const cut::JsonFields& fields,
                          const char* key,
                          double least,
                          double most) {
    const auto number = fields.number(key, least, most);
    if (!number) fields.refuse(key, fmt::format("must be a number, {:g} to {:g}", least, most));
    return *number;
  }

  /// Returns the kerf: the mean, over the measured slots, of the measured width minus the path
  /// width. Empty if no slot was measured.
  std::optional<double> kerf(std::vector<std::string>& notes) const {
    if (!form_.contains("slots")) return std::nullopt;
    if (!form_["slots"].is_object()) refuse("/slots", "must be an object");
    const Json& slots = form_["slots"];
    const cut::JsonFields about{slots, file_, "/slots", {"power_percent", "feed_mm_min", "rows"}};
    const double power = number_of(about, "power_percent", 0.01, kGreatestPercent);
    const double feed = number_of(about, "feed_mm_min", kMinFormFeed, kGreatestFormFeed);
    std::vector<double> kerfs;
    const Json& list = rows(slots, "rows", "/slots/rows");
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (const auto one = kerf_of_slot(list, i)) kerfs.push_back(*one);
    }
    if (kerfs.empty()) {
      notes.emplace_back("no slot was measured: the kerf is not known, and `cut` requires --kerf");
      return std::nullopt;
    }
    const auto [least, most] = std::ranges::minmax(kerfs);
    if (most - least > kGreatestSpreadMm) {
      refuse(
          "/slots/rows",
          fmt::format("the kerfs of the slots differ, from {:.3f} to {:.3f} mm; measure them again",
                      least,
                      most));
    }
    double sum = 0.0;
    for (const double one : kerfs) sum += one;
    const double mean = sum / static_cast<double>(kerfs.size());
    notes.push_back(
        fmt::format("kerf {:.3f} mm, the mean of {} slots at {:g} percent and {:g} mm/min, is used "
                    "for all squares",
                    mean,
                    kerfs.size(),
                    power,
                    feed));
    return mean;
  }

  std::optional<double> kerf_of_slot(const Json& list, std::size_t index) const {
    const std::string pointer = fmt::format("/slots/rows/{}", index);
    const Json row = row_of(list, index, pointer);
    const cut::JsonFields fields{row, file_, pointer, {"path_mm", "measured_mm"}};
    const double path = number_of(fields, "path_mm", 0.1, kWidestSlotMm);
    const auto measured = fields.number("measured_mm", 0.0, kWidestSlotMm + kGreatestKerfMm);
    if (!measured) return std::nullopt;
    const double found = *measured - path;
    if (found <= 0.0 || found > kGreatestKerfMm) {
      fields.refuse("measured_mm",
                    fmt::format("a slot is wider than its path by up to {:g} mm, but this one by "
                                "{:.3f} mm; measure it again",
                                kGreatestKerfMm,
                                found));
    }
    return found;
  }

  void read_squares(MeasuredGrid& found) const {
    const Json& list = rows(form_, "squares", "/squares");
    std::size_t unsaid = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string pointer = fmt::format("/squares/{}", i);
      const Json row = row_of(list, i, pointer);
      const cut::JsonFields fields{
          row, file_, pointer, {"square", "power_percent", "feed_mm_min", "result"}};
      OperationRecord operation = common_;
      operation.description = fmt::format("square {}", i + 1);
      operation.power_percent = number_of(fields, "power_percent", 0.01, kGreatestPercent);
      operation.speed_um_min =
          to_thousandths(number_of(fields, "feed_mm_min", kMinFormFeed, kGreatestFormFeed));
      const auto result = fields.text("result");
      if (!result) {
        ++unsaid;
      } else if (*result == "good") {
        found.operations.push_back(std::move(operation));
      } else if (*result != "bad") {
        fields.refuse("result",
                      R"(must be "good", "bad", or empty for a square that was not checked)");
      }
    }
    if (found.operations.empty()) {
      refuse("/squares", "no square is good; write \"good\" as the result of good squares");
    }
    if (unsaid != 0) found.notes.push_back(fmt::format("{} squares have no result", unsaid));
  }

  std::string file_;
  Json form_;
  const FormPerson& person_;
  OperationRecord common_{};
};

}  // namespace

std::string form_of(const TestGrid& grid) {
  Json form;
  form[kFormMark] = 1;
  form["about"] = grid.is_filled
                      ? "result: good, or bad; read back with kerf test-grid --measured"
                      : "result: good if the square fell out, otherwise bad; measured_mm: width of "
                        "the slot by a caliper; read back with kerf test-grid --measured";
  form["material"] = grid.material;
  form["thickness_mm"] = grid.thickness_mm > 0.0 ? Json(grid.thickness_mm) : Json(nullptr);
  form["laser"] = grid.laser;
  form["kind"] = grid.is_filled ? "fill" : "cut";
  form["passes"] = grid.passes;
  if (grid.is_filled) form["interval_mm"] = grid.interval_mm;
  form["measured_by"] = "";
  form["measured_on"] = "";
  form["squares"] = Json::array();
  for (const double feed : grid.feeds_mm_min) {
    for (const double power : grid.powers_percent) {
      form["squares"].push_back({{"square", form["squares"].size() + 1},
                                 {"power_percent", power},
                                 {"feed_mm_min", feed},
                                 {"result", ""}});
    }
  }
  if (!grid.slots_mm.empty()) {
    Json rows = Json::array();
    for (const double width : grid.slots_mm) {
      rows.push_back({{"path_mm", width}, {"measured_mm", nullptr}});
    }
    form["slots"] = {{"power_percent", grid.slots.power_percent},
                     {"feed_mm_min", grid.slots.feed_mm_min},
                     {"rows", std::move(rows)}};
  }
  constexpr int kIndent = 2;
  return form.dump(kIndent) + "\n";
}

MeasuredGrid read_form(const std::string& text, const std::string& file, const FormPerson& person) {
  return FormReader{text, file, person}.read();
}

}  // namespace sim
