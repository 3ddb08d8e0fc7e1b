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

/// Settings with which a project of a laser program cuts a layer. They are defaults for values that
/// the user does not give.
struct OfferedSettings {
  std::string kind{};  ///< Kind as the project spells it: Cut, Scan, Image …
  /// Share of full power, 0…1; the upper end if the project gives a range.
  std::optional<double> power_share{};
  std::optional<double> min_power_share{};  ///< Share of full power, 0…1, of the head at rest.
  std::optional<double> speed_mm_s{};       ///< Speed above 0.
  std::optional<std::size_t> passes{};      ///< Number of passes, 1 or more.
  std::optional<int> priority{};            ///< Layers with lower numbers are cut first.
  std::optional<double> interval_mm{};  ///< Distance between the lines of a filled area; above 0.
  std::optional<double> angle_deg{};    ///< Direction of the lines of a filled area; 0 is along X.
  /// Offset of outlines in the laser program. Kerfline does not apply it.
  std::optional<double> kerf_offset_mm{};
  std::string shading{};  ///< Shading of pictures, as the project spells it: grayscale, jarvis, …
  auto operator<=>(const OfferedSettings&) const = default;
};

/// A layer, by which a user sorts a drawing. Contours are joined only within one layer.
struct Layer {
  std::string name;  ///< Name of the DXF layer, the labelled SVG group or the part; may be empty.
  /// SVG: colour of the stroke, or else of the fill, as written. DXF: `ACI n` or `#rrggbb`.
  std::string colour;
  std::optional<OfferedSettings> offered{};
  auto operator<=>(const Layer&) const = default;
};

/// The rule that decides which points lie within a shape whose outlines cross or overlap.
enum class FillRule : std::uint8_t { kEvenOdd, kNonZero };

/// The entity of a file that drew a contour or a picture, or that a fault concerns.
struct Entity {
  std::string name{};    ///< Kind, with id or handle if there is one: `path "outline"`, `LINE 2F`.
  std::size_t line = 0;  ///< Line from 1; 0 if the whole file is meant.
  std::size_t column = 0;  ///< Column from 1; 0 if the whole line is meant.
  std::size_t layer = 0;   ///< Index into Drawing::layers.
  /// Number of the part, in files of parts. Contours of different parts do not affect each other.
  std::size_t part = 0;
  /// Fill rule. SVG may name it; an SVG without one means kNonZero.
  FillRule fill_rule = FillRule::kEvenOdd;
  bool is_filled = false;   ///< The entity's area is painted, not only its outline.
  bool has_outline = true;  ///< The entity's outline is painted, not only its area.
};

enum class FaultKind : std::uint8_t {
  kUnreadable,  ///< The file as a whole is refused.
  kBadEntity,   ///< An entity is left out, because its data make no sense.
  kTooMuch,     ///< A limit was reached; the rest is left out.
  kText,    ///< Letters are left out, or the note names the font in which they are drawn. No error.
  kOpen,    ///< An end of a contour meets no other end.
  kBranch,  ///< More than two ends meet. Which of them are joined is a guess.
  kTooSmall,   ///< A contour is shorter than the gap that is joined, or has no area; left out.
  kDuplicate,  ///< A contour was drawn before at the same place; it is cut once. No error.
  kCrossing,   ///< A contour crosses itself or another contour, and the crossing is not resolved.
  kNoArcs,     ///< No arcs follow the contour within the tolerance; it is left out.
  kUnchecked,  ///< The drawing is too large to search all of it for crossings.
  kIgnored,    ///< An entity has nothing that could be cut; left out. No error.
  /// Contours that cross are replaced by the outlines of the area that they fill. No error.
  kMended,
  kNote,  ///< An entity is read in a way that the user should know; nothing is left out. No error.
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
  /// For kOpen: no other end is near, so an open line may be intended.
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
  /// The contour is an outline of the area that crossing contours fill: see fill().
  bool is_filled = false;
  /// The contour is open, but a closed one may be intended: one of its ends is near one other end,
  /// or more than two ends meet there.
  bool is_doubtful = false;
  double length_mm = 0.0;
  double area_mm2 = 0.0;  ///< Area of a closed contour; its holes are not subtracted.
  std::size_t depth = 0;  ///< Number of closed contours of the same part around this contour.
  std::optional<std::size_t> parent;  ///< The innermost of the contours that `depth` counts.
  /// The earlier contour of another layer that runs along the same path.
  std::optional<std::size_t> lies_on;
  /// The innermost contour of any part around this one. If this contour is open, the one around
  /// most of it.
  std::optional<std::size_t> lies_in;
  /// For an open contour: the innermost contours around its points, in ascending order of their
  /// numbers.
  std::vector<std::size_t> runs_through;

  /// Returns whether the contour is a hole: its depth is odd. Outer contours turn left, holes turn
  /// right.
  [[nodiscard]] bool is_hole() const { return depth % 2 == 1; }
};

/// A picture of a drawing.
struct DrawnPicture {
  std::shared_ptr<const picture::GreyImage> image{};  ///< The pixels; never null.
  /// Maps points of the picture, in pixels from its upper left corner with y down, to mm.
  Transform to_mm{};
  Entity entity{};
  /// Path of the picture's file, relative to the drawing; empty if the drawing itself contains the
  /// picture.
  std::string file{};
};

/// The stock that a sheet file describes; its corner is the origin.
struct Stock {
  double width_mm = 0.0;
  double height_mm = 0.0;
  double margin_mm = 0.0;       ///< Width of the margin along all edges; no part may lie in it.
  bool keeps_skeleton = false;  ///< The rest of the stock stays in one piece.
};

/// The order in which the parts of a sheet file are cut.
struct PartTurns {
  /// Turn of each part, by Entity::part. Parts with lower turns are cut first. Empty: any order.
  std::vector<std::size_t> of_part{};
  /// True: the parts are cut in the order of the file. False: each part names the parts after which
  /// it is cut.
  bool is_order_of_file = false;
};

/// The content of a drawing file: everything that is sound, and a list of faults.
struct Drawing {
  std::string file;
  std::optional<Stock> stock{};  ///< The stock, if the file is a sheet file.
  /// Names of the parts, by Entity::part; empty unless the file is a sheet file.
  std::vector<std::string> parts{};
  PartTurns turns{};
  std::vector<Layer> layers;
  std::vector<DrawnContour> contours;
  std::vector<DrawnPicture> pictures{};
  std::vector<Fault> faults;    ///< The first faults in the order found, at most kMaxFaults.
  std::size_t more_faults = 0;  ///< Number of faults that were found but are not listed.
  std::size_t more_lines = 0;  ///< Number of open contours (Fault::is_of_line) that are not listed.

  [[nodiscard]] bool has_errors() const;
};

/// Greatest size of a file. Greater files are refused as a whole.
inline constexpr std::size_t kMaxBytes = std::size_t{256} << 20;
inline constexpr std::size_t kMaxShapes = 2'000'000;
inline constexpr std::size_t kMaxFaults = 1'000;
/// Greatest depth of nested groups, blocks and instances.
inline constexpr std::size_t kDeepestNesting = 64;
/// Greatest distance of a point from the origin. No machine reaches that far, so a greater distance
/// is probably a wrong unit.
inline constexpr double kFarthestMm = 1.0e7;

/// The treatments of letters.
enum class TextMode : std::uint8_t {
  kSkip,  ///< Letters are left out, and a note reports it.
  /// Letters become outlines of the font that the drawing names, or of the most similar font.
  kOutline,
  kStroke,  ///< Letters become single strokes, as an engraver draws them.
};

/// Returns the bytes of a file by its path, relative to the drawing. Throws std::exception if the
/// file cannot be read.
using ReadBeside = std::function<std::string(const std::string& name)>;

struct ImportOptions {
  double gap_mm = 0.01;  ///< Greatest distance of two ends that count as one point. 0 or more.
  /// Uses a wider gap if that closes most open ends; see wider_gap().
  bool finds_gap = false;
  /// Adds lines that join two ends up to kWidestCertainGapMm apart if no other end is near them,
  /// and lines that close a contour whose ends are close together. Notes report these lines.
  bool mends_gaps = false;
  /// Millimetres per unit of the drawing (a unit of DXF, a pixel of SVG). It replaces the unit that
  /// the file gives or its format implies. From kMinUnitMm to kGreatestUnitMm.
  std::optional<double> unit_mm{};
  /// Share of the full bounds on work that reading may use, above 0 and at most 1. The bounds apply
  /// to the copies drawn, to the conversion of curves and to comparisons. The full bounds may take
  /// twenty seconds.
  double effort = 1.0;
  TextMode text = TextMode::kSkip;
  /// Reports contours that cross each other or run along each other as an error, instead of
  /// replacing them by the outlines of the area that they fill. Set for tools that clear areas:
  /// they could clear an area that is meant to stay.
  bool refuses_crossings = false;
  /// Reads picture files that a drawing links. If it is empty, linked pictures are not read.
  ReadBeside read_beside{};
};

inline constexpr double kMinGapMm = 0.0;
inline constexpr double kGreatestGapMm = 10.0;
inline constexpr double kMinUnitMm = 1.0e-6;
inline constexpr double kGreatestUnitMm = 1.0e6;

/// Reads a drawing. Detects the format by content: SVG or SVGZ, DXF, PDF, a LightBurn project, or
/// the JSON of nesting and cutting jobs. Never throws because of the content of a file. The limits
/// above bound its work. Decodes the pictures of SVG and of LightBurn projects. Reads picture files
/// below the folder of the drawing by `read_beside`.
/// @pre gap, unit and effort are within their limits
[[nodiscard]] Drawing read_drawing(const std::string& file,
                                   const std::string& text,
                                   const ImportOptions& options = {});

}  // namespace sim::drawing
