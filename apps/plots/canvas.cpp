// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/plots/canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "apps/plots/pictures.h"

namespace bracket::apps {
namespace {

constexpr const char* viridis =
    "set palette defined (0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 '#28ae80', 6 '#5ec962', "
    "7 '#addc30', 8 '#fde725')\n";

/// A step of 1, 2 or 5 times a power of ten, not below the least.
double step(double least) {
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double digit : {1, 2, 5})
    if (digit * power >= least) return digit * power;
  return 10 * power;
}

}  // namespace

std::string line_data(const std::vector<Line>& lines) {
  std::string text;
  for (const Line& line : lines) {
    for (const scene::Vector<2>& point : line)
      fmt::format_to(std::back_inserter(text), "{:.9g} {:.9g}\n", point.x(), point.y());
    text += "\n";
  }
  return (lines.empty() ? "NaN NaN\n" : text) + "e\n";
}

Layer lines_layer(const std::vector<Line>& lines, const std::string& style) {
  return {"'-' with lines " + style, line_data(lines)};
}

Layer image_layer(const Raster& raster) { return {image_item(raster), image_bytes(raster) + "\n"}; }

Picture canvas(const char* name, std::string caption, const Eigen::AlignedBox2d& box, const std::string& units) {
  const scene::Vector<2> size = box.sizes();
  const double scale = std::min(360 / size.x(), 430 / size.y()), margin = 0.02 * size.maxCoeff();
  constexpr int width = 600, bottom = 72, top = 40;
  const double drawn = std::max(60.0, scale * size.x()), left = 95 + (360 - drawn) / 2, right = width - left - drawn;
  const int height = bottom + std::max(150, static_cast<int>(scale * size.y())) + top;
  const auto range = [&](int axis) {
    return fmt::format("[{}:{}]", box.min()[axis] - margin, box.max()[axis] + margin);
  };
  const auto part = [](double pixels, double of) { return fmt::format("at screen {:.4f}", pixels / of); };
  std::string script =
      plot_style() + "unset grid\nset key at screen 0.02,0.99 left top horizontal maxrows 1\nset size ratio -1\n" +
      viridis +
      fmt::format("set xrange {}\nset yrange {}\nset xtics {}\nset ytics {}\n", range(0), range(1), step(60 / scale),
                  step(40 / scale)) +
      fmt::format("set lmargin {}\nset rmargin {}\nset bmargin {}\nset tmargin {}\n", part(left, width),
                  part(width - right, width), part(bottom, height), part(height - top, height)) +
      fmt::format("set xlabel {} noenhanced\nset ylabel {} noenhanced\n", with_unit("x", length_unit(units)),
                  with_unit("y", length_unit(units)));
  return {name, std::move(caption), width, height, std::move(script)};
}

std::string plot_command(const std::vector<Layer>& layers) {
  std::string items, data;
  for (const Layer& layer : layers) {
    items += (items.empty() ? "plot " : ", ") + layer.item;
    data += layer.data;
  }
  return items + "\n" + data;
}

Eigen::AlignedBox2d box_of(const Raster& raster) {
  return {raster.low, raster.low + raster.pixel * scene::Vector<2>(raster.width, raster.height)};
}

Eigen::AlignedBox2d box_of(Eigen::AlignedBox2d box, const std::vector<Line>& lines) {
  for (const Line& line : lines)
    for (const scene::Vector<2>& point : line) box.extend(point);
  return box;
}

}  // namespace bracket::apps
