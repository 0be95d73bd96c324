// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "contact/large_array.h"
#include "scene/scene.h"

/// VTK's XML files of unstructured grids.
namespace bracket::apps {

using contact::LargeArray;

struct VtkArray {
  std::string name;
  std::string type;                     ///< as VTK calls it
  std::vector<std::string> components;  ///< their names; one without name: a scalar
  std::variant<LargeArray<double>, LargeArray<float>, LargeArray<std::int32_t>, LargeArray<std::uint8_t>> values;
};

/// \param values to be moved in: all numbers of a level are, and are held once
template <typename Number>
VtkArray vtk_array(std::string name, const char* type, LargeArray<Number> values,
                   std::vector<std::string> components = {""}) {
  return {std::move(name), type, std::move(components), std::move(values)};
}

/// What holds of a file as a whole: numbers, some to a tuple, or texts.
struct VtkField {
  std::string name;
  std::vector<double> numbers;
  int components = 1;
  std::vector<std::string> texts = {};  ///< where there are no numbers
};

struct VtkGrid {
  int cell_type = 0;  ///< VTK's number
  int points_per_cell = 0;
  LargeArray<double> points = {};  ///< x, y, z of each; the points of a cell follow one another and are its own
  std::vector<VtkArray> point_data = {};
  std::vector<VtkArray> cell_data = {};
  std::vector<VtkField> field_data = {};
};

/// The file: appended raw data, field data as text.
std::string vtu(VtkGrid grid);

void append(LargeArray<double>& points, const scene::Vector<2>& point);  ///< with a third coordinate 0

}  // namespace bracket::apps
