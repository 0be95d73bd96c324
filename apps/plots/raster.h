// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/scene.h"

/// Fields as bitmaps: a picture's size does not grow with the mesh.
namespace bracket::apps {

/// A triangle with a value at each corner, linear between.
struct Tile {
  std::array<scene::Vector<2>, 3> corner;
  std::array<float, 3> value;
};

struct Raster {
  scene::Vector<2> low = scene::Vector<2>::Zero();  ///< lower left corner of the lower left pixel
  double pixel = 1;                                 ///< its side
  int width = 0, height = 0;
  std::vector<float> value;  ///< rows from below, each from the left; NaN where there is no tile
};

/// \param longest pixels along the longer side of the tiles' bounding box, which the raster just covers
/// \pre at least one tile, of some size
Raster rasterise(const std::vector<Tile>& tiles, int longest);

/// The value that the fraction `part` of the pixels stays below; 0 without pixels.
float quantile(const Raster& raster, double part);

/// An item of gnuplot's plot command that draws the raster, whose bytes stand behind the command.
std::string image_item(const Raster& raster);
std::string image_bytes(const Raster& raster);

}  // namespace bracket::apps
