#pragma once

#include <map>
#include <memory>
#include <vector>

#include "planner/motion/block/block_builder.hpp"
#include "planner/motion/segment/pixel_course.hpp"
#include "tests/planner/path/path_test.hpp"

namespace cnc::path {

/// A program in which lines have powers.
class PowerPen : public Pen {
 public:
  using Pen::Pen;
  void pixel(const Place& travel, double power) {
    request().beam.duty = static_cast<float>(power);
    line(travel);
  }
};

/// The path stage with pixels, and a machine that drives its pieces as soon as they come.
class RowDrive {
 public:
  struct Driven {
    PathPiece piece{};
    std::vector<double> powers{};  ///< Powers at points that are evenly distributed over the piece.
  };
  static constexpr int kPlaces = 40;

  /// Powers of the lines that are separate rows, by the number of the line.
  using Rows = std::map<std::size_t, std::vector<float>>;

  void run(const std::vector<PathItem>& items, const Rows& rows = {}) {
    for (std::size_t item = 0; item < items.size(); ++item) {
      const auto row = rows.find(item);
      for (int i = 0; i < 100 && !stage_->has_room(); ++i) take();
      ASSERT_TRUE(stage_->has_room());
      if (row == rows.end()) {
        stage_->put(items[item]);
      } else {
        for (int i = 0; i < 100 && !stage_->takes_row(row->second.size()); ++i) take();
        ASSERT_TRUE(stage_->takes_row(row->second.size()));
        stage_->put_row(items[item], {.values = row->second});
      }
      take();
    }
    for (int i = 0; i < 100 && !stage_->empty(); ++i) {
      stage_->flush();
      take();
    }
    EXPECT_TRUE(stage_->empty());
    EXPECT_TRUE(all_driven());
  }

  PathStage& stage() { return *stage_; }
  std::vector<Driven> driven{};

  [[nodiscard]] std::vector<PathPiece> pieces() const {
    std::vector<PathPiece> all;
    for (const Driven& one : driven) all.push_back(one.piece);
    return all;
  }

 private:
  /// Returns whether no pixel is left, or only the last one of the last row. The parts of a row add
  /// up to its length within rounding, and the next row drops a pixel that ends behind them.
  [[nodiscard]] bool all_driven() const {
    constexpr float kRoundingMm = 1.0e-5F;
    if (pixels_->empty()) return true;
    const motion::RowPart& row = driven.back().piece.request.row;
    return pixels_->room() + 1 == motion::Pixels::kMax && row.any() &&
           pixels_->front().end_mm <= row.to_mm + kRoundingMm;
  }

  void take() {
    while (const PathPiece* const piece = stage_->next()) drive(*piece);
  }

  void drive(const PathPiece& piece) {
    const auto block = motion::build_block(piece.request, limits_);
    ASSERT_TRUE(block.ok());
    const motion::PathUnits length = motion::length_in_units(block.value());
    course_.begin(block.value(), length);
    Driven one{.piece = piece};
    for (int i = 0; i < kPlaces; ++i) {
      const auto place =
          static_cast<motion::PathUnits>((i + 0.5) / kPlaces * static_cast<double>(length));
      while (course_.next_change() <= place) course_.pass(course_.next_change());
      one.powers.push_back(static_cast<double>(course_.duty()));
    }
    while (course_.next_change() < length) course_.pass(course_.next_change());
    course_.pass(length);
    driven.push_back(one);
  }

  motion::Limits limits_ = path_limits();
  std::unique_ptr<motion::Pixels> pixels_ = std::make_unique<motion::Pixels>();
  std::unique_ptr<PathStage> stage_ = std::make_unique<PathStage>(limits_, pixels_.get());
  motion::PixelCourse course_{pixels_.get()};
};

}  // namespace cnc::path
