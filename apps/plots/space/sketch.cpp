// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/plots/space/sketch.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "apps/report/html.h"

namespace bracket::apps {

using scene::Vector;

namespace {

// Pixels.
constexpr double picture_width = 720, picture_height = 540, picture_margin = 16, bar_width = 16, bar_room = 112,
                 legend_line = 18, foot = 58;

/// The colours of all pictures, from dark to light.
constexpr std::array<std::array<int, 3>, 9> palette = {{{0x44, 0x01, 0x54},
                                                        {0x47, 0x2d, 0x7b},
                                                        {0x3b, 0x52, 0x8b},
                                                        {0x2c, 0x72, 0x8e},
                                                        {0x21, 0x91, 0x8c},
                                                        {0x28, 0xae, 0x80},
                                                        {0x5e, 0xc9, 0x62},
                                                        {0xad, 0xdc, 0x30},
                                                        {0xfd, 0xe7, 0x25}}};

std::string colour(double place, double shade) {
  if (std::isnan(place)) return "#bbbbbb";
  const double along = std::clamp(place, 0.0, 1.0) * (palette.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(along), palette.size() - 2);
  const double part = along - static_cast<double>(below);
  std::string text = "#";
  for (int k = 0; k < 3; ++k) {
    const double full = (1 - part) * palette[below][k] + part * palette[below + 1][k];
    text += fmt::format("{:02x}", static_cast<int>(std::lround(shade * full)));
  }
  return text;
}

/// Where a value is on the scale, 0 at its lowest, 1 at its highest.
double place_on(const ColourScale& scale, double value) {
  if (scale.highest <= scale.lowest) return 0;
  if (!scale.logarithmic) return (value - scale.lowest) / (scale.highest - scale.lowest);
  if (value <= 0) return 0;
  return std::log(value / scale.lowest) / std::log(scale.highest / scale.lowest);
}

/// A number of one digit, 1, 2 or 5, not above a length.
double round_length(double length) {
  const double decade = std::pow(10, std::floor(std::log10(length)));
  for (const double digit : {5, 2})
    if (digit * decade <= length) return digit * decade;
  return decade;
}

std::vector<double> ticks(const ColourScale& scale) {
  std::vector<double> result;
  if (scale.highest <= scale.lowest) return {scale.lowest};
  if (scale.logarithmic) {
    const int from = static_cast<int>(std::ceil(std::log10(scale.lowest) - 1e-9));
    const int to = static_cast<int>(std::floor(std::log10(scale.highest) + 1e-9));
    const int step = 1 + (to - from) / 6;
    for (int decade = from; decade <= to; decade += step) result.push_back(std::pow(10, decade));
    return result;
  }
  const double step = round_length((scale.highest - scale.lowest) / 4);
  for (double k = std::ceil(scale.lowest / step); k * step <= scale.highest * (1 + 1e-9); ++k)
    result.push_back(k * step);
  return result;
}

/// From units of the scene to pixels.
struct Frame {
  double scale;
  Vector<2> from;  ///< of the scene, at the lower left
  Vector<2> at;    ///< its pixel

  Vector<2> operator()(const Vector<2>& x) const {
    return {at.x() + scale * (x.x() - from.x()), at.y() - scale * (x.y() - from.y())};
  }
};

Frame frame_of(const std::vector<Tessera>& pieces, double top, double bottom) {
  Eigen::AlignedBox2d box;
  for (const Tessera& piece : pieces)
    for (const Vector<2>& x : piece.corner) box.extend(x);
  if (box.isEmpty()) box.extend(Vector<2>::Zero());
  const Vector<2> room(picture_width - 2 * picture_margin - bar_room, bottom - top);
  const Vector<2> size = box.sizes();
  double scale = INFINITY;
  for (int k = 0; k < 2; ++k)
    if (size[k] > 0) scale = std::min(scale, room[k] / size[k]);
  if (!std::isfinite(scale)) scale = 1;
  const Vector<2> left_over = (room - scale * size) / 2;
  return {scale, box.min(), {picture_margin + left_over.x(), bottom - left_over.y()}};
}

std::string path(const std::vector<Vector<2>>& pixels) {
  std::string text;
  for (const Vector<2>& x : pixels) text += fmt::format("{}{:.1f} {:.1f}", text.empty() ? "M" : "L", x.x(), x.y());
  return text;
}

std::string drawn_piece(const Tessera& piece, const Frame& frame, const ColourScale& colours) {
  std::vector<Vector<2>> pixels;
  for (const Vector<2>& x : piece.corner) pixels.push_back(frame(x));
  const std::string own = colour(place_on(colours, piece.value), piece.shade);
  std::string text = fmt::format("<path fill=\"{0}\" stroke=\"{0}\" d=\"{1}z\"/>\n", own, path(pixels));
  std::string lines;
  for (std::size_t i = 0; i < piece.outlined.size(); ++i)
    if (piece.outlined[i]) lines += path({pixels[i], pixels[(i + 1) % pixels.size()]});
  if (!lines.empty())
    text += fmt::format("<path fill=\"none\" stroke=\"#000000\" stroke-opacity=\"0.35\" d=\"{}\"/>\n", lines);
  return text;
}

std::string text_at(double x, double y, const std::string& text, const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>\n", x, y, more, escaped(text));
}

std::string colour_bar(const ColourScale& scale, double top, double bottom) {
  constexpr int steps = 64;
  const double x = picture_width - picture_margin - bar_room + 24, high = bottom - top;
  std::string text = text_at(picture_width - picture_margin, top - 8, scale.label, " text-anchor=\"end\"");
  for (int i = 0; i < steps; ++i)
    text += fmt::format("<rect x=\"{:.1f}\" y=\"{:.2f}\" width=\"{}\" height=\"{:.2f}\" fill=\"{}\"/>\n", x,
                        bottom - high * (i + 1) / steps, bar_width, high / steps + 0.3, colour((i + 0.5) / steps, 1));
  for (const double value : ticks(scale)) {
    const double y = bottom - high * std::clamp(place_on(scale, value), 0.0, 1.0);
    text += fmt::format("<path fill=\"none\" stroke=\"#444444\" d=\"M{:.1f} {:.1f}h5\"/>\n", x + bar_width, y) +
            text_at(x + bar_width + 9, y + 4, fmt::format("{:.4g}", value));
  }
  return text;
}

/// A length, and the way that the axes run.
std::string foot_of(const Sketch& sketch, const Frame& frame, double y) {
  const double length = round_length(0.2 * (picture_width - bar_room) / frame.scale);
  const double from = picture_margin + 90;
  std::string text = fmt::format("<path fill=\"none\" stroke=\"#444444\" d=\"M{0:.1f} {1:.1f}v-6v3h{2:.1f}v-3v6\"/>\n",
                                 from, y, length * frame.scale) +
                     text_at(from + length * frame.scale + 8, y + 1, fmt::format("{:g}{}", length, sketch.length_unit));
  const Vector<2> origin(picture_margin + 30, y - 16);
  constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    const Vector<2> along(24 * sketch.axes[k].x(), -24 * sketch.axes[k].y());
    if (along.norm() < 2) continue;
    const Vector<2> end = origin + along, beyond = origin + 1.4 * along;
    text += fmt::format("<path fill=\"none\" stroke=\"#444444\" d=\"{}\"/>\n", path({origin, end})) +
            text_at(beyond.x(), beyond.y() + 4, names[k], " text-anchor=\"middle\"");
  }
  return text;
}

}  // namespace

double quantile_by_area(const std::vector<Tessera>& pieces, double share) {
  std::vector<std::pair<double, double>> all;  // value, area
  double total = 0;
  for (const Tessera& piece : pieces) {
    if (std::isnan(piece.value)) continue;
    double area = 0;
    const Vector<2>& a = piece.corner[0];
    for (std::size_t i = 2; i < piece.corner.size(); ++i) {
      const Vector<2> b = piece.corner[i - 1] - a, c = piece.corner[i] - a;
      area += std::abs(b.x() * c.y() - b.y() * c.x()) / 2;
    }
    all.emplace_back(piece.value, area);
    total += area;
  }
  std::ranges::sort(all);
  double sum = 0;
  for (const auto& [value, area] : all)
    if ((sum += area) >= share * total) return value;
  return all.empty() ? 0 : all.back().first;
}

std::string svg(Sketch sketch) {
  std::ranges::stable_sort(sketch.pieces, {}, &Tessera::depth);
  const double top = picture_margin + 18, legend = legend_line * static_cast<double>(sketch.legend.size());
  const double bottom = picture_height - picture_margin - legend - foot;
  const Frame frame = frame_of(sketch.pieces, top, bottom);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"sans-serif\" font-size=\"13\" fill=\"#222222\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n<g stroke-width=\"0.8\" stroke-linejoin=\"round\">\n",
      picture_width, picture_height);
  for (const Tessera& piece : sketch.pieces) text += drawn_piece(piece, frame, sketch.colours);
  text += "</g>\n";
  for (const Vector<2>& ring : sketch.rings) {
    const Vector<2> at = frame(ring);
    text += fmt::format(
        "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\" fill=\"none\" stroke=\"#ff2f5f\" "
        "stroke-width=\"2\"/>\n",
        at.x(), at.y());
  }
  text +=
      colour_bar(sketch.colours, top + 10, bottom) + foot_of(sketch, frame, picture_height - picture_margin - legend);
  for (std::size_t i = 0; i < sketch.legend.size(); ++i)
    text += text_at(picture_margin, picture_height - picture_margin - legend + legend_line * static_cast<double>(i + 1),
                    sketch.legend[i]);
  return text + "</svg>\n";
}

}  // namespace bracket::apps
