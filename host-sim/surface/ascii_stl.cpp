#include <fmt/format.h>

#include <array>
#include <cmath>

#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/point_merger.hpp"
#include "host-sim/surface/refusal.hpp"
#include "host-sim/surface/stl_reader.hpp"
#include "host-sim/surface/text_lines.hpp"

namespace sim::surface {
namespace {

/// Reads an STL text line by line. A facet is added at the end of its loop.
class StlText {
 public:
  StlText(std::string_view text, const std::string& name) : name_{name}, lines_{text} {}

  MeshDraft read() {
    while (const auto line = lines_.next()) {
      TextWords words{*line, lines_.number()};
      const std::string_view word = words.next();
      const auto is = [&](std::string_view small) { return equals_in_small_letters(word, small); };
      if (is("vertex")) {
        take_corner(words);
      } else if (is("facet")) {
        corners_ = 0;
      } else if (is("endloop")) {
        end_loop();
      } else if (is("solid") || is("endsolid")) {
        inside_ = is("solid");
      } else if (!word.empty() && !is("outer") && !is("endfacet")) {
        refuse_line(fmt::format("`{}` is not a word of STL", shown(word)));
      }
    }
    if (inside_) refuse_line("ends without endsolid", "the file is cut off; export it again");
    draft_.mesh.points = merger_.take_points();
    draft_.name = name_;
    return std::move(draft_);
  }

 private:
  [[noreturn]] void refuse_line(const std::string& reason,
                                std::string_view remedy = "export the mesh again") const {
    refuse(name_,
           lines_.number(),
           fmt::format("facet {}: {}", draft_.mesh.facets.size() + 1, reason),
           remedy);
  }

  void take_corner(TextWords& words) {
    if (corners_ == 3) refuse_line("has more than 3 corners");
    std::array<double, 3> values{};
    for (double& value : values) {
      const std::string_view word = words.next();
      const auto number = parsed_number(word);
      if (!number || !std::isfinite(*number)) {
        refuse_line(fmt::format("`{}` is not a finite number", shown(word)));
      }
      value = *number;
    }
    facet_[corners_++] = merger_.number({values[0], values[1], values[2]});
  }

  void end_loop() {
    if (corners_ != 3) refuse_line(fmt::format("has {} corners in place of 3", corners_));
    if (draft_.mesh.facets.size() >= 2 * kMaxPoints) refuse_line("too many", "thin the mesh out");
    draft_.mesh.facets.push_back(facet_);
    corners_ = 0;
  }

  const std::string& name_;
  TextLines lines_;
  PointMerger merger_;
  MeshDraft draft_;
  std::array<std::uint32_t, 3> facet_{};
  std::size_t corners_ = 0;
  bool inside_ = false;
};

}  // namespace

MeshDraft read_ascii_stl(std::string_view text, const std::string& name) {
  return StlText{text, name}.read();
}

}  // namespace sim::surface
