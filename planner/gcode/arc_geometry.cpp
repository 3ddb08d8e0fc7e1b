#include "planner/gcode/arc_geometry.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "planner/base/coordinate.hpp"
#include "planner/base/scalar_math.hpp"
#include "planner/base/truncate.hpp"

namespace cnc::gcode {

namespace {

std::uint64_t magnitude(std::int64_t value) {
  return static_cast<std::uint64_t>(value < 0 ? -value : value);
}

/// Returns the number of bits by which values must be shifted right, so that each value is below
/// 2^31. Then the sum of two products of such values fits into 63 bits. The result is 0 for values
/// below 2.1 m, and at most 12 for coordinates in range.
template <typename... Values>
int surplus_bits(Values... values) {
  const std::uint64_t all = (magnitude(values) | ...);
  return std::max(0, static_cast<int>(std::bit_width(all)) - 31);
}

PlaneVector shifted(PlaneVector v, int bits) { return {v.first >> bits, v.second >> bits}; }

/// Returns a · b. @pre both arguments have at most 31 bits and the sign
std::int64_t product(std::int64_t a, std::int64_t b) {
  return std::int64_t{static_cast<std::int32_t>(a)} * static_cast<std::int32_t>(b);
}

std::int64_t dot(PlaneVector a, PlaneVector b) {
  return product(a.first, b.first) + product(a.second, b.second);
}

/// Returns the length in mm that corresponds to 1 after a shift by `bits`.
float unit_mm(int bits) {
  return static_cast<float>(std::uint32_t{1} << bits) * kMillimetresPerNanometre;
}

std::int64_t scaled(std::int64_t value, float factor) {
  return truncated(static_cast<float>(value) * factor);
}

}  // namespace

float PlaneVector::length() const {
  const float x = static_cast<float>(first) * kMillimetresPerNanometre;
  const float y = static_cast<float>(second) * kMillimetresPerNanometre;
  return std::sqrt(x * x + y * y);
}

float allowed_deviation(const ArcTolerance& tolerance, float radius_mm) {
  constexpr float kMax = 0.5F;
  const float ours = std::max(tolerance.absolute_mm, tolerance.relative * radius_mm);
  const float grbls = std::max(0.005F, std::min(kMax, 0.001F * radius_mm));
  return std::max(std::min(ours, kMax), grbls);
}

float radius_deviation(PlaneVector end, PlaneVector centre) {
  const PlaneVector other = end - PlaneVector{2 * centre.first, 2 * centre.second};
  const int bits = surplus_bits(end.first, end.second, other.first, other.second);
  const auto product = static_cast<float>(dot(shifted(end, bits), shifted(other, bits)));
  const float difference_of_squares = std::abs(product) * unit_mm(bits) * unit_mm(bits);
  return difference_of_squares / (centre.length() + (end - centre).length());
}

CentreByRadius centre_by_radius(PlaneVector end, std::int64_t radius_nm, bool clockwise) {
  const std::int64_t diameter_nm = 2 * static_cast<std::int64_t>(magnitude(radius_nm));
  const int bits = surplus_bits(end.first, end.second, diameter_nm);
  const PlaneVector chord = shifted(end, bits);
  const std::int64_t diameter = diameter_nm >> bits;
  // (2h)², where h is the distance of the centre from the middle of the chord.
  const std::int64_t square = product(diameter, diameter) - dot(chord, chord);
  if (square < 0) {
    const float diameter_mm = static_cast<float>(diameter_nm) * kMillimetresPerNanometre;
    const float excess = static_cast<float>(-square) * unit_mm(bits) * unit_mm(bits);
    return {{end.first / 2, end.second / 2}, excess / (end.length() + diameter_mm)};
  }
  // The chord may be much shorter than the diameter. So it has its own shift, which keeps all its
  // digits.
  const int chord_bits = surplus_bits(end.first, end.second);
  const PlaneVector exact = shifted(end, chord_bits);
  const float ratio = static_cast<float>(square) / static_cast<float>(dot(exact, exact));
  const float steepness =
      std::sqrt(ratio) * static_cast<float>(std::uint32_t{1} << (bits - chord_bits));
  const bool to_the_left = (radius_nm > 0) != clockwise;
  const float slope = to_the_left ? steepness : -steepness;
  return {
      {(end.first - scaled(end.second, slope)) / 2, (end.second + scaled(end.first, slope)) / 2},
      0.0F};
}

}  // namespace cnc::gcode
