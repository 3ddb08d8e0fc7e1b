#include "tests/support/seed_file.hpp"

#include <algorithm>
#include <charconv>

namespace proof {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

class Reader {
 public:
  void line(std::string_view text) {
    ++number_;
    text = trimmed(text);
    if (text.empty() || text.front() == '#') return;
    if (text.front() == '[') return section(text);
    seed(text);
  }

  SeedFile finish() {
    check_section();
    return std::move(file_);
  }

 private:
  void fault(std::string_view what, std::string_view text) {
    file_.faults.push_back("line " + std::to_string(number_) + ": " + std::string{what} + ": " +
                           std::string{text});
  }

  void check_section() {
    if (!section_.empty() && file_.seeds[section_].empty())
      fault("section without seeds", section_);
  }

  void section(std::string_view text) {
    check_section();
    section_ = text.back() == ']' ? std::string{text.substr(1, text.size() - 2)} : std::string{};
    if (section_.find('.') == std::string::npos) return fault("not a [Suite.Test]", text);
    if (!file_.seeds.try_emplace(section_).second) fault("second section of this test", text);
  }

  void seed(std::string_view text) {
    const std::size_t hash = text.find('#');
    const std::string_view digits = trimmed(text.substr(0, hash));
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(digits.begin(), digits.end(), value);
    if (error != std::errc{} || end != digits.end()) return fault("not a seed", text);
    if (hash == std::string_view::npos || trimmed(text.substr(hash + 1)).empty()) {
      return fault("seed without its reason", text);
    }
    if (section_.empty()) return fault("seed before any [Suite.Test]", text);
    std::vector<std::uint64_t>& seeds = file_.seeds[section_];
    if (std::count(seeds.begin(), seeds.end(), value) != 0) return fault("second time", text);
    seeds.push_back(value);
  }

  SeedFile file_;
  std::string section_;
  std::size_t number_ = 0;
};

}  // namespace

SeedFile read_seeds(std::string_view text) {
  Reader reader;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return reader.finish();
}

}  // namespace proof
