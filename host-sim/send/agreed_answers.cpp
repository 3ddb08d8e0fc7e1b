#include "host-sim/send/agreed_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "firmware/machine/settings.hpp"
#include "host-sim/send/status_field.hpp"

namespace sim {
namespace {

/// Number of rounds after which a fact that never arrived counts as missing. A link that damages
/// one byte in 80 damages a fact of 20 bytes in all of these rounds with a probability of 0.2 %.
/// For a link that damages one byte in 600, the probability is 1e-6.
constexpr std::size_t kRoundsUntilMissing = 4;
/// Number of rounds for the detection of damaged names. A name that arrives at most once in this
/// number of rounds is a damaged copy of another name. The name of a real fact arrives so rarely
/// with a probability of 1e-7 at worst.
constexpr std::size_t kRoundsOfStray = 8;
/// Number of arrivals after which a form of a fact is settled. Damage may turn 12000 into 1200 by
/// the loss of any of its zeros, so the same wrong form may arrive again. If one byte in 200 is
/// damaged, the same wrong form arrives twice in succession in one of 400 listings.
constexpr std::size_t kAlike = 3;

constexpr std::string_view kStatus = "<";
constexpr std::string_view kFullStatus = "<H";
constexpr std::string_view kProgress = "[RESUME:";
constexpr std::array<std::string_view, 14> kBracketed{"[G54:",
                                                      "[G55:",
                                                      "[G56:",
                                                      "[G57:",
                                                      "[G58:",
                                                      "[G59:",
                                                      "[G59.1:",
                                                      "[G59.2:",
                                                      "[G59.3:",
                                                      "[G28:",
                                                      "[G30:",
                                                      "[G92:",
                                                      "[TLO:",
                                                      "[GC:"};

/// Returns the start of a line in the listing of settings, such as `$130`.
std::string name_of_setting(std::uint16_t number) { return fmt::format("${}", number); }

/// Returns the fields of a status report that do not change while the machine is at rest.
std::optional<std::string> steady_status(std::string_view report) {
  const auto place = status_field(report, "|MPos:");
  if (!place) return std::nullopt;
  std::string text = fmt::format("{}|MPos:{}", report.substr(0, report.find('|')), *place);
  for (const std::string_view name : {"|H:", "|Pn:"}) {
    if (const auto content = status_field(report, name))
      text += fmt::format("{}{}", name, *content);
  }
  return text + '>';
}

}  // namespace

AgreedAnswers::AgreedAnswers(bool resume) {
  for (const cnc::SettingInfo& info : cnc::setting_table()) facts_[name_of_setting(info.number)];
  for (const std::string_view name : kBracketed) facts_[std::string{name}];
  for (const std::string_view name : {kStatus, kFullStatus}) facts_[std::string{name}];
  if (resume) facts_[std::string{kProgress}];
}

void AgreedAnswers::read(std::string_view line) {
  const auto count = [this](std::string_view name, std::string form) {
    if (const auto fact = facts_.find(name); fact != facts_.end()) ++fact->second[std::move(form)];
  };
  if (line.starts_with('$')) return count(line.substr(0, line.find('=')), std::string{line});
  if (line.starts_with('[')) {
    return count(line.substr(0, std::min(line.find(':'), line.size() - 1) + 1), std::string{line});
  }
  if (!line.starts_with('<')) return;
  const bool full = status_field(line, "|H:").has_value();
  if (auto form = steady_status(line)) count(full ? kFullStatus : kStatus, std::move(*form));
}

std::vector<std::string> AgreedAnswers::open() const {
  std::vector<std::string> names;
  for (const auto& [name, forms] : facts_) {
    if (!is_missing(forms) && settled_form(forms) == nullptr) names.push_back(name);
  }
  return names;
}

std::vector<std::string> AgreedAnswers::lines() const {
  std::vector<std::string> lines;
  for (const auto& [name, forms] : facts_) {
    if (const std::string* form = settled_form(forms)) lines.push_back(*form);
  }
  return lines;
}

bool AgreedAnswers::is_missing(const Forms& forms) const {
  std::size_t arrivals = 0;
  for (const auto& [form, count] : forms) arrivals += count;
  const std::size_t rounds = arrivals == 0 ? kRoundsUntilMissing : arrivals * kRoundsOfStray;
  return rounds_ >= rounds;
}

/// Returns the form that has arrived most often. Returns null if it has arrived fewer than kAlike
/// times, or if another form has arrived as often.
const std::string* AgreedAnswers::settled_form(const Forms& forms) {
  const std::string* settled = nullptr;
  std::size_t most = kAlike - 1;
  for (const auto& [form, count] : forms) {
    if (count == most) settled = nullptr;
    if (count <= most) continue;
    most = count;
    settled = &form;
  }
  return settled;
}

}  // namespace sim
