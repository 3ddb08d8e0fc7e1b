#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/plot/view.hpp"

namespace sim {

/// A column of a table on paper.
struct SheetColumn {
  std::string heading;
  double width_pt = 0.0;
  bool is_number = false;  ///< The cells are aligned to the right.
};

/// Lays out texts, tables and pictures on A4 pages as SVG documents, from top to bottom. Content
/// that does not fit on a page begins the next one. Lengths are points of 1/72 inch.
class SheetPages {
 public:
  static constexpr double kMarginPt = 42.0;
  static constexpr double kTextPt = 9.5;

  /// @param footer text below each page, followed by the page number
  explicit SheetPages(std::string footer);

  void add_title(std::string_view text);
  /// Appends a heading that stays on one page with the first `needed_pt` of the content after it.
  void add_heading(std::string_view text, double needed_pt = 40.0);
  /// Appends a text in as many lines as it needs.
  void add_text(std::string_view text);
  /// Appends a table. Its headings are repeated on each page, and cells that are too long end in
  /// `…`.
  /// @pre each row has a cell for each column
  void add_table(const std::vector<SheetColumn>& columns,
                 const std::vector<std::vector<std::string>>& rows);
  /// Reserves the space for a picture over the width of the page, and returns it. The caller
  /// appends the picture to page(). The rest of a page is used if it has at least half of
  /// `height_pt`.
  [[nodiscard]] Box take_box(double height_pt);
  [[nodiscard]] std::string& page() { return pages_.back(); }

  /// Returns the pages as SVG documents.
  [[nodiscard]] std::vector<std::string> finish();

  [[nodiscard]] static double width_pt();

 private:
  void begin_page();
  void make_room(double height_pt);
  void add_row(const std::vector<SheetColumn>& columns,
               const std::vector<std::string>& cells,
               bool is_heading);
  [[nodiscard]] double left_pt() const;

  std::string footer_;
  std::vector<std::string> pages_;
  double y_pt_ = 0.0;  ///< The bottom of the content on the page so far.
};

/// Returns the text, cut off with `…` if it would be wider than `width_pt`.
[[nodiscard]] std::string fitted_text(std::string_view text, double width_pt, double size_pt);

}  // namespace sim
