#include "host-sim/report/nearest_name.hpp"

#include <algorithm>
#include <cctype>

namespace sim {
namespace {

/// Returns the text in lower case, for comparisons that ignore the case.
std::string lower(std::string text) {
  for (char& letter : text) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return text;
}

/// Returns the number of slips between two texts: their optimal string alignment distance.
std::size_t slips_between(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t other = a[i - 1] == b[j - 1] ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + other});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

}  // namespace

std::optional<std::string> nearest_name(const std::string& word,
                                        const std::vector<std::string>& names) {
  std::optional<std::string> nearest;
  std::size_t fewest = std::max<std::size_t>(word.size(), 3) / 3 + 1;
  std::vector<std::string> begun;
  for (const std::string& name : names) {
    if (!word.empty() && lower(name).starts_with(lower(word))) begun.push_back(name);
    const std::size_t slips =
        std::min(slips_between(word, name), slips_between(lower(word), lower(name)) + 1);
    if (slips >= fewest) continue;
    fewest = slips;
    nearest = name;
  }
  return begun.size() == 1 ? begun.front() : nearest;
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names) {
  const auto nearest = nearest_name(word, names);
  return nearest ? "; did you mean " + *nearest + "?" : "";
}

}  // namespace sim
