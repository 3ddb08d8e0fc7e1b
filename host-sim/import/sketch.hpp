#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::text {
class Lettering;
}

namespace sim::drawing {

/// Shapes that a file itself draws in one go, each from where the one before ends.
struct Chain {
  std::vector<Shape> shapes;
  std::size_t entity;  ///< Index into Sketch::entities.
};

/// At least the length of a shape, and 0 only where that is.
[[nodiscard]] double length_of_hull(const Shape& shape);

/// Returns the beginning of a text as one line, without cutting a letter of UTF-8 in two.
[[nodiscard]] std::string first_words(std::string_view words);

/// What a reader gathers of a file, before chains are joined to contours.
class Sketch {
 public:
  /// @pre effort in (0, 1], as ImportOptions has it
  explicit Sketch(double effort, TextMode text = TextMode::kSkip) : effort_{effort}, text_{text} {}

  [[nodiscard]] std::size_t layer(const Layer& layer);
  [[nodiscard]] std::size_t add_entity(Entity entity);

  /// Keeps the chain without its shapes of length zero; a chain of such only, or
  /// one that leaves the plane, becomes a fault. False when there are too many.
  bool add(Chain chain);

  /// Keeps a picture, and notes where the layer of the first one is.
  /// @pre its image is there, its map is finite and has an area
  void add(DrawnPicture picture);
  /// Reports a picture that cannot be read.
  void report_bad_picture(const Entity& entity, std::string reason, std::string remedy);
  /// Returns a picture of a file's bytes; null, and a report, where they are none, or where the
  /// pictures of the drawing would have more pixels than one may have.
  [[nodiscard]] std::shared_ptr<const picture::GreyImage> decode(std::string_view bytes,
                                                                 const Entity& entity);
  /// Reads files beside the drawing; empty where none are read.
  void set_read_beside(ReadBeside read) { read_beside_ = std::move(read); }
  [[nodiscard]] const ReadBeside& read_beside() const { return read_beside_; }

  /// Beyond kMostFaults only counted.
  void report(Fault fault);
  /// A fault of the whole file.
  void refuse(std::size_t line, std::size_t column, std::string reason, std::string remedy);
  /// Things to ignore are told once for each kind, with their number.
  void ignore(const std::string& what, const Entity& first, std::string remedy = {}) {
    note({FaultKind::kIgnored, first, {}, what, std::move(remedy)});
  }
  /// Counts one more note of the kind and reason of `first`, which gives place and remedy.
  /// @param detail of the first one, behind the reason
  /// @pre first is no error
  void note(const Fault& first, std::string detail = {});
  /// Notes letters that are left out, with their number in a layer, and place and words of the
  /// first of them.
  void leave_out_text(const Entity& entity,
                      std::string_view words,
                      std::string remedy = "--text outline or --text stroke draws them");
  /// Keeps a note as `ignore()` does, of something that is drawn.
  void note(const std::string& what, const Entity& first, std::string remedy = {});
  /// Makes everything larger by a factor, what is reported included. @pre factor > 0
  void scale(double factor);
  /// Forgets lines and columns: they are not those of the file.
  void forget_lines();
  /// Returns whether an entity is letters of single strokes, which fill nothing.
  [[nodiscard]] bool is_of_strokes(const Entity& entity) const;
  /// Lets contours of several layers fill shapes together.
  /// @param groups by layer: those of one number are one; empty: each layer is by itself
  void group_layers(std::vector<std::size_t> groups) { groups_ = std::move(groups); }
  /// Returns whether contours of two entities fill one shape where they overlap.
  [[nodiscard]] bool fill_together(const Entity& a, const Entity& b) const {
    const bool are_grouped =
        groups_.empty() ? a.layer == b.layer : groups_[a.layer] == groups_[b.layer];
    return are_grouped && a.part == b.part;
  }
  /// Turns what was ignored and noted into faults. Call once, at the end.
  void finish();

  /// The share that this drawing may have of a bound on work; 1 or more.
  [[nodiscard]] std::size_t share_of(std::size_t work) const {
    return std::max<std::size_t>(1, static_cast<std::size_t>(effort_ * static_cast<double>(work)));
  }

  [[nodiscard]] TextMode text() const { return text_; }
  /// Returns what draws letters; made when it is wanted first. @pre text() is not kSkip
  [[nodiscard]] text::Lettering& lettering();
  [[nodiscard]] bool full() const { return full_; }
  [[nodiscard]] const Entity& entity(std::size_t index) const { return entities_[index]; }
  [[nodiscard]] std::vector<Chain>& chains() { return chains_; }
  [[nodiscard]] std::vector<Fault>& faults() { return faults_; }
  [[nodiscard]] std::vector<Layer>& layers() { return layers_; }
  [[nodiscard]] std::vector<DrawnPicture>& pictures() { return pictures_; }
  [[nodiscard]] std::size_t more_faults() const { return more_faults_; }
  /// Open lines that are not listed, so that errors are.
  [[nodiscard]] std::size_t more_lines() const {
    return lines_ - std::min(lines_, kMostLinesListed);
  }

 private:
  static constexpr std::size_t kMostLinesListed = 200;

  struct Note {
    Fault first;
    std::string detail;
    std::size_t count = 0;
  };

  /// Returns whether a fault says that strokes of letters are open, or cross and meet each other,
  /// as they do.
  [[nodiscard]] bool is_of_strokes(const Fault& fault) const;

  double effort_;
  TextMode text_;
  std::shared_ptr<text::Lettering> lettering_;
  std::vector<Layer> layers_;
  std::map<Layer, std::size_t> layer_index_;
  std::vector<std::size_t> groups_;  ///< See group_layers().
  std::vector<Entity> entities_;
  std::vector<Chain> chains_;
  std::vector<DrawnPicture> pictures_;
  ReadBeside read_beside_;
  std::size_t picture_pixels_ = 0;
  std::vector<Fault> faults_;
  /// By kind, reason and, of letters and pictures, layer.
  std::map<std::tuple<FaultKind, std::string, std::size_t>, Note> notes_;
  std::size_t more_faults_ = 0;
  std::size_t lines_ = 0;  ///< Faults of open contours that may be meant as lines.
  std::size_t shapes_ = 0;
  bool full_ = false;
};

}  // namespace sim::drawing
