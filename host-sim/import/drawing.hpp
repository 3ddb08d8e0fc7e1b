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

/// Settings with which a project file of a laser program cuts a layer. They are the defaults of the
/// values that the user does not give.
struct OfferedSettings {
  std::string kind{};  ///< Kind of the setting, as the project spells it: Cut, Scan, Image …
  /// Power as a share of full power, 0…1. If the project gives a range, this is the upper end of
  /// the range.
  std::optional<double> power_share{};
  /// Power while the head is at rest, as a share of full power, 0…1.
  std::optional<double> min_power_share{};
  std::optional<double> speed_mm_s{};   ///< Speed of the cut, above 0.
  std::optional<std::size_t> passes{};  ///< Number of passes, 1 or more.
  /// Position in the order of cutting. Layers with lower numbers are cut first.
  std::optional<int> priority{};
  /// Distance between neighbouring lines of a filled area, above 0.
  std::optional<double> interval_mm{};
  std::optional<double> angle_deg{};  ///< Direction of the lines of a filled area. 0 is along X.
  /// Offset that the laser program applies to outlines. Kerfline does not apply it.
  std::optional<double> kerf_offset_mm{};
  std::string shading{};  ///< Shading of pictures, as the project spells it: grayscale, jarvis, …
  auto operator<=>(const OfferedSettings&) const = default;
};

/// A layer, by which a user sorts a drawing. Contours are joined only within one layer.
struct Layer {
  std::string name;  ///< Name of the DXF layer, the labelled SVG group or the part; may be empty.
  /// Colour of the layer. SVG: the colour of the stroke or, if there is no stroke, of the fill, as
  /// the file writes it. DXF: `ACI n` or `#rrggbb`.
  std::string colour;
  std::optional<OfferedSettings> offered{};
  auto operator<=>(const Layer&) const = default;
};

/// The rule that decides which points lie within a shape whose outlines cross or overlap.
enum class FillRule : std::uint8_t { kEvenOdd, kNonZero };

/// The entity of a file that drew a contour or a picture, or that a fault concerns.
struct Entity {
  /// Kind of the entity, with its id or handle if it has one: `path "outline"`, `LINE 2F`.
  std::string name{};
  std::size_t line = 0;    ///< Line in the file, from 1; 0 stands for the whole file.
  std::size_t column = 0;  ///< Column in the line, from 1; 0 stands for the whole line.
  std::size_t layer = 0;   ///< Index into Drawing::layers.
  /// Number of the part, if the file describes parts. Contours of different parts do not affect
  /// each other.
  std::size_t part = 0;
  /// Fill rule of the shape. An SVG that names no rule means kNonZero.
  FillRule fill_rule = FillRule::kEvenOdd;
  bool is_filled = false;   ///< The area of the entity is painted.
  bool has_outline = true;  ///< The outline of the entity is painted.
};

enum class FaultKind : std::uint8_t {
  kUnreadable,  ///< The file as a whole is refused.
  kBadEntity,   ///< An entity is left out, because its data make no sense.
  kTooMuch,     ///< A limit of size or work was reached; the rest of the drawing is left out.
  kText,        ///< Letters are left out, or are drawn in a font that the note names. No error.
  kOpen,        ///< No other end is within the gap of an end of a contour.
  /// More than two ends meet at one point, so it is a guess which of them are to be joined.
  kBranch,
  kTooSmall,   ///< A contour, or a part of it, is too narrow or too short to be cut as drawn.
  kDuplicate,  ///< A contour lies on an earlier contour; the path is cut once. No error.
  /// A contour crosses itself or another contour, and the crossing could not be resolved.
  kCrossing,
  kNoArcs,  ///< No arcs follow the contour within the tolerance; it is left out.
  /// The drawing is too large for a complete search for crossings, duplicates or holes.
  kUnchecked,
  kIgnored,  ///< An entity is left out, because it contains nothing to cut. No error.
  /// Contours are changed so that they can be cut: crossing contours are replaced by the outlines
  /// of the area that they fill, nearly closed contours are closed, and contours without area are
  /// left out. No error.
  kMended,
  /// A fact that the user should know about the reading of an entity or the drawing. No error.
  kNote,
  kPicture,     ///< A picture, which is burnt only if the settings of its layer say so. No error.
  kBadPicture,  ///< A picture cannot be read. This is an error only if its layer is to be burnt.
};

/// Returns the name of a kind for messages and for JSON: `unreadable`, `bad entity` …
[[nodiscard]] std::string_view name_of(FaultKind kind);

/// A fault or a note about a drawing, for the user.
struct Fault {
  FaultKind kind{};
  Entity entity;
  std::optional<Place> place_mm;
  std::string reason;
  std::string remedy;
  /// For kOpen: true if no other end is near, so that an open line may be intended.
  bool is_of_line = false;

  [[nodiscard]] bool is_error() const {
    return kind != FaultKind::kIgnored && kind != FaultKind::kNote && kind != FaultKind::kText &&
           kind != FaultKind::kMended && kind != FaultKind::kDuplicate &&
           kind != FaultKind::kPicture && kind != FaultKind::kBadPicture;
  }
};

/// Returns the message `file:line:column: path "a" at 3.000 4.000: reason; remedy`.
[[nodiscard]] std::string to_string(const Fault& fault, const std::string& file);

/// A row of curves. Each begins where the curve before it ends.
struct DrawnContour {
  std::vector<Shape> shapes;
  Entity entity;  ///< Entity that drew the first shape.
  bool closed = false;
  /// True if the contour is an outline of the area that crossing contours fill; see fill().
  bool is_filled = false;
  /// True if the contour is open, but a closed contour may be intended: an end of the contour is
  /// near one other end, or more than two ends meet at an end of the contour.
  bool is_doubtful = false;
  double length_mm = 0.0;
  /// Area that a closed contour encloses. The areas of its holes are not subtracted.
  double area_mm2 = 0.0;
  /// Number of closed contours of the same part that surround this contour.
  std::size_t depth = 0;
  /// Number of the innermost of the contours that `depth` counts.
  std::optional<std::size_t> parent;
  /// Number of an earlier contour, of another layer, that runs along the same path.
  std::optional<std::size_t> lies_on;
  /// Number of the innermost closed contour, of any part, around this contour. For an open contour,
  /// the number of the contour that surrounds the greatest share of it.
  std::optional<std::size_t> lies_in;
  /// For an open contour: numbers of the innermost contours around its points, in ascending order.
  std::vector<std::size_t> runs_through;

  /// Returns whether the contour is a hole: its depth is odd. Outer contours turn left, holes turn
  /// right.
  [[nodiscard]] bool is_hole() const { return depth % 2 == 1; }
};

/// A picture of a drawing.
struct DrawnPicture {
  std::shared_ptr<const picture::GreyImage> image{};  ///< Pixels of the picture; never null.
  /// Maps points of the picture, in pixels from its upper left corner with y down, to mm.
  Transform to_mm{};
  Entity entity{};
  /// Path of the picture file, relative to the folder of the drawing; empty if the drawing file
  /// itself contains the picture.
  std::string file{};
};

/// The stock that a sheet file describes: a rectangle whose lower left corner is the origin.
struct Stock {
  double width_mm = 0.0;
  double height_mm = 0.0;
  double margin_mm = 0.0;       ///< Width of the margin along all edges, in which no part may lie.
  bool keeps_skeleton = false;  ///< True if the stock around the parts stays in one piece.
};

/// The order in which the parts of a sheet file are cut, as a rank for each part.
struct PartTurns {
  /// Rank of each part in the order of cutting, indexed by Entity::part. Parts with lower ranks are
  /// cut first. If empty, the parts may be cut in any order.
  std::vector<std::size_t> of_part{};
  /// True if the file lists the parts in the order of cutting; false if each part names the parts
  /// after which it is cut.
  bool is_order_of_file = false;
};

/// The content of a drawing file: everything that could be read, and a list of faults.
struct Drawing {
  std::string file;
  std::optional<Stock> stock{};  ///< Stock, if the file is a sheet file.
  /// Names of the parts, indexed by Entity::part; empty unless the file is a sheet file.
  std::vector<std::string> parts{};
  PartTurns turns{};
  std::vector<Layer> layers;
  std::vector<DrawnContour> contours;
  std::vector<DrawnPicture> pictures{};
  /// The first kMaxFaults faults, in the order in which they were found.
  std::vector<Fault> faults;
  std::size_t more_faults = 0;  ///< Number of faults that were found but are not listed.
  std::size_t more_lines = 0;   ///< Number of unlisted open contours (Fault::is_of_line).

  [[nodiscard]] bool has_errors() const;
};

/// Greatest size of a file. Larger files are refused.
inline constexpr std::size_t kMaxBytes = std::size_t{256} << 20;
inline constexpr std::size_t kMaxShapes = 2'000'000;
inline constexpr std::size_t kMaxFaults = 1'000;
/// Greatest depth of nested groups, blocks and instances.
inline constexpr std::size_t kDeepestNesting = 64;
/// Greatest distance of a point from the origin along each axis. No machine is that large, so a
/// greater distance is probably caused by a wrong unit.
inline constexpr double kFarthestMm = 1.0e7;

/// The treatments of letters.
enum class TextMode : std::uint8_t {
  kSkip,  ///< Letters are left out, and a note reports it.
  /// Letters become outlines of the font that the drawing names, or of the most similar font.
  kOutline,
  kStroke,  ///< Letters become single strokes, as an engraver draws them.
};

/// Returns the bytes of the file at a path relative to the folder of the drawing. Throws
/// std::exception if the file cannot be read.
using ReadBeside = std::function<std::string(const std::string& name)>;

struct ImportOptions {
  double gap_mm = 0.01;  ///< Greatest distance between two ends that count as one point, 0 or more.
  /// True: uses a wider gap than `gap_mm` if the wider gap closes most open ends; see wider_gap().
  bool finds_gap = false;
  /// True: adds a line between two ends up to kWidestCertainGapMm apart if no other end is near
  /// them, and a line that closes a contour whose ends are close together. Notes report these
  /// lines.
  bool mends_gaps = false;
  /// Millimetres per unit of the drawing (a unit of DXF, a pixel of SVG). It replaces the unit that
  /// the file gives or its format implies. From kMinUnitMm to kGreatestUnitMm.
  std::optional<double> unit_mm{};
  /// Share of the full bounds on work that reading the drawing may use, above 0 and at most 1. The
  /// bounds limit the number of drawn copies, the conversion of curves, and comparisons. Work up to
  /// the full bounds may take twenty seconds.
  double effort = 1.0;
  TextMode text = TextMode::kSkip;
  /// True: reports contours that cross each other or run along each other as an error, instead of
  /// replacing them by the outlines of the area that they fill. Required by tools that clear areas,
  /// because a wrong guess could clear an area that is meant to stay.
  bool refuses_crossings = false;
  /// Function that reads the picture files to which a drawing links. If it is empty, linked
  /// pictures are not read.
  ReadBeside read_beside{};
};

inline constexpr double kMinGapMm = 0.0;
inline constexpr double kGreatestGapMm = 10.0;
inline constexpr double kMinUnitMm = 1.0e-6;
inline constexpr double kGreatestUnitMm = 1.0e6;

/// Reads a drawing. Detects the format by content: SVG or SVGZ, DXF, PDF, a LightBurn project, or
/// the JSON of nesting and cutting jobs. No content of a file makes this function throw. The limits
/// above bound its work. Decodes the pictures of SVG files and of LightBurn projects. Reads picture
/// files below the folder of the drawing with `options.read_beside`.
/// @pre gap, unit and effort are within their limits
[[nodiscard]] Drawing read_drawing(const std::string& file,
                                   const std::string& text,
                                   const ImportOptions& options = {});

}  // namespace sim::drawing
