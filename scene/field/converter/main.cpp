// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// bracket-field-converter FROM TO: points, cells and point data of a VTK file of an unstructured grid (.vtu), however
// it is encoded, as the text that scene/field/vtu.cpp reads. A program of its own, so that VTK's faults end this
// process alone, and that nothing else is linked to it.
#include <sys/resource.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>

namespace {

/// Keeps the first error that VTK tells, which goes on as if nothing had happened.
class Errors : public vtkOutputWindow {
 public:
  static Errors* New();
  vtkTypeMacro(Errors, vtkOutputWindow);
  void DisplayErrorText(const char* text) override {
    if (!first.empty()) return;
    first = text;
    if (const std::size_t object = first.find("): "); object != std::string::npos) first.erase(0, object + 3);
    first.erase(std::min(first.find('\n'), first.size()));
  }
  void DisplayText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  std::string first;
};
vtkStandardNewMacro(Errors);

const char* precision(const vtkDataArray& array) {
  return const_cast<vtkDataArray&>(array).GetDataType() == VTK_FLOAT ? "float" : "double";
}

void write_values(std::FILE* file, vtkDataArray& array) {
  const int components = array.GetNumberOfComponents();
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
    for (int c = 0; c < components; ++c)
      std::fprintf(file, "%.17g%c", array.GetComponent(i, c), c + 1 == components ? '\n' : ' ');
}

void write_cells(std::FILE* file, vtkUnstructuredGrid& grid) {
  std::fprintf(file, "cells %lld\n", static_cast<long long>(grid.GetNumberOfCells()));
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell) {
    grid.GetCellPoints(cell, points);
    std::fprintf(file, "%d %lld", grid.GetCellType(cell), static_cast<long long>(points->GetNumberOfIds()));
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i) {
      const long long point = points->GetId(i);
      if (point < 0 || point >= grid.GetNumberOfPoints())
        throw std::runtime_error("cell " + std::to_string(cell) + " has the point " + std::to_string(point) +
                                 ", which is not there");
      std::fprintf(file, " %lld", point);
    }
    std::fputc('\n', file);
  }
}

void write_arrays(std::FILE* file, vtkPointData& data, vtkIdType points) {
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    vtkDataArray* array = data.GetArray(i);  // null: texts
    const char* name = data.GetArrayName(i);
    if (array == nullptr || name == nullptr) continue;
    if (array->GetNumberOfTuples() != points)
      throw std::runtime_error(std::string("the array '") + name + "' is short");
    std::fprintf(file, "array %d %s %s\n", array->GetNumberOfComponents(), precision(*array), name);
    write_values(file, *array);
  }
}

void convert(const char* from, const char* to) {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<Errors> errors;
  vtkOutputWindow::SetInstance(errors);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(from);
  reader->Update();
  vtkUnstructuredGrid* grid = reader->GetOutput();
  if (!errors->first.empty()) throw std::runtime_error(errors->first);
  if (grid == nullptr || grid->GetPoints() == nullptr || grid->GetNumberOfPoints() == 0)
    throw std::runtime_error("there are no points");
  std::FILE* file = std::fopen(to, "w");
  if (file == nullptr) throw std::runtime_error("no room for the conversion");
  vtkDataArray& points = *grid->GetPoints()->GetData();
  std::fprintf(file, "points %lld %s\n", static_cast<long long>(grid->GetNumberOfPoints()), precision(points));
  write_values(file, points);
  write_cells(file, *grid);
  write_arrays(file, *grid->GetPointData(), grid->GetNumberOfPoints());
  if (std::ferror(file) != 0 || std::fclose(file) != 0) throw std::runtime_error("no room for the conversion");
}

int run(const char* from, const char* to) {
  try {
    convert(from, to);
    return 0;
  } catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    return 1;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("expected: bracket-field-converter FROM TO\n", stderr);
    return 1;
  }
  const rlimit none = {0, 0};
  setrlimit(RLIMIT_CORE, &none);
  const int status = run(argv[1], argv[2]);
  std::fflush(stderr);
  std::_Exit(status);  // what VTK leaves behind goes with the process
}
