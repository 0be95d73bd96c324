// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/types.h"

/// Pictures of bodies in space as SVG by a writer of our own: flat pieces, the farthest first.
namespace bracket::apps {

/// A flat convex piece of what is drawn.
struct Tessera {
  std::vector<scene::Vector<2>> corner;  ///< in the picture's plane, in units of the scene
  double value;                          ///< by which it is coloured; not a number: grey
  double depth = 0;                      ///< along the way to the eye: the nearer, the larger
  double shade = 1;                      ///< by which its colour is darkened, from 0 to 1
  std::vector<char> outlined =
      {};  ///< of each side, from its corner to the next: whether a cell ends there; empty: none
};

/// What colours mean.
struct ColourScale {
  double lowest = 0, highest = 1;  ///< beyond them the colour stays
  bool logarithmic = false;        ///< then lowest > 0
  std::string label;               ///< with the unit
};

/// A picture: pieces, their colours, a bar for lengths, axes.
struct Sketch {
  std::vector<Tessera> pieces;
  ColourScale colours;
  std::array<scene::Vector<2>, 3> axes;      ///< how x, y and z run in the picture; zero: towards the eye
  std::string length_unit;                   ///< with a blank in front; empty: not known
  std::vector<std::string> legend;           ///< lines below: what is magnified, from where it is seen
  std::vector<scene::Vector<2>> rings = {};  ///< points that are marked
};

/// The value below which the share of the pieces' area lies, of those that have one; 0 without any.
double quantile_by_area(const std::vector<Tessera>& pieces, double share);

/// As SVG, text and all; the same to the last byte for the same sketch.
std::string svg(Sketch sketch);

}  // namespace bracket::apps
