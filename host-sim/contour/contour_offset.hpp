#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "host-sim/contour/owned_offset_space.hpp"
#include "host-sim/import/place.hpp"
#include "planner/contour/offset.hpp"

namespace sim {

using ContourVertex = cnc::contour::Vertex<double>;

/// Closed loops of lines and arcs, in mm, which own their vertices. view() gives them as a
/// cnc::contour::ContourView.
struct Contour {
  std::vector<ContourVertex> vertices;
  std::vector<std::uint32_t> loop_ends;

  [[nodiscard]] cnc::contour::ContourView<double> view() const {
    return {{vertices.data(), vertices.size()}, {loop_ends.data(), loop_ends.size()}};
  }
  void end_loop() { loop_ends.push_back(static_cast<std::uint32_t>(vertices.size())); }
};

[[nodiscard]] Contour copy_of(const cnc::contour::ContourView<double>& view);

/// Exception for a contour that has no offset: the remaining elements do not lead back to their
/// start, or the elements are so close together that their offsets cross each other too often.
class NoOffset : public std::runtime_error {
 public:
  /// Creates the exception with the message `at X Y: reason; remedy`.
  NoOffset(const drawing::Place& place, std::string reason, std::string remedy);

  [[nodiscard]] const drawing::Place& place() const { return place_; }
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] const std::string& remedy() const { return remedy_; }

 private:
  drawing::Place place_;
  std::string reason_;
  std::string remedy_;
};

/// Computes offsets with the code of the planner. Its storage grows as needed, and is reused for
/// the next contour.
class ContourOffset {
 public:
  /// Greatest number of points where elements of the offset cross or touch. This number requires
  /// 1.4 GB of storage.
  static constexpr std::size_t kMaxMeetings = 8'000'000;

  explicit ContourOffset(std::size_t max_meetings = kMaxMeetings) : max_meetings_{max_meetings} {}

  /// Returns the offset of loops by a distance. Loops that touch or cross may have an offset that
  /// does not close or that loses material. In this case, the function returns the offset of the
  /// outlines of their material. The view is valid until the next call. Throws
  /// std::invalid_argument for numbers that are not finite, and NoOffset if there is no offset.
  cnc::contour::ContourView<double> offset(const cnc::contour::ContourView<double>& input,
                                           double distance_mm);

 private:
  cnc::contour::ContourView<double> offset_once_filled(
      const cnc::contour::ContourView<double>& input, double distance_mm, bool is_filled);
  void grow(std::size_t elements, std::size_t cuts);

  std::size_t max_meetings_;
  OwnedOffsetSpace space_;
  Contour filled_;
  std::vector<ContourVertex> result_;
  std::vector<std::uint32_t> result_ends_;
};

}  // namespace sim
