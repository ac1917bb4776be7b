#include "results/picture_colour.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace cleave::results {
namespace {

constexpr std::array<std::uint32_t, 33> viridis = {
    0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453781, 0x424086, 0x3e4989, 0x3b528b,
    0x375b8d, 0x33638d, 0x2f6b8e, 0x2c728e, 0x297a8e, 0x26828e, 0x23898e, 0x21908c, 0x1f978b,
    0x1f9f88, 0x21a685, 0x27ad81, 0x31b57b, 0x3ebc74, 0x4dc26c, 0x5cc863, 0x6ece58, 0x82d34d,
    0x95d840, 0xaadc32, 0xc0df25, 0xd5e21a, 0xeae51a, 0xfde725};

constexpr Colour no_number{0.66f, 0.66f, 0.66f};

float channel(std::uint32_t colour, int shift) {
  return static_cast<float>((colour >> shift) & 255u) / 255.0f;
}

}  // namespace

std::span<const std::uint32_t> colour_table() {
  return viridis;
}

Colour colour_at(double t) {
  if (std::isnan(t)) return no_number;
  const double x = std::clamp(t, 0.0, 1.0) * static_cast<double>(viridis.size() - 1);
  const std::size_t below = std::min<std::size_t>(static_cast<std::size_t>(x), viridis.size() - 2);
  const float u = static_cast<float>(x - static_cast<double>(below));
  const auto mix = [&](int shift) {
    return (1.0f - u) * channel(viridis[below], shift) + u * channel(viridis[below + 1], shift);
  };
  return {mix(16), mix(8), mix(0)};
}

Range range_of(std::span<const float> values) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const float value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min<double>(low, value);
    high = std::max<double>(high, value);
  }
  if (low > high) return {};
  if (low == high) {
    const double margin = low == 0.0 ? 1.0 : std::abs(low) * 0.5;
    // A field that is zero everywhere starts at zero; one that is constant sits in the middle.
    return low == 0.0 ? Range{0.0, margin} : Range{low - margin, high + margin};
  }
  return {low, high};
}

std::vector<double> round_ticks(const Range& range, int wanted) {
  const double rough = (range.high - range.low) / std::max(wanted, 1);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
    if (factor * power >= rough * 0.999) {
      step = factor * power;
      break;
    }
  }
  std::vector<double> ticks;
  const double slack = 1e-9 * (range.high - range.low);
  for (double i = std::ceil((range.low - slack) / step); i * step <= range.high + slack; i += 1.0)
    ticks.push_back(i * step + 0.0);  // + 0.0 turns -0 into 0
  return ticks;
}

std::string number_text(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace cleave::results
