// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/vtk_file.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>

namespace bracket::apps {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say that they are little-endian");

// The element that announces an array whose bytes begin at `offset` of the appended data.
std::string announce(const VtkArray& data, std::size_t offset) {
  std::string components;
  if (data.components.size() > 1) {
    components = fmt::format(R"( NumberOfComponents="{}")", data.components.size());
    for (std::size_t i = 0; i < data.components.size(); ++i)
      components += fmt::format(R"( ComponentName{}="{}")", i, data.components[i]);
  }
  return fmt::format(R"(<DataArray type="{}" Name="{}"{} format="appended" offset="{}"/>)"
                     "\n",
                     data.type, data.name, components, offset);
}

std::string_view bytes(const VtkArray& array) {
  return std::visit(
      [](const auto& values) {
        return std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
      },
      array.values);
}

// The arrays of VTK's three obligatory sections: where the points are, and which of them make a cell.
std::vector<VtkArray> topology(VtkGrid& grid) {
  const std::size_t n_points = grid.points.size() / 3;
  const std::size_t n_cells = n_points / grid.points_per_cell;
  LargeArray<std::int32_t> connectivity(n_points), offsets(n_cells);
  for (std::size_t i = 0; i < n_points; ++i) connectivity[i] = static_cast<std::int32_t>(i);
  for (std::size_t i = 0; i < n_cells; ++i) offsets[i] = static_cast<std::int32_t>((i + 1) * grid.points_per_cell);
  LargeArray<std::uint8_t> types(n_cells, static_cast<std::uint8_t>(grid.cell_type));
  std::vector<VtkArray> arrays;
  arrays.push_back(vtk_array("Points", "Float64", std::move(grid.points), {"x", "y", "z"}));
  arrays.push_back(vtk_array("connectivity", "Int32", std::move(connectivity)));
  arrays.push_back(vtk_array("offsets", "Int32", std::move(offsets)));
  arrays.push_back(vtk_array("types", "UInt8", std::move(types)));
  return arrays;
}

/// A number or a text of field data as text: of a double all digits; of a text its bytes as numbers, and a zero.
std::string written(const VtkField& field) {
  std::string text;
  for (const double number : field.numbers)
    text += std::isfinite(number) ? fmt::format("{} ", number)
                                  : std::string(number > 0   ? "inf "
                                                : number < 0 ? "-inf "
                                                             : "nan ");
  for (const std::string& each : field.texts) {
    for (const char c : each) text += fmt::format("{} ", static_cast<unsigned char>(c));
    text += "0 ";
  }
  const bool is_text = field.numbers.empty();
  const std::size_t tuples = is_text ? field.texts.size() : field.numbers.size() / field.components;
  return fmt::format(
      R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" NumberOfTuples="{}" format="ascii">{}</DataArray>)"
      "\n",
      is_text ? "String" : "Float64", field.name, is_text ? 1 : field.components, tuples, text);
}

std::string field_data(const VtkGrid& grid) {
  std::string text;
  for (const VtkField& field : grid.field_data)
    if (!field.numbers.empty() || !field.texts.empty()) text += written(field);
  return text.empty() ? "" : "<FieldData>\n" + text + "</FieldData>\n";
}

}  // namespace

std::string vtu(VtkGrid grid) {
  const std::size_t n_points = grid.points.size() / 3;
  std::vector<VtkArray> shape = topology(grid);
  std::string header, data;
  std::vector<VtkArray*> order;  // of the appended data
  std::size_t offset = 0;
  const auto section = [&](const std::string& name, std::span<VtkArray> arrays) {
    header += fmt::format("<{}>\n", name);
    for (VtkArray& each : arrays) {
      header += announce(each, offset);
      offset += sizeof(std::uint64_t) + bytes(each).size();
      order.push_back(&each);
    }
    header += fmt::format("</{}>\n", name);
  };
  header = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n{}<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
      field_data(grid), n_points, n_points / grid.points_per_cell);
  section("Points", std::span(shape).first(1));
  section("Cells", std::span(shape).subspan(1));
  section("PointData", grid.point_data);
  section("CellData", grid.cell_data);
  header += "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";

  const std::string end = "\n</AppendedData>\n</VTKFile>\n";
  std::string file;
  file.reserve(header.size() + offset + end.size());
  contact::use_large_pages(file.data(), file.capacity());
  file += header;
  for (VtkArray* each : order) {
    const std::uint64_t size = bytes(*each).size();
    file.append(reinterpret_cast<const char*>(&size), sizeof size);
    file += bytes(*each);
    std::visit([](auto& values) { std::remove_reference_t<decltype(values)>().swap(values); }, each->values);
  }
  return file += end;
}

void append(LargeArray<double>& points, const scene::Vector<2>& point) {
  points.insert(points.end(), {point.x(), point.y(), 0.0});
}

}  // namespace bracket::apps
