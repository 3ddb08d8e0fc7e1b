#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/plot/view.hpp"

namespace sim {

/// A column of a table on a page.
struct SheetColumn {
  std::string heading;
  double width_pt = 0.0;
  bool is_number = false;  ///< True if the cells are aligned to the right.
};

/// Lays out texts, tables and pictures on A4 pages, which are SVG documents, from top to bottom.
/// Content that does not fit on the rest of a page is placed on the next page. Lengths are in
/// points of 1/72 inch.
class SheetPages {
 public:
  static constexpr double kMarginPt = 42.0;
  static constexpr double kTextPt = 9.5;

  /// @param footer text at the bottom of each page, which the page number follows
  explicit SheetPages(std::string footer);

  void add_title(std::string_view text);
  /// Appends a heading. It is on the same page as the first `needed_pt` of the content after it.
  void add_heading(std::string_view text, double needed_pt = 40.0);
  /// Appends a text, which is broken into lines.
  void add_text(std::string_view text);
  /// Appends a table. The headings are repeated on each page of the table. Texts that are too long
  /// for their cell are cut off and end in `…`.
  /// @pre each row has a cell for each column
  void add_table(const std::vector<SheetColumn>& columns,
                 const std::vector<std::vector<std::string>>& rows);
  /// Reserves a box for a picture, as wide as the page, and returns the box. The caller must append
  /// the picture to page(). If the rest of the present page has at least half of `height_pt`, the
  /// box is as high as this rest allows; otherwise it is on the next page.
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
  double y_pt_ = 0.0;  ///< Bottom of the content on the present page.
};

/// Returns a text. If it would be wider than `width_pt`, it is cut off and ends in `…`.
[[nodiscard]] std::string fitted_text(std::string_view text, double width_pt, double size_pt);

}  // namespace sim
