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
  bool is_number = false;  ///< Aligned to the right.
};

/// Lays texts, tables and pictures out on A4 pages as SVG documents, from top to bottom; what does
/// not fit on a page begins the next. Lengths are points of 1/72 inch.
class SheetPages {
 public:
  static constexpr double kMarginPt = 42.0;
  static constexpr double kTextPt = 9.5;

  /// @param footer stands below each page, with its number
  explicit SheetPages(std::string footer);

  void add_title(std::string_view text);
  /// Appends a heading that stays together with `needed_pt` of what follows it.
  void add_heading(std::string_view text, double needed_pt = 40.0);
  /// Appends a text in as many lines as it needs.
  void add_text(std::string_view text);
  /// Appends a table; its headings are repeated on each page, and cells that are too long end in
  /// `…`. @pre each row has a cell for each column
  void add_table(const std::vector<SheetColumn>& columns,
                 const std::vector<std::vector<std::string>>& rows);
  /// Takes the space for a picture over the width of the page, and returns it; the picture is
  /// appended to page(). The rest of a page is used from half of the height on.
  [[nodiscard]] Box take_box(double height_pt);
  [[nodiscard]] std::string& page() { return pages_.back(); }

  /// Returns the documents.
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
  double y_pt_ = 0.0;  ///< The bottom of what is on the page so far.
};

/// Returns a text that is no wider than given, cut off with `…` where it has to be.
[[nodiscard]] std::string fitted_text(std::string_view text, double width_pt, double size_pt);

}  // namespace sim
