// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/child.h"
#include "scene/mesh/readers.h"
#include "scene/text.h"

namespace bracket::scene {

RawMesh read_by_libgmsh(const std::filesystem::path& file, std::chrono::seconds limit) {
  const std::string where = file.string();
  const TemporaryFolder folder(where);
  const std::filesystem::path result =
      converted(file, folder, {"bracket-mesh-converter", "libgmsh", "mesh.msh", Status::mesh}, limit);
  try {
    return read_gmsh(result);
  } catch (const Error& error) {  // the place is one of the conversion
    const std::string line = error.what();
    const std::size_t message = line.find(": ");
    fail(Status::mesh, where, "as libgmsh reads it, " + line.substr(message == std::string::npos ? 0 : message + 2));
  }
}

}  // namespace bracket::scene
