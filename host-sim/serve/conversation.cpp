#include "host-sim/serve/conversation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <stdexcept>

#include "host-sim/serve/escaped_text.hpp"

namespace sim {
namespace {

constexpr std::string_view kFirstLine = "kerfline conversation 1";

bool has_bytes(Exchange::Kind kind) {
  return kind == Exchange::Kind::kHeard || kind == Exchange::Kind::kSaid ||
         kind == Exchange::Kind::kBeside;
}

/// Reader of one conversation, which takes its lines one after the other.
class ConversationReader {
 public:
  explicit ConversationReader(const std::string& name) : name_{name} {}

  void read_line(std::string_view line) {
    ++number_;
    if (number_ == 1) {
      if (line != kFirstLine) fail(fmt::format("does not begin with `{}`", kFirstLine));
      return;
    }
    if (line.empty() || line.front() == '#') return;
    if (ended_) fail("has text after the `end` line; remove it");
    const std::string_view word = take_word(line);
    if (word == "set") {
      read_.setting.settings.push_back(parse_setting(line, place()));
    } else if (word == "record") {
      const auto number_read = number<std::uint16_t>(take_word(line));
      read_.setting.records[number_read] = to_record(bytes(line));
    } else if (word == "probe_plate") {
      read_.setting.probe_plate_z_mm = number<double>(line);
    } else if (word == "probe_surface") {
      const auto tip_mm = number<double>(take_word(line));
      if (!(tip_mm >= 0.0 && std::isfinite(tip_mm))) fail("the diameter of a tip is 0 mm or more");
      read_.setting.probe_surface = {.tip_mm = tip_mm, .file = bytes(line)};
    } else if (word == "end") {
      read_.end_ns = number<std::uint64_t>(line);
      ended_ = true;
    } else {
      read_exchange(word, line);
    }
  }

  Conversation result() {
    if (number_ == 0) fail("is empty");
    if (!ended_) fail("has no line that begins with `end`");
    return std::move(read_);
  }

 private:
  void read_exchange(std::string_view word, std::string_view line) {
    constexpr std::string_view kKinds = "><^|!";
    const bool is_kind = word.size() == 1 && kKinds.find(word.front()) != std::string_view::npos;
    if (!is_kind) fail(fmt::format("`{}` is no known kind of line", word));
    Exchange exchange{.kind = Exchange::Kind{word.front()},
                      .time_ns = number<std::uint64_t>(take_word(line)),
                      .bytes = {},
                      .line = number_};
    if (has_bytes(exchange.kind)) exchange.bytes = bytes(line);
    if (!read_.exchanges.empty() && exchange.time_ns < read_.exchanges.back().time_ns) {
      fail("its time is before that of the line above");
    }
    read_.exchanges.push_back(std::move(exchange));
  }

  [[nodiscard]] std::string bytes(std::string_view text) const {
    const auto read = unescaped(text);
    if (!read) fail(R"(the bytes are not of the form "G0 X1\n")");
    return *read;
  }

  static std::vector<std::byte> to_record(const std::string& bytes) {
    const auto span = std::as_bytes(std::span{bytes});
    return {span.begin(), span.end()};
  }

  /// Removes the first word and the blank after it from the front of the line, and returns the
  /// word.
  static std::string_view take_word(std::string_view& line) {
    const std::size_t blank = std::min(line.find(' '), line.size());
    const std::string_view word = line.substr(0, blank);
    line.remove_prefix(std::min(blank + 1, line.size()));
    return word;
  }

  template <typename Number>
  Number number(std::string_view text) const {
    Number value{};
    const char* end = text.data() + text.size();
    const auto [stop, fault] = std::from_chars(text.data(), end, value);
    if (fault != std::errc{} || stop != end) fail(fmt::format("`{}` is not a number", text));
    return value;
  }

  [[nodiscard]] std::string place() const { return fmt::format("{}:{}", name_, number_); }
  [[noreturn]] void fail(const std::string& reason) const {
    throw std::invalid_argument(fmt::format("{}: {}", place(), reason));
  }

  std::string name_;
  std::size_t number_ = 0;
  bool ended_ = false;
  Conversation read_{};
};

}  // namespace

std::string head_text(const ConversationSetting& setting) {
  std::string text = fmt::format("{}\n", kFirstLine);
  text +=
      "# > heard by the controller, < said by it, ^ acted beside its lines, | nobody took more, "
      "! stopped; times in ns\n";
  text += fmt::format("probe_plate {}\n", setting.probe_plate_z_mm);
  if (const auto& surface = setting.probe_surface) {
    text += fmt::format("probe_surface {} {}\n", surface->tip_mm, escaped(surface->file));
  }
  for (const SettingChange& change : setting.settings) {
    text += fmt::format("set ${}={}\n", change.number, change.value);
  }
  for (const auto& [number, record] : setting.records) {
    const std::string_view bytes{reinterpret_cast<const char*>(record.data()), record.size()};
    text += fmt::format("record {} {}\n", number, escaped(bytes));
  }
  return text;
}

std::string to_text(const Exchange& exchange) {
  const char kind = static_cast<char>(exchange.kind);
  if (!has_bytes(exchange.kind)) return fmt::format("{} {}\n", kind, exchange.time_ns);
  return fmt::format("{} {} {}\n", kind, exchange.time_ns, escaped(exchange.bytes));
}

std::string end_text(std::uint64_t end_ns) { return fmt::format("end {}\n", end_ns); }

std::string to_text(const Conversation& conversation) {
  std::string text = head_text(conversation.setting);
  for (const Exchange& exchange : conversation.exchanges) text += to_text(exchange);
  return text + end_text(conversation.end_ns);
}

Conversation parse_conversation(std::string_view text, const std::string& name) {
  ConversationReader reader{name};
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    reader.read_line(text.substr(0, length));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return reader.result();
}

}  // namespace sim
