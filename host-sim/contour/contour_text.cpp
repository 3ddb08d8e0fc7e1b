#include "host-sim/contour/contour_text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>
#include <system_error>

namespace sim {
namespace {

constexpr std::string_view kSpaces = " \t\r";

/// Removes the first word from the line and returns it; empty at the end of the line.
std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kSpaces), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kSpaces));
  line.remove_prefix(word.size());
  return word;
}

class ContourReader {
 public:
  explicit ContourReader(std::string_view file) : file_{file} {}

  void read_line(std::string_view line) {
    ++line_;
    const bool comment = line.find('#') != std::string_view::npos;
    line = line.substr(0, line.find('#'));
    std::string_view rest = line;
    const std::string_view word = next_word(rest);
    if (word.empty()) {
      if (!comment) end_loop();
    } else if (word == "closed") {
      if (!next_word(rest).empty()) fail("nothing may follow `closed`");
      if (open_ == 0) fail("`closed` without a vertex before it");
      end_loop();
    } else {
      read_vertex(line);
    }
  }

  [[nodiscard]] Contour finish() {
    end_loop();
    if (contour_.loop_ends.empty()) fail("no contour in it");
    return contour_;
  }

 private:
  void read_vertex(std::string_view line) {
    ContourVertex vertex;
    vertex.x = number(next_word(line), "x");
    vertex.y = number(next_word(line), "y");
    if (const std::string_view word = next_word(line); !word.empty()) {
      vertex.bulge = number(word, "bulge");
    }
    if (!next_word(line).empty()) fail("more than x, y and bulge");
    contour_.vertices.push_back(vertex);
    ++open_;
  }

  double number(std::string_view word, std::string_view what) const {
    if (word.empty()) fail(fmt::format("{} is missing", what));
    double value = 0.0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) {
      fail(fmt::format("`{}` is no number for {}", word, what));
    }
    return value;
  }

  void end_loop() {
    if (open_ == 1) fail("a loop of one vertex");
    if (open_ > 0) contour_.end_loop();
    open_ = 0;
  }

  [[noreturn]] void fail(std::string_view reason) const {
    throw ContourTextError{file_, line_, reason};
  }

  std::string_view file_;
  std::size_t line_ = 0;
  std::size_t open_ = 0;  ///< Number of vertices of the loop that is being read.
  Contour contour_;
};

}  // namespace

ContourTextError::ContourTextError(std::string_view file, std::size_t line, std::string_view reason)
    : std::runtime_error{fmt::format("{}:{}: {}", file, line, reason)} {}

Contour contour_from_text(std::string_view text, std::string_view file) {
  ContourReader reader{file};
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    reader.read_line(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return reader.finish();
}

std::string text_of_contour(const cnc::contour::ContourView<double>& contour) {
  std::string text;
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
      const ContourVertex& vertex = contour.vertices[i];
      fmt::format_to(std::back_inserter(text), "{} {} {}\n", vertex.x, vertex.y, vertex.bulge);
    }
    text += "closed\n";
  }
  return text;
}

}  // namespace sim
