#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/import/curve.hpp"
#include "host-sim/picture/grey_image.hpp"

namespace sim::drawing {

/// How a project of a laser program cuts a layer: defaults for whoever does not say it.
struct OfferedSettings {
  std::string kind{};                   ///< As the project has it: Cut, Scan, Image …
  std::optional<double> power_share{};  ///< Share of full power, 0…1; the greatest of a range.
  std::optional<double> least_power_share{};  ///< Share of full power, 0…1, at rest.
  std::optional<double> speed_mm_s{};         ///< Above 0.
  std::optional<std::size_t> passes{};        ///< 1 or more.
  std::optional<int> priority{};              ///< Lower ones are cut first.
  std::optional<double> interval_mm{};        ///< From line to line of a filled area; above 0.
  std::optional<double> angle_deg{};          ///< Direction of these lines; 0 is along X.
  std::optional<double> kerf_offset_mm{};     ///< By which its program moves outlines; not taken.
  std::string shading{};  ///< Of pictures, as the project has it: grayscale, jarvis, …
  auto operator<=>(const OfferedSettings&) const = default;
};

/// What a user sorts a drawing by: contours are joined within one layer only.
struct Layer {
  std::string name;    ///< Of the DXF layer, the labelled SVG group, the part; may be empty.
  std::string colour;  ///< SVG: stroke, else fill, as written. DXF: `ACI n` or `#rrggbb`.
  std::optional<OfferedSettings> offered{};
  auto operator<=>(const Layer&) const = default;
};

/// Which places lie within a shape whose outlines cross or overlap.
enum class FillRule : std::uint8_t { kEvenOdd, kNonZero };

/// What of a file something was drawn by.
struct Entity {
  std::string name{};      ///< `path "outline"`, `LINE 2F`: kind, and id or handle if any.
  std::size_t line = 0;    ///< From 1; 0 for the whole file.
  std::size_t column = 0;  ///< From 1; 0 where the whole line is meant.
  std::size_t layer = 0;   ///< Index into Drawing::layers.
  std::size_t part = 0;    ///< Of files of parts: contours of others are none of its business.
  FillRule fill_rule = FillRule::kEvenOdd;  ///< SVG names it and means kNonZero where it does not.
  bool is_filled = false;                   ///< Its area is painted, not only its outline.
  bool has_outline = true;                  ///< Its outline is painted, not only its area.
};

enum class FaultKind : std::uint8_t {
  kUnreadable,  ///< The file as a whole is refused.
  kBadEntity,   ///< An entity is left out, because what it says makes no sense.
  kTooMuch,     ///< A limit was reached; the rest is left out.
  kText,        ///< Letters that are left out, or the font in which they are drawn. No error.
  kOpen,        ///< An end that meets no other one.
  kBranch,      ///< More than two ends meet; which of them belong together is a guess.
  kTooSmall,    ///< Shorter than the gap that is joined, or without area; left out.
  kDuplicate,   ///< Drawn before at the same place; cut once. No error.
  kCrossing,    ///< A contour crosses itself or another one, and is not mended.
  kNoArcs,      ///< No arcs follow it within the tolerance; its contour is left out.
  kUnchecked,   ///< Too much to look for crossings everywhere.
  kIgnored,     ///< Nothing that could be cut; left out. No error.
  kMended,      ///< Contours that cross are read as what they fill. No error.
  kNote,        ///< Read in a way that the user should know; nothing is left out. No error.
  kPicture,     ///< Burnt only where its layer says so. No error.
  kBadPicture,  ///< Cannot be read. An error only where its layer is to be burnt.
};

/// `unreadable`, `bad entity` …, for people and for JSON.
[[nodiscard]] std::string_view name_of(FaultKind kind);

/// Something that a user should know of a drawing.
struct Fault {
  FaultKind kind{};
  Entity entity;
  std::optional<Place> place_mm;
  std::string reason;
  std::string remedy;
  bool is_of_line = false;  ///< kOpen: no other end is near, so that it may be meant as a line.

  [[nodiscard]] bool is_error() const {
    return kind != FaultKind::kIgnored && kind != FaultKind::kNote && kind != FaultKind::kText &&
           kind != FaultKind::kMended && kind != FaultKind::kDuplicate &&
           kind != FaultKind::kPicture && kind != FaultKind::kBadPicture;
  }
};

/// `file:line:column: path "a" at 3.000 4.000: reason; remedy`.
[[nodiscard]] std::string to_string(const Fault& fault, const std::string& file);

/// A row of curves, each beginning where the one before it ends.
struct DrawnContour {
  std::vector<Shape> shapes;
  Entity entity;  ///< Of the first shape as drawn.
  bool closed = false;
  bool is_filled = false;  ///< An outline of what contours that cross fill: see fill().
  /// Open, and perhaps meant closed: an end is near one other end, or more than two ends meet.
  bool is_doubtful = false;
  double length_mm = 0.0;
  double area_mm2 = 0.0;              ///< Area of a closed contour; its holes are not subtracted.
  std::size_t depth = 0;              ///< Closed contours of its part around this one.
  std::optional<std::size_t> parent;  ///< The innermost of them.
  /// An earlier contour, of another layer, at the same place.
  std::optional<std::size_t> lies_on;
  /// The innermost of all parts' contours around this one; around most of it if it is open.
  std::optional<std::size_t> lies_in;
  /// The innermost contours around places of an open one, in the order of their numbers.
  std::vector<std::size_t> runs_through;

  /// Odd depth. Outer contours turn left, holes turn right.
  [[nodiscard]] bool is_hole() const { return depth % 2 == 1; }
};

/// A picture of a drawing.
struct DrawnPicture {
  std::shared_ptr<const picture::GreyImage> image{};  ///< Never null.
  Transform to_mm{};  ///< Of places in it, in pixels from its upper left corner, y down.
  Entity entity{};
  std::string file{};  ///< Its file, by its path from the drawing; empty where the drawing has it.
};

/// The stock that a sheet file describes; its corner is the origin.
struct Stock {
  double width_mm = 0.0;
  double height_mm = 0.0;
  double margin_mm = 0.0;       ///< Along all edges, free of parts.
  bool keeps_skeleton = false;  ///< What is left of it stays in one piece.
};

/// When the parts of a sheet file are cut.
struct PartTurns {
  std::vector<std::size_t> of_part{};  ///< By Entity::part: lower ones first. Empty: in any order.
  /// The order is the only wish; else each part says after which others it is cut.
  bool is_order_of_file = false;
};

/// What a file draws: all that is sound in it, and everything that is not.
struct Drawing {
  std::string file;
  std::optional<Stock> stock{};      ///< Of a sheet file.
  std::vector<std::string> parts{};  ///< Names by Entity::part; empty unless it is a sheet file.
  PartTurns turns{};
  std::vector<Layer> layers;
  std::vector<DrawnContour> contours;
  std::vector<DrawnPicture> pictures{};
  std::vector<Fault> faults;    ///< At most kMostFaults, in the order found.
  std::size_t more_faults = 0;  ///< Found and not listed.
  std::size_t more_lines = 0;   ///< Open contours, as Fault::is_of_line has them, and not listed.

  [[nodiscard]] bool has_errors() const;
};

/// Greater ones are refused as a whole.
inline constexpr std::size_t kMostBytes = std::size_t{256} << 20;
inline constexpr std::size_t kMostShapes = 2'000'000;
inline constexpr std::size_t kMostFaults = 1'000;
/// Nested groups, blocks and instances.
inline constexpr std::size_t kDeepestNesting = 64;
/// Farther from the origin than any machine reaches; nearer to a slip of units.
inline constexpr double kFarthestMm = 1.0e7;

/// The ways to treat letters.
enum class TextMode : std::uint8_t {
  kSkip,     ///< Left out, and a note says so.
  kOutline,  ///< Outlines of the font that the drawing names, or of the nearest one.
  kStroke,   ///< Single strokes, as an engraver draws them.
};

/// Returns the bytes of a file by its path from the drawing. Throws std::exception where it cannot
/// be read.
using ReadBeside = std::function<std::string(const std::string& name)>;

struct ImportOptions {
  double gap_mm = 0.01;  ///< Ends no farther apart are one place. 0 or more.
  /// Takes a wider gap where that closes most open ends; see wider_gap().
  bool finds_gap = false;
  /// Joins two ends up to kWidestCertainGapMm apart that have no other neighbour, and closes what
  /// nearly closes itself, by lines; notes say so.
  bool mends_gaps = false;
  /// Millimetres per unit of the drawing, in place of what the file says or its format means:
  /// a unit of DXF, a pixel of SVG. From kLeastUnitMm to kGreatestUnitMm.
  std::optional<double> unit_mm{};
  /// Share of the work that a drawing may take, above 0 and at most 1: of what copies it draws,
  /// what curves become and what is compared. All of it may be twenty seconds.
  double effort = 1.0;
  TextMode text = TextMode::kSkip;
  /// Reads contours that cross each other or run along each other as an error, not as what they
  /// fill: a tool that clears areas would clear what may be meant to stay.
  bool refuses_crossings = false;
  /// Reads pictures that a drawing links; without it they are not read.
  ReadBeside read_beside{};
};

inline constexpr double kLeastGapMm = 0.0;
inline constexpr double kGreatestGapMm = 10.0;
inline constexpr double kLeastUnitMm = 1.0e-6;
inline constexpr double kGreatestUnitMm = 1.0e6;

/// Reads SVG, DXF or the JSON of nesting and cutting jobs, told by content. Never
/// throws for what a file says; bounded by the limits above. Pictures of SVG and of projects are
/// decoded, from files below the folder of the drawing also by `read_beside`.
/// @pre gap, unit and effort within their limits
[[nodiscard]] Drawing read_drawing(const std::string& file,
                                   const std::string& text,
                                   const ImportOptions& options = {});

}  // namespace sim::drawing
