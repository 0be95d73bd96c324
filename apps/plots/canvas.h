// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/plots/picture.h"
#include "apps/plots/raster.h"

/// Pictures of bodies: a bitmap of a field, with lines over it.
namespace bracket::apps {

inline constexpr int longest_side = 1000;  ///< pixels of the bitmap; about two to one of the picture

using Line = std::vector<scene::Vector<2>>;

/// Lines as inline data of gnuplot: with none, one point without a value.
std::string line_data(const std::vector<Line>& lines);

/// What is drawn over or under the bitmap: an item of gnuplot's plot command, and its inline data.
struct Layer {
  std::string item, data;
};
Layer lines_layer(const std::vector<Line>& lines, const std::string& style);
Layer image_layer(const Raster& raster);

/// Axes of equal scale in units of the scene, and the colours at the right.
/// \param box what has to be seen   \param units the scene's label
Picture canvas(const char* name, std::string caption, const Eigen::AlignedBox2d& box, const std::string& units);

/// The command that draws layers, one over the other, and their data.
std::string plot_command(const std::vector<Layer>& layers);

/// The box of a raster, and of it and lines.
Eigen::AlignedBox2d box_of(const Raster& raster);
Eigen::AlignedBox2d box_of(Eigen::AlignedBox2d box, const std::vector<Line>& lines);

}  // namespace bracket::apps
