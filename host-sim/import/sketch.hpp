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

/// A row of shapes that are connected in the file: each begins where the shape before it ends.
struct Chain {
  std::vector<Shape> shapes;
  std::size_t entity;  ///< Index into Sketch::entities.
};

/// Returns an upper bound of the length of a shape, mm. The bound is 0 only if the length is 0.
[[nodiscard]] double length_of_hull(const Shape& shape);

/// Returns the beginning of a text as one line, for messages. A UTF-8 character is never cut in
/// two.
[[nodiscard]] std::string first_words(std::string_view words);

/// The shapes, pictures, faults and notes that a reader gathers from a file, before chains are
/// joined to contours.
class Sketch {
 public:
  /// @pre effort in (0, 1], see ImportOptions::effort
  explicit Sketch(double effort, TextMode text = TextMode::kSkip) : effort_{effort}, text_{text} {}

  [[nodiscard]] std::size_t layer(const Layer& layer);
  [[nodiscard]] std::size_t add_entity(Entity entity);

  /// Adds a chain. Its shapes without length are left out. A chain that has only shapes without
  /// length, or that has points beyond kFarthestMm, becomes a fault. Returns false if the sketch
  /// has too many shapes.
  bool add(Chain chain);

  /// Adds a picture, and a note about the first picture of each layer.
  /// @pre DrawnPicture::image is not null, and the determinant of DrawnPicture::to_mm is finite and
  /// not 0
  void add(DrawnPicture picture);
  /// Reports a picture that cannot be read.
  void report_bad_picture(const Entity& entity, std::string reason, std::string remedy);
  /// Decodes a picture from the bytes of its file. Returns null, and reports the reason, if the
  /// bytes are no picture, or if all pictures of the drawing together would have more pixels than a
  /// single picture may have.
  [[nodiscard]] std::shared_ptr<const picture::GreyImage> decode(std::string_view bytes,
                                                                 const Entity& entity);
  /// Sets the function that reads files below the folder of the drawing. If it is empty, no files
  /// are read.
  void set_read_beside(ReadBeside read) { read_beside_ = std::move(read); }
  [[nodiscard]] const ReadBeside& read_beside() const { return read_beside_; }

  /// Adds a fault. Faults after the first kMaxFaults are only counted.
  void report(Fault fault);
  /// Reports that the file is refused as a whole.
  void refuse(std::size_t line, std::size_t column, std::string reason, std::string remedy);
  /// Adds a note about an entity that is ignored. Entities with the same text `what` share one
  /// note, which gives their number.
  void ignore(const std::string& what, const Entity& first, std::string remedy = {}) {
    note({FaultKind::kIgnored, first, {}, what, std::move(remedy)});
  }
  /// Adds a note. Notes with equal kind and reason become one note, which gives their number. The
  /// first of these notes gives the position and the remedy. @param detail text that follows the
  /// reason; the text of the first note is used
  /// @pre `first` is no error
  void note(const Fault& first, std::string detail = {});
  /// Adds a note about a text that is left out. The note gives the number of such texts in the
  /// layer, and the position and words of the first one.
  void leave_out_text(const Entity& entity,
                      std::string_view words,
                      std::string remedy = "--text outline or --text stroke draws them");
  /// Adds a note in the same way as ignore(), but about an entity that is drawn.
  void note(const std::string& what, const Entity& first, std::string remedy = {});
  /// Scales everything by a factor, including the positions in faults and notes.
  /// @pre factor > 0
  void scale(double factor);
  /// Removes lines and columns from all entities. For readers whose positions are not positions in
  /// the file of the user.
  void forget_lines();
  /// Returns whether an entity consists of letters of single strokes, which fill no area.
  [[nodiscard]] bool is_of_strokes(const Entity& entity) const;
  /// Sets the groups of layers whose contours fill areas together.
  /// @param groups group number of each layer: layers with equal numbers fill areas together; if
  /// empty, each layer fills areas alone
  void group_layers(std::vector<std::size_t> groups) { groups_ = std::move(groups); }
  /// Returns whether overlapping contours of two entities fill one area together.
  [[nodiscard]] bool fill_together(const Entity& a, const Entity& b) const {
    const bool are_grouped =
        groups_.empty() ? a.layer == b.layer : groups_[a.layer] == groups_[b.layer];
    return are_grouped && a.part == b.part;
  }
  /// Adds the counted notes to the faults. Must be called once, at the end.
  void finish();

  /// Returns the part of a bound on work that this drawing may use, at least 1. See
  /// ImportOptions::effort.
  [[nodiscard]] std::size_t share_of(std::size_t work) const {
    return std::max<std::size_t>(1, static_cast<std::size_t>(effort_ * static_cast<double>(work)));
  }

  [[nodiscard]] TextMode text() const { return text_; }
  /// Returns the object that draws letters. It is created by the first call.
  /// @pre text() is not kSkip
  [[nodiscard]] text::Lettering& lettering();
  [[nodiscard]] bool full() const { return full_; }
  [[nodiscard]] const Entity& entity(std::size_t index) const { return entities_[index]; }
  [[nodiscard]] std::vector<Chain>& chains() { return chains_; }
  [[nodiscard]] std::vector<Fault>& faults() { return faults_; }
  [[nodiscard]] std::vector<Layer>& layers() { return layers_; }
  [[nodiscard]] std::vector<DrawnPicture>& pictures() { return pictures_; }
  [[nodiscard]] std::size_t more_faults() const { return more_faults_; }
  /// Returns the number of faults about open lines that are not listed. Only kMaxLinesListed of
  /// them are listed, so that the list has space for errors.
  [[nodiscard]] std::size_t more_lines() const {
    return lines_ - std::min(lines_, kMaxLinesListed);
  }

 private:
  static constexpr std::size_t kMaxLinesListed = 200;

  struct Note {
    Fault first;
    std::string detail;
    std::size_t count = 0;
  };

  /// Returns whether a fault reports that strokes of letters are open, cross each other or meet.
  /// These properties are normal for strokes of letters, so the fault is not reported.
  [[nodiscard]] bool is_of_strokes(const Fault& fault) const;

  double effort_;
  TextMode text_;
  std::shared_ptr<text::Lettering> lettering_;
  std::vector<Layer> layers_;
  std::map<Layer, std::size_t> layer_index_;
  std::vector<std::size_t> groups_;  ///< Group number of each layer; see group_layers().
  std::vector<Entity> entities_;
  std::vector<Chain> chains_;
  std::vector<DrawnPicture> pictures_;
  ReadBeside read_beside_;
  std::size_t picture_pixels_ = 0;
  std::vector<Fault> faults_;
  /// Notes, keyed by kind, reason and layer. The layer is 0 except for letters and pictures.
  std::map<std::tuple<FaultKind, std::string, std::size_t>, Note> notes_;
  std::size_t more_faults_ = 0;
  std::size_t lines_ = 0;  ///< Number of faults about open contours that may be meant as lines.
  std::size_t shapes_ = 0;
  bool full_ = false;
};

}  // namespace sim::drawing
