#include "host-sim/knowledge/operation_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <set>
#include <stdexcept>
#include <tuple>

#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/report/nearest_name.hpp"

namespace sim {
namespace {

using Operations = std::vector<OperationRecord>;

/// Returns the number that a text of digits stands for; -1 for any other text.
int digits_in(std::string_view text) {
  int value = -1;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  const bool is_whole = result.ec == std::errc{} && result.ptr == end && text.front() != '-';
  return is_whole ? value : -1;
}

std::string passes_text(const std::optional<std::uint32_t>& passes) {
  if (!passes) return "passes not known";
  return *passes == 1 ? "1 pass" : fmt::format("{} passes", *passes);
}

std::string thickness_text(const OperationRecord& operation) {
  if (!operation.thickness_um) return "any thickness";
  return fmt::format("{:g} mm", from_thousandths(*operation.thickness_um));
}

/// Returns the operations of the wished kind and description.
Operations like(const Operations& operations, const OperationWish& wish) {
  Operations found;
  std::ranges::copy_if(operations, std::back_inserter(found), [&](const OperationRecord& one) {
    return one.kind == wish.kind &&
           (wish.description.empty() || one.description == wish.description);
  });
  return found;
}

Operations of_thickness(const Operations& operations, std::optional<std::uint32_t> thickness_um) {
  Operations found;
  std::ranges::copy_if(operations, std::back_inserter(found), [&](const OperationRecord& one) {
    return one.thickness_um == thickness_um;
  });
  return found;
}

[[noreturn]] void refuse_thickness(const Operations& operations, const OperationWish& wish) {
  std::set<std::string> known;
  for (const OperationRecord& one : operations) known.insert(thickness_text(one));
  throw std::invalid_argument(fmt::format("{}: no settings are known for {:g} mm; there is {}",
                                          wish.material,
                                          from_thousandths(wish.thickness_um),
                                          fmt::join(known, ", ")));
}

[[noreturn]] void refuse_choice(const Operations& operations, const OperationWish& wish) {
  std::vector<std::string> known;
  for (const OperationRecord& one : operations) {
    known.push_back(fmt::format("\"{}\" ({})", one.description, text_of(one)));
  }
  throw std::invalid_argument(fmt::format(
      "{}: there are {} settings to {} it, none measured here; choose one with --entry: {}",
      wish.material,
      known.size(),
      wish.kind,
      fmt::join(known, ", ")));
}

[[noreturn]] void refuse_description(const Operations& operations, const OperationWish& wish) {
  std::vector<std::string> known;
  for (const OperationRecord& one : operations) {
    if (one.kind == wish.kind) known.push_back(one.description);
  }
  throw std::invalid_argument(
      fmt::format("--entry {}: {} has no such settings to {} it; it has {}{}",
                  wish.description,
                  wish.material,
                  wish.kind,
                  fmt::join(known, ", "),
                  did_you_mean(wish.description, known)));
}

}  // namespace

std::string text_of(const Origin& origin) {
  if (!origin.is_measured_here) {
    return fmt::format(
        "not measured here: from {}{}", origin.source, origin.on.empty() ? "" : " of " + origin.on);
  }
  return fmt::format("measured by {} on {}, {}",
                     origin.by.empty() ? "an unknown person" : origin.by,
                     origin.on.empty() ? "an unknown day" : origin.on,
                     origin.source);
}

std::string text_of(const OperationRecord& operation) {
  const auto known = [](const auto& value, const char* form, const char* name) {
    return value ? fmt::format(fmt::runtime(form), *value) : fmt::format("{} not known", name);
  };
  std::optional<double> speed;
  if (operation.speed_um_min) speed = from_thousandths(*operation.speed_um_min);
  std::string text = fmt::format("{}, {}: {}, {}, {}",
                                 operation.kind,
                                 thickness_text(operation),
                                 known(operation.power_percent, "{:g} percent", "power"),
                                 known(speed, "{:g} mm/min", "speed"),
                                 passes_text(operation.passes));
  if (operation.interval_mm) text += fmt::format(", interval {:g} mm", *operation.interval_mm);
  if (operation.kind != "cut") return text;
  return text + ", " + known(operation.kerf_mm, "kerf {:.3f} mm", "kerf");
}

std::string origins_of(const std::vector<OperationRecord>& operations) {
  std::vector<std::string> origins;
  for (const OperationRecord& operation : operations) {
    std::string text = text_of(operation.origin);
    if (std::ranges::find(origins, text) == origins.end()) origins.push_back(std::move(text));
  }
  return fmt::format("{}", fmt::join(origins, "; "));
}

bool is_date(std::string_view text) {
  constexpr std::size_t kLength = 10;
  if (text.size() != kLength || text[4] != '-' || text[7] != '-') return false;
  const int year = digits_in(text.substr(0, 4));
  const int month = digits_in(text.substr(5, 2));
  const int day = digits_in(text.substr(8, 2));
  if (year < 1 || month < 1 || day < 1) return false;
  return std::chrono::year_month_day{std::chrono::year{year},
                                     std::chrono::month{static_cast<unsigned>(month)},
                                     std::chrono::day{static_cast<unsigned>(day)}}
      .ok();
}

std::optional<OperationRecord> choose_operation(const std::vector<OperationRecord>& operations,
                                                const OperationWish& wish) {
  const Operations named = like(operations, wish);
  if (named.empty() && !wish.description.empty()) refuse_description(operations, wish);
  if (named.empty()) return std::nullopt;
  Operations found = of_thickness(named, wish.thickness_um);
  if (found.empty()) found = of_thickness(named, std::nullopt);
  if (found.empty()) refuse_thickness(named, wish);
  Operations measured;
  std::ranges::copy_if(found, std::back_inserter(measured), [](const OperationRecord& one) {
    return one.origin.is_measured_here;
  });
  if (!measured.empty()) {
    // The order is by speed, then by falling power, so that the best operation is the greatest.
    return *std::ranges::max_element(measured, {}, [](const OperationRecord& one) {
      return std::tuple{one.speed_um_min.value_or(0) / one.passes.value_or(1),
                        -one.power_percent.value_or(0.0)};
    });
  }
  if (found.size() > 1) refuse_choice(found, wish);
  return found.front();
}

}  // namespace sim
