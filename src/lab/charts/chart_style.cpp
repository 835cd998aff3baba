// SPDX-License-Identifier: MIT
#include "lab/charts/chart_style.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

namespace ballpit {

namespace {

constexpr Rgb kBlack = 0x000000, kWhite = 0xFFFFFF, kBlue = 0x0072B2, kGreen = 0x009E73, kVermillion = 0xD55E00,
              kOrange = 0xE69F00, kPurple = 0xCC79A7, kSky = 0x56B4E9, kGrey = 0x7A7A7A, kLightGrey = 0x9AA0A6;

constexpr std::array kRoles{
    RoleStyle{"brute-force", kBlack, kWhite, 6, 7, "○"},
    RoleStyle{"sort-and-sweep", kBlue, kBlue, 8, 9, "△"},
    RoleStyle{"linked-cell", kGreen, kGreen, 4, 5, "□"},
    RoleStyle{"sorted-grid", kVermillion, kVermillion, 12, 13, "◇"},
    RoleStyle{"auto", kPurple, kPurple, 10, 11, "▽"},
    RoleStyle{"kinematic", kSky, kSky, 6, 7, "○"},
    RoleStyle{"impulse", kOrange, kOrange, 12, 13, "◇"},
    RoleStyle{"penalty", kGreen, kGreen, 4, 5, "□"},
    RoleStyle{"position-based", kBlack, kWhite, 14, 15, "⬠"},
    RoleStyle{"event-driven", kBlue, kBlue, 8, 9, "△"},
    RoleStyle{"theory", kGrey, kLightGrey, 0, 0, "┄"},
    RoleStyle{"failed", kVermillion, kVermillion, 2, 2, "×"},
    RoleStyle{"front", kPurple, kPurple, 14, 15, "⬠"},
    RoleStyle{"first", kBlue, kBlue, 8, 9, "△"},
    RoleStyle{"second", kOrange, kOrange, 12, 13, "◇"},
    RoleStyle{"third", kGreen, kGreen, 4, 5, "□"},
    RoleStyle{"fourth", kPurple, kPurple, 10, 11, "▽"},
    RoleStyle{"fifth", kSky, kSky, 6, 7, "○"},
    RoleStyle{"sixth", kBlack, kWhite, 14, 15, "⬠"},
    RoleStyle{"seventh", kVermillion, kVermillion, 7, 7, "●"},
};

constexpr GroundStyle kLight{0xFFFFFF, 0x1A1A1A, 0xDDE1E6, kGrey};
constexpr GroundStyle kDark{0x14171C, 0xE8EAED, 0x343A43, kLightGrey};

double channel(Rgb color, int shift) { return (color >> shift & 255u) / 255.0; }

/// Relative luminance, WCAG 2.1.
double luminance(Rgb color) {
  const auto linear = [&](int shift) {
    const double c = channel(color, shift);
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(16) + 0.7152 * linear(8) + 0.0722 * linear(0);
}

double contrast(Rgb a, Rgb b) {
  const double high = std::max(luminance(a), luminance(b)), low = std::min(luminance(a), luminance(b));
  return (high + 0.05) / (low + 0.05);
}

Rgb mix(Rgb from, Rgb to, double share) {
  Rgb result = 0;
  for (const int shift : {16, 8, 0}) {
    const double value = 255 * std::lerp(channel(from, shift), channel(to, shift), share);
    result |= static_cast<Rgb>(std::lround(value)) << shift;
  }
  return result;
}

}  // namespace

const RoleStyle& style_of(std::string_view role) {
  for (const RoleStyle& style : kRoles) {
    if (style.role == role) return style;
  }
  throw std::logic_error(fmt::format("no role '{}' for a chart", role));
}

const GroundStyle& ground_style(Ground ground) { return ground == Ground::light ? kLight : kDark; }

Rgb color_of(std::string_view role, Ground ground) {
  const RoleStyle& style = style_of(role);
  return ground == Ground::light ? style.light : style.dark;
}

Rgb text_color_of(std::string_view role, Ground ground) {
  const Rgb color = color_of(role, ground);
  const GroundStyle& style = ground_style(ground);
  double share = 0;
  while (share < 1 && contrast(mix(color, style.text, share), style.background) < 4) share += 0.05;
  return mix(color, style.text, share);
}

Rgb gradient(double share) {
  constexpr std::array<Rgb, 6> kStops{0x440154, 0x414487, 0x2A788E, 0x22A884, 0x7AD151, 0xFDE725};
  const double place = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const size_t below = std::min(static_cast<size_t>(place), kStops.size() - 2);
  return mix(kStops[below], kStops[below + 1], place - static_cast<double>(below));
}

std::string hex(Rgb color) { return fmt::format("#{:06X}", color); }

}  // namespace ballpit
