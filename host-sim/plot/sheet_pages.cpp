#include "host-sim/plot/sheet_pages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host-sim/cut/kerf_notes.hpp"
#include "host-sim/plot/pdf.hpp"
#include "host-sim/plot/svg_element.hpp"
#include "host-sim/report/utf8.hpp"

namespace sim {
namespace {

constexpr double kLineHeightPt = 13.0;
constexpr double kTableLinePt = 14.0;
constexpr double kFooterPt = 26.0;
constexpr double kCellGapPt = 6.0;
/// Width of a letter as a share of the font size. kWideLetter is the width of wide letters, so that
/// no cell overflows. kMeanLetter is the mean width in a text.
constexpr double kWideLetter = 0.64;
constexpr double kMeanLetter = 0.52;
constexpr std::string_view kSoftInk = "#5b626c";

}  // namespace

std::string fitted_text(std::string_view text, double width_pt, double size_pt) {
  const auto columns = static_cast<std::size_t>(width_pt / (kWideLetter * size_pt));
  if (display_width(text) <= columns) return std::string{text};
  std::string fitted;
  std::size_t width = 1;
  while (!text.empty()) {
    const std::size_t bytes = first_character(text).bytes;
    width += display_width(text.substr(0, bytes));
    if (width > columns) break;
    fitted += text.substr(0, bytes);
    text.remove_prefix(bytes);
  }
  return fitted + "\u2026";
}

SheetPages::SheetPages(std::string footer) : footer_{std::move(footer)} { begin_page(); }

double SheetPages::width_pt() { return kPageWidthPt - 2.0 * kMarginPt; }

void SheetPages::begin_page() {
  pages_.push_back(svg::document_start(kPageWidthPt, kPageHeightPt));
  svg::add_box(pages_.back(), {0.0, 0.0, kPageWidthPt, kPageHeightPt}, "#ffffff");
  y_pt_ = kMarginPt;
}

double SheetPages::left_pt() const { return kPageHeightPt - kMarginPt - kFooterPt - y_pt_; }

void SheetPages::make_room(double height_pt) {
  if (height_pt > left_pt() && y_pt_ > kMarginPt) begin_page();
}

void SheetPages::add_title(std::string_view text) {
  constexpr double kTitlePt = 19.0;
  make_room(30.0);
  y_pt_ += 22.0;
  svg::add_text(page(),
                kMarginPt,
                y_pt_,
                {.size_px = kTitlePt, .weight = "bold"},
                fitted_text(text, width_pt(), kTitlePt));
  y_pt_ += 6.0;
}

void SheetPages::add_heading(std::string_view text, double needed_pt) {
  constexpr double kHeadingPt = 12.0;
  make_room(26.0 + needed_pt);
  y_pt_ += 22.0;
  svg::add_text(page(), kMarginPt, y_pt_, {.size_px = kHeadingPt, .weight = "bold"}, text);
  y_pt_ += 4.0;
}

void SheetPages::add_text(std::string_view text) {
  const auto columns = static_cast<std::size_t>(width_pt() / (kMeanLetter * kTextPt));
  for (const std::string& line : cut::wrapped(std::string{text}, columns)) {
    make_room(kLineHeightPt);
    y_pt_ += kLineHeightPt;
    svg::add_text(page(),
                  kMarginPt,
                  y_pt_,
                  {.size_px = kTextPt},
                  fitted_text(line, width_pt() * kWideLetter / kMeanLetter, kTextPt));
  }
}

void SheetPages::add_row(const std::vector<SheetColumn>& columns,
                         const std::vector<std::string>& cells,
                         bool is_heading) {
  y_pt_ += kTableLinePt;
  double x_pt = kMarginPt;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const SheetColumn& column = columns[i];
    const double end_pt = x_pt + column.width_pt;
    const svg::TextStyle style{.size_px = kTextPt,
                               .anchor = column.is_number ? "end" : "start",
                               .weight = is_heading ? "bold" : "normal"};
    svg::add_text(page(),
                  column.is_number ? end_pt - kCellGapPt : x_pt,
                  y_pt_ - 4.0,
                  style,
                  fitted_text(cells[i], column.width_pt - kCellGapPt, kTextPt));
    x_pt = end_pt;
  }
  svg::add_line(page(),
                kMarginPt,
                y_pt_,
                kMarginPt + width_pt(),
                y_pt_,
                {is_heading ? "#222222" : "#d8dde3", is_heading ? 0.8 : 0.5});
}

void SheetPages::add_table(const std::vector<SheetColumn>& columns,
                           const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::string> headings;
  headings.reserve(columns.size());
  for (const SheetColumn& column : columns) headings.push_back(column.heading);
  constexpr double kGapPt = 5.0;
  make_room(2.0 * kTableLinePt + kGapPt);
  y_pt_ += kGapPt;
  add_row(columns, headings, true);
  for (const auto& row : rows) {
    if (kTableLinePt > left_pt()) {
      begin_page();
      add_row(columns, headings, true);
    }
    add_row(columns, row, false);
  }
  y_pt_ += 2.0;
}

Box SheetPages::take_box(double height_pt) {
  constexpr double kGapPt = 8.0;
  if (height_pt + kGapPt > left_pt() && left_pt() < 0.5 * height_pt) begin_page();
  const double height = std::min(height_pt, left_pt() - kGapPt);
  const Box box{kMarginPt, y_pt_ + kGapPt, width_pt(), height};
  y_pt_ = box.bottom_px();
  return box;
}

std::vector<std::string> SheetPages::finish() {
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    const double y_pt = kPageHeightPt - kMarginPt;
    const svg::TextStyle style{.size_px = 8.5, .fill = kSoftInk};
    svg::add_text(pages_[i], kMarginPt, y_pt, style, fitted_text(footer_, 0.8 * width_pt(), 8.5));
    svg::add_text(pages_[i],
                  kPageWidthPt - kMarginPt,
                  y_pt,
                  {.size_px = 8.5, .anchor = "end", .fill = kSoftInk},
                  fmt::format("page {} of {}", i + 1, pages_.size()));
    pages_[i] += "</svg>\n";
  }
  return std::move(pages_);
}

}  // namespace sim
