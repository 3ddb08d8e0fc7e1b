#include "host-sim/cut/shop_rule.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "host-sim/report/nearest_name.hpp"
#include "host-sim/report/printable.hpp"

namespace sim::cut {
namespace {

constexpr double kMaxBound = 1.0e9;  ///< Greatest bound in a rule, in mm, in mm² or as a multiple.
constexpr double kMaxPercent = 1000.0;
constexpr std::string_view kRuleBlanks = " \t\r\n";

constexpr std::array<std::pair<std::string_view, ContourKind>, 3> kKinds{{
    {"hole", ContourKind::kHole},
    {"outer", ContourKind::kOuter},
    {"open", ContourKind::kOpen},
}};
constexpr std::array<std::pair<std::string_view, Quantity>, 4> kQuantities{{
    {"diameter", Quantity::kDiameter},
    {"perimeter", Quantity::kPerimeter},
    {"area", Quantity::kArea},
    {"thickness", Quantity::kThickness},
}};

template <typename Value, std::size_t kCount>
std::optional<Value> value_of(const std::array<std::pair<std::string_view, Value>, kCount>& table,
                              std::string_view word) {
  for (const auto& [name, value] : table) {
    if (name == word) return value;
  }
  return {};
}

/// Parser that reads one rule from left to right.
class RuleParser {
 public:
  RuleParser(std::string_view text, std::string place) : text_{text} {
    rule_.place = std::move(place);
    const std::size_t first = std::min(text.find_first_not_of(kRuleBlanks), text.size());
    const std::size_t last = text.find_last_not_of(kRuleBlanks);
    rule_.text = text.substr(first, last == std::string_view::npos ? 0 : last + 1 - first);
  }

  ShopRule parse() {
    read_condition();
    if (!take(':')) refuse("requires `:` and an action, or `and` and one more comparison");
    read_action();
    return std::move(rule_);
  }

 private:
  [[noreturn]] void refuse(const std::string& reason) const { refuse_at(at_, reason); }
  [[noreturn]] void refuse_at(std::size_t at, const std::string& reason) const {
    throw std::invalid_argument(
        fmt::format("{}: column {}: {}", rule_.place, at + 1, printable_line(reason)));
  }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(kRuleBlanks, at_), text_.size()); }
  bool take(char wanted) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }
  /// Returns the next word, without consuming it. A word consists of letters and digits, and begins
  /// with a letter.
  std::string_view next_word() {
    skip_blanks();
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    std::size_t end = at_;
    while (end < text_.size() &&
           (is_letter(text_[end]) || (end > at_ && (text_[end] >= '0' && text_[end] <= '9')))) {
      ++end;
    }
    return text_.substr(at_, end - at_);
  }
  bool take_word(std::string_view wanted) {
    if (next_word() != wanted) return false;
    at_ += wanted.size();
    return true;
  }

  void read_condition() {
    if (const auto kind = value_of(kKinds, next_word())) {
      rule_.kind = *kind;
      at_ += next_word().size();
      skip_blanks();
      if (at_ < text_.size() && text_[at_] == ':') return;
    }
    do {
      read_comparison();
    } while (take_word("and"));
  }

  void read_comparison() {
    const std::string word{next_word()};
    const auto quantity = value_of(kQuantities, word);
    if (!quantity) {
      std::vector<std::string> known;
      if (rule_.kind == ContourKind::kAny && rule_.comparisons.empty()) {
        for (const auto& [name, kind] : kKinds) known.emplace_back(name);
      }
      for (const auto& [name, each] : kQuantities) known.emplace_back(name);
      refuse(fmt::format("{}requires {}{}",
                         word.empty() ? "" : "`" + word + "`: ",
                         fmt::join(known, ", "),
                         did_you_mean(word, known)));
    }
    if (rule_.kind == ContourKind::kOpen &&
        (*quantity == Quantity::kDiameter || *quantity == Quantity::kArea)) {
      refuse(fmt::format("open contours have no {}; they have a perimeter", word));
    }
    at_ += word.size();
    Comparison comparison{.quantity = *quantity, .relation = read_relation()};
    read_bound(comparison);
    rule_.comparisons.push_back(comparison);
  }

  Relation read_relation() {
    const bool less = take('<');
    if (!less && !take('>')) refuse("requires `<`, `<=`, `>` or `>=`");
    const bool equal = at_ < text_.size() && text_[at_] == '=';
    if (equal) ++at_;
    if (less) return equal ? Relation::kAtMost : Relation::kLess;
    return equal ? Relation::kAtLeast : Relation::kGreater;
  }

  void read_bound(Comparison& comparison) {
    const bool of_area = comparison.quantity == Quantity::kArea;
    const std::string wanted =
        of_area ? "requires a number in mm2, such as 20"
                : "requires a number in mm, such as 1.5, or `thickness`, such as 2 thickness";
    skip_blanks();
    const std::size_t begin = at_;
    const std::optional<double> number = read_number();
    if (number && (*number < 0.0 || *number > kMaxBound)) {
      refuse_at(begin, fmt::format("out of range; write 0 to {:g}", kMaxBound));
    }
    const std::size_t unit_at = at_;
    const bool can_scale = !of_area && comparison.quantity != Quantity::kThickness;
    if (can_scale && take_word("thickness")) {
      comparison.bound = number.value_or(1.0);
      comparison.of_thickness = true;
      return;
    }
    if (!number) refuse(wanted);
    comparison.bound = *number;
    const std::string unit{next_word()};
    if (unit.empty() || unit == "and") return;
    if (unit != (of_area ? "mm2" : "mm")) {
      skip_blanks();
      refuse_at(std::max(unit_at, at_), fmt::format("`{}`: {}", unit, wanted));
    }
    at_ += unit.size();
  }

  std::optional<double> read_number() {
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) return {};
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  void read_action() {
    skip_blanks();
    if (take_word("skip")) {
      rule_.action = RuleAction::kSkip;
      skip_blanks();
      if (at_ != text_.size()) refuse("requires nothing after `skip`");
      return;
    }
    if (is_alone("mark")) {
      rule_.action = RuleAction::kMark;
      static_cast<void>(take_word("mark"));
      skip_blanks();
      if (at_ == text_.size()) return;
      if (!take(',')) refuse("requires `,` and a setting after `mark`, or nothing after it");
    }
    do {
      read_change();
    } while (take(','));
  }

  [[nodiscard]] bool is_alone(std::string_view word) {
    if (next_word() != word) return false;
    const std::size_t next = text_.find_first_not_of(kRuleBlanks, at_ + word.size());
    return next == std::string_view::npos || text_[next] == ',';
  }

  void read_change() {
    skip_blanks();
    const std::size_t begin = at_;
    const std::size_t end = std::min(text_.find(',', at_), text_.size());
    const std::string_view pair = text_.substr(begin, end - begin);
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos) refuse("requires `skip`, `mark` or `key=value`");
    RuleChange change{trimmed(pair.substr(0, equals)), trimmed(pair.substr(equals + 1))};
    if (change.value.ends_with('%')) {
      read_percent(change, begin + equals + 1);
    } else {
      LayerSettings tried;
      try {
        set(tried, change.key, change.value);
        if (tried.power_share) refuse("power: write watts, or a percentage of the layer's power");
      } catch (const std::invalid_argument& error) {
        refuse(error.what());
      }
    }
    rule_.changes.push_back(std::move(change));
    at_ = end;
  }

  void read_percent(RuleChange& change, std::size_t at) const {
    if (change.key != "feed" && change.key != "power") {
      refuse_at(at, "only feed and power can be a percentage of the layer's value");
    }
    const char* const end = change.value.data() + change.value.size() - 1;
    const auto [stop, error] = std::from_chars(change.value.data(), end, change.percent);
    const bool is_number = error == std::errc{} && stop == end && std::isfinite(change.percent);
    if (is_number && change.percent >= 0.1 && change.percent <= kMaxPercent) return;
    refuse_at(at,
              fmt::format("{}={}: must be 0.1 to {:g} %", change.key, change.value, kMaxPercent));
  }

  static std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(kRuleBlanks);
    if (first == std::string_view::npos) return {};
    return std::string{text.substr(first, text.find_last_not_of(kRuleBlanks) - first + 1)};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  ShopRule rule_;
};

}  // namespace

ShopRule parse_shop_rule(std::string_view text, std::string place) {
  return RuleParser{text, std::move(place)}.parse();
}

std::vector<ShopRule> read_shop_rules(const std::string& text, const std::string& file) {
  std::vector<ShopRule> rules;
  std::size_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = std::string_view{text}.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    const std::size_t first = line.find_first_not_of(kRuleBlanks);
    if (first == std::string_view::npos || line[first] == '#') continue;
    rules.push_back(parse_shop_rule(line, fmt::format("{}:{}", file, number)));
  }
  if (rules.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: has no rule, such as `hole diameter < thickness: feed=60%`", file));
  }
  return rules;
}

}  // namespace sim::cut
