// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// bracket-mesh-converter FROM TO: a mesh of any kind that libgmsh reads, as Gmsh ASCII 4.1. A program of its own, so
// that libgmsh's faults end this process alone.
#include <gmsh.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace {

void convert(const char* from, const char* to) {
  gmsh::initialize(0, nullptr, false);  // no start-up files
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::open(from);
  gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
  gmsh::option::setNumber("Mesh.Binary", 0);
  gmsh::option::setNumber("Mesh.SaveAll", 1);
  gmsh::write(to);
}

int refuse(const std::string& reason) {
  std::fputs(reason.c_str(), stderr);
  std::fflush(stderr);
  return 1;
}

int run(const char* from, const char* to) {
  try {
    convert(from, to);
    return 0;
  } catch (const std::exception& error) {
    return refuse(error.what());
  } catch (const std::string& error) {  // what libgmsh throws
    return refuse(error);
  } catch (...) {
    return refuse("an unknown fault");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return refuse("expected: bracket-mesh-converter FROM TO\n");
  const rlimit none = {0, 0};
  setrlimit(RLIMIT_CORE, &none);
  std::_Exit(run(argv[1], argv[2]));  // what libgmsh leaves behind goes with the process
}
