#include "firmware/protocol/statement.hpp"

#include <array>

#include "planner/gcode/decimal.hpp"

namespace cnc {
namespace {

/// The name of a statement in upper case and without blanks, for comparison with the known names.
class Name {
 public:
  static constexpr std::size_t kLongest = 8;

  explicit Name(std::string_view written) {
    for (const char c : written) {
      if (gcode::is_blank(c)) continue;
      if (size_ < kLongest) letters_[size_] = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
      ++size_;
    }
  }
  /// Returns whether the name fits. A name that is too long matches no statement.
  [[nodiscard]] bool fits() const { return size_ <= kLongest; }
  [[nodiscard]] std::string_view view() const { return {letters_.data(), size_}; }

 private:
  std::array<char, kLongest> letters_{};
  std::size_t size_ = 0;
};

struct NamedListing {
  std::string_view name;
  ListingKind kind;
};

constexpr std::array<NamedListing, 13> kListings{{
    {"", ListingKind::kHelp},
    {"$", ListingKind::kSettings},
    {"#", ListingKind::kParameters},
    {"G", ListingKind::kParserState},
    {"I", ListingKind::kBuildInfo},
    {"I+", ListingKind::kExtendedInfo},
    {"N", ListingKind::kStartupLines},
    {"ES", ListingKind::kSettingDetails},
    {"EG", ListingKind::kSettingGroups},
    {"ESH", ListingKind::kSettingHelp},
    {"EA", ListingKind::kAlarms},
    {"EE", ListingKind::kErrors},
    {"PC", ListingKind::kPowerTable},
}};

/// Returns the whole number that `name` contains; nothing if `name` is not a whole number up to
/// 65535.
std::optional<std::uint16_t> number_in(std::string_view name) {
  std::uint32_t number = 0;
  for (const char c : name) {
    if (c < '0' || c > '9') return std::nullopt;
    number = 10U * number + static_cast<std::uint32_t>(c - '0');
  }
  if (name.empty() || number > 0xFFFFU) return std::nullopt;
  return static_cast<std::uint16_t>(number);
}

/// Returns the axes after `H`, one bit each; nothing if a letter is not an axis.
std::optional<std::uint8_t> axes_in(std::string_view letters) {
  std::uint32_t axes = 0;
  for (const char letter : letters) {
    std::size_t axis = 0;
    while (axis < kAxisCount && kAxisLetters[axis] != letter) ++axis;
    if (axis == kAxisCount) return std::nullopt;
    axes |= 1U << axis;
  }
  return static_cast<std::uint8_t>(axes);
}

std::optional<Statement> read_command(std::string_view name) {
  for (const NamedListing& listing : kListings) {
    if (listing.name != name) continue;
    return Statement{.kind = StatementKind::kListing, .listing = listing.kind};
  }
  if (name == "C") return Statement{.kind = StatementKind::kCheck};
  if (name == "X") return Statement{.kind = StatementKind::kUnlock};
  if (name == "B") return Statement{.kind = StatementKind::kBlockDelete};
  if (name == "DFU") return Statement{.kind = StatementKind::kBootLoader};
  if (name == "K") return Statement{.kind = StatementKind::kListKerfTables};
  if (name == "KS") return Statement{.kind = StatementKind::kKeepKerfTable};
  if (name == "RESUME") return Statement{.kind = StatementKind::kAskProgress};
  if (name == "SLP") return Statement{.kind = StatementKind::kSleep};
  if (name.front() == 'H') {
    std::string_view letters = name;
    letters.remove_prefix(1);
    const auto axes = axes_in(letters);
    if (!axes) return std::nullopt;
    return Statement{.kind = StatementKind::kHome, .axes = *axes};
  }
  const auto number = number_in(name);
  if (!number) return std::nullopt;
  return Statement{
      .kind = StatementKind::kListing, .listing = ListingKind::kOneSetting, .number = *number};
}

std::optional<Statement> read_assignment(std::string_view name) {
  if (name == "J") return Statement{.kind = StatementKind::kJog};
  if (name == "I") return Statement{.kind = StatementKind::kSetUserText};
  if (name == "RST") return Statement{.kind = StatementKind::kRestore};
  if (name == "PC") return Statement{.kind = StatementKind::kSetPowerTable};
  if (name == "KW") return Statement{.kind = StatementKind::kWriteKerfPart};
  if (name == "KE") return Statement{.kind = StatementKind::kEraseKerfTable};
  if (name == "KR") return Statement{.kind = StatementKind::kReadKerfTable};
  if (name == "KQ") return Statement{.kind = StatementKind::kAskKerf};
  if (name == "RESUME") return Statement{.kind = StatementKind::kReenter};
  if (name == "N0") return Statement{.kind = StatementKind::kSetStartupLine, .number = 0};
  if (name == "N1") return Statement{.kind = StatementKind::kSetStartupLine, .number = 1};
  const auto number = number_in(name);
  if (!number) return std::nullopt;
  return Statement{.kind = StatementKind::kChangeSetting, .number = *number};
}

/// Returns `text` without the comment and the blanks at its end.
std::string_view without_comment(std::string_view text) {
  const std::size_t comment = text.find_first_of("(;");
  if (comment != std::string_view::npos) text.remove_suffix(text.size() - comment);
  while (!text.empty() && gcode::is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

std::optional<Statement> read_statement(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) {
    std::string_view written = without_comment(line);
    written.remove_prefix(1);
    const Name name{written};
    return name.fits() ? read_command(name.view()) : std::nullopt;
  }
  const Name name{{line.data() + 1, equals - 1}};
  if (!name.fits()) return std::nullopt;
  auto statement = read_assignment(name.view());
  if (!statement) return std::nullopt;
  std::size_t begin = equals + 1;
  while (begin < line.size() && gcode::is_blank(line[begin])) ++begin;
  statement->text = line;
  statement->text.remove_prefix(begin);
  // The text of a jog keeps its comment, because the reader of the jog handles comments.
  if (statement->kind != StatementKind::kJog) statement->text = without_comment(statement->text);
  statement->column = static_cast<std::uint16_t>(begin + 1);
  return statement;
}

}  // namespace cnc
