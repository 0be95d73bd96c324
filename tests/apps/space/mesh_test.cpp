// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// bracket mesh and info: tetrahedra for other programs.
#include <nlohmann/json.hpp>

#include "tests/apps/command.h"
#include "tests/apps/space/scenes.h"

namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;

class MeshInSpace : public Command {
 protected:
  MeshInSpace() { write("boxes.toml", two_boxes); }
};

TEST_F(MeshInSpace, InfoReadsWhatIsWritten) {
  const Json scene = Json::parse(shell("bracket check boxes.toml --json").out);
  for (const std::string ending : {"msh", "inp"})
    for (const std::string degree : {"1", "2"}) {
      const std::string file = "boxes" + degree + "." + ending;
      const Ended ended = shell("bracket mesh boxes.toml -o " + file + " --degree " + degree);
      ASSERT_EQ(ended.status, 0) << ended.err;
      EXPECT_NE(ended.out.find("tetrahedra"), std::string::npos);
      const Ended told = shell("bracket info --json " + file);
      ASSERT_EQ(told.status, 0) << told.err;
      const Json info = Json::parse(told.out);
      EXPECT_EQ(info["dim"], 3);
      for (const char* key : {"cells", "vertices", "edges"}) EXPECT_EQ(info["mesh"][key], scene["mesh"][key]) << file;
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(info["bodies"][i]["name"], scene["bodies"][i]["name"]) << file;
        EXPECT_EQ(info["bodies"][i]["volume"], scene["bodies"][i]["volume"]) << file;
      }
      EXPECT_EQ(info["boundary"].size(), scene["boundary"].size()) << file;
    }
}

// The same mesh, the same problem: bounds differ by rounding at most, as nodes may have another order.
TEST_F(MeshInSpace, OfASceneGivesItsBracketAgain) {
  ASSERT_EQ(shell("bracket mesh boxes.toml -o boxes.msh --degree 1").status, 0);
  std::string scene = two_boxes;
  for (std::size_t at; (at = scene.find("[[mesh.block]]")) != std::string::npos;)
    scene.erase(at, scene.find("\n[", at + 1) + 1 - at);
  scene.erase(scene.find("dim = 3\n"), 8);  // the mesh tells it
  write("again.toml", "mesh.file = \"boxes.msh\"\n" + scene);
  const Json blocks = Json::parse(shell("bracket run boxes.toml --json --no-report").out);
  const Json file = Json::parse(shell("bracket run again.toml --json --no-report").out);
  for (const char* end : {"lower", "upper"}) {
    const double one = blocks["energy"][end], other = file["energy"][end];
    EXPECT_NEAR(other, one, 1e-9 * std::abs(one)) << end;
  }
}

TEST_F(MeshInSpace, TooManyCellsAreRefused) {
  const Ended ended = shell("bracket mesh boxes.toml -o boxes.vtu --refine 3 --set refine.max_cells=100");
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("refine.max_cells = 100"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace bracket::apps::tests
