#include "host-sim/measure/programmed_path.hpp"

#include <algorithm>
#include <istream>
#include <iterator>
#include <limits>

#include "host-sim/measure/program_reader.hpp"

namespace sim {

double PathPiece::path_feed() const {
  if (travel == Travel::kRapid) return std::numeric_limits<double>::infinity();
  const double linear = curve.linear_length();
  return linear > 0.0 ? feed * curve.length() / linear : feed;
}

double ProgrammedPath::length() const {
  double sum = 0.0;
  for (const PathPiece& piece : pieces) sum += piece.curve.length();
  return sum;
}

Bounds ProgrammedPath::bounds() const {
  Bounds all{start, start};
  for (const PathPiece& piece : pieces) {
    const Bounds one = piece.curve.bounds();
    for (std::size_t i = 0; i < all.low.size(); ++i) {
      all.low[i] = std::min(all.low[i], one.low[i]);
      all.high[i] = std::max(all.high[i], one.high[i]);
    }
  }
  return all;
}

ProgrammedPath read_program(std::string_view text, const ReadOptions& options) {
  ProgramReader reader{options};
  reader.read(text);
  return reader.path();
}

ProgrammedPath read_program(std::istream& text, const ReadOptions& options) {
  const std::string whole{std::istreambuf_iterator<char>{text}, {}};
  return read_program(whole, options);
}

}  // namespace sim
