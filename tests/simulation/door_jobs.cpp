#include "tests/simulation/door_jobs.hpp"

#include <cmath>

namespace proof {
namespace {

std::string to_place(double x, double y) {
  return " X" + std::to_string(x) + " Y" + std::to_string(y);
}

/// Returns a job of rounded corners, exact stops and lines of different lengths.
DoorJob job_of_corners() {
  DoorJob job{"corners", {"G64 P0.05"}};
  double x = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double step = 0.4 + 1.7 * (i % 4);
    job.lines.push_back("G1" + to_place(x, i % 2 == 0 ? 9.0 : 0.0));
    x += step;
    job.lines.push_back("G1" + to_place(x, i % 2 == 0 ? 9.0 : 0.0));
  }
  job.lines.emplace_back("G61");
  job.lines.push_back("G1" + to_place(x + 30.0, -2.0));
  job.lines.push_back("G1" + to_place(x + 31.0, 8.0));
  job.lines.push_back("G0" + to_place(x + 33.0, 8.0));
  job.lines.push_back("G1" + to_place(x + 33.0, -12.0));
  return job;
}

/// Returns a job of arcs, a helix and a spline.
DoorJob job_of_arcs() {
  return {"arcs",
          {"G2 X20 Y0 I10 J0",
           "G3 X36 Y0 I8 J0 Z1",
           "G1 X36 Y10",
           "G3 X30 Y16 I-6 J0",
           "G5 X10 Y30 I-12 J0 P12 Q0",
           "G2 X20 Y40 I10 J0",
           "G2 X20 Y40 I6 J0"}};
}

/// Returns a job of chords, some of which are welded.
DoorJob job_of_chords() {
  DoorJob job{"chords", {"G64 P0.05 Q0.02"}};
  for (int i = 1; i <= 120; ++i) {
    const double angle = 0.025 * i;
    job.lines.push_back("G1" + to_place(12.0 * (1.0 - std::cos(angle)), 9.0 * std::sin(angle)));
  }
  job.lines.emplace_back("G64 P0.005 Q0");
  for (int i = 1; i <= 120; ++i) {
    job.lines.push_back("G1" + to_place(24.0 + 0.15 * i, 0.6 + 1.5 * std::sin(0.05 * i)));
  }
  return job;
}

/// Returns a job of rows of pixels in both directions, some of them with the beam off.
DoorJob job_of_pixels() {
  DoorJob job{"pixels", {}};
  constexpr int kPixels = 140;
  for (int row = 0; row < 3; ++row) {
    const bool there = row % 2 == 0;
    for (int i = 1; i <= kPixels; ++i) {
      const int power = i < 12 || i > kPixels - 12 ? 0 : 200 + (i * 37 + row * 11) % 700;
      const double x = 0.1 * (there ? i : kPixels - i);
      job.lines.push_back("G1" + to_place(x, row) + " S" + std::to_string(i % 9 == 0 ? 0 : power));
    }
    job.lines.push_back("G1" + to_place(there ? 0.1 * kPixels : 0.0, row + 1.0) + " S0");
  }
  return job;
}

/// Returns a job that is offset from a contour of lines and arcs.
DoorJob job_of_offset() {
  return {"offset",
          {"G0 X20 Y6",
           "G41.1 D0.4 G1 X20 Y0",
           "G1 X30 Y0",
           "G3 X36 Y6 I0 J6",
           "G1 X36 Y20",
           "G1 X28 Y20",
           "G2 X22 Y26 I0 J6",
           "G1 X22 Y32",
           "G1 X10 Y32",
           "G1 X10 Y0",
           "G1 X20 Y0",
           "G40 G1 X20 Y5"}};
}

}  // namespace

std::vector<DoorJob> door_jobs() {
  return {job_of_corners(), job_of_arcs(), job_of_chords(), job_of_pixels(), job_of_offset()};
}

}  // namespace proof
