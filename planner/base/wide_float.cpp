#include "planner/base/wide_float.hpp"

#include "planner/base/truncate.hpp"

namespace cnc {
namespace {

/// Returns a + b without error. @pre |a| ≥ |b|
Wide ordered_sum(float a, float b) {
  const float sum = a + b;
  return {sum, b - (sum - a)};
}

/// Returns a + b without error.
Wide exact_sum(float a, float b) {
  const float sum = a + b;
  const float part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

struct Halves {
  float high;
  float low;
};

/// Splits a float into two parts of at most 12 bits each, so that products of parts are exact.
Halves split(float a) {
  constexpr float kSplitter = 4097.0F;  // 2^12 + 1
  const float scaled = kSplitter * a;
  const float high = scaled - (scaled - a);
  return {high, a - high};
}

/// Returns a · b without error.
Wide exact_product(float a, float b) {
  const float product = a * b;
  const Halves p = split(a);
  const Halves q = split(b);
  const float rest = ((p.high * q.high - product) + p.high * q.low + p.low * q.high);
  return {product, rest + p.low * q.low};
}

}  // namespace

Wide to_wide(std::int64_t whole) {
  const auto high = static_cast<float>(whole);
  return {high, static_cast<float>(whole - truncated(high))};
}

std::int64_t nearest_whole(const Wide& value) {
  const std::int64_t whole = truncated(value.high);
  const float rest = (value.high - static_cast<float>(whole)) + value.low;
  return whole + truncated(rest + (rest < 0.0F ? -0.5F : 0.5F));
}

Wide operator+(const Wide& a, const Wide& b) {
  const Wide high = exact_sum(a.high, b.high);
  const Wide low = exact_sum(a.low, b.low);
  const Wide sum = ordered_sum(high.high, high.low + low.high);
  return ordered_sum(sum.high, sum.low + low.low);
}

Wide operator-(const Wide& a, const Wide& b) { return a + Wide{-b.high, -b.low}; }

Wide operator*(const Wide& a, const Wide& b) {
  const Wide product = exact_product(a.high, b.high);
  return ordered_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

Wide operator/(const Wide& a, const Wide& b) {
  const float quotient = a.high / b.high;
  const Wide rest = a - Wide{quotient} * b;
  return ordered_sum(quotient, rest.high / b.high);
}

}  // namespace cnc
