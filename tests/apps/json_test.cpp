// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

using Json = nlohmann::json;

/// What programs read in place of people.
class JsonOutput : public Command {
 protected:
  JsonOutput() { write("scene.toml", two_blocks); }
};

TEST_F(JsonOutput, CheckTellsTheSameAsItsText) {
  const Ended text = shell("bracket check scene.toml"), json = shell("bracket check scene.toml --json");
  ASSERT_EQ(json.status, 0) << json.err;
  EXPECT_EQ(json.err, "");
  const Json told = Json::parse(json.out);
  EXPECT_EQ(told["schema"], 1);
  EXPECT_EQ(told["status"], "done");
  EXPECT_EQ(told["scene"], "scene.toml");
  int cells = 0;
  for (const Json& body : told["bodies"]) {
    cells += body["cells"].get<int>();
    EXPECT_NE(text.out.find("body " + body["name"].get<std::string>()), std::string::npos);
    EXPECT_EQ(body["area"], 1.0);
  }
  EXPECT_EQ(told["mesh"]["cells"], cells);
  EXPECT_EQ(told["boundary"].size(), 8u);
  for (const Json& part : told["boundary"])
    EXPECT_NE(text.out.find(part["name"].get<std::string>() +
                            ": 4 edges, length 1 mm: " + part["condition"].get<std::string>() + "\n"),
              std::string::npos)
        << part;
  ASSERT_EQ(told["contact"].size(), 1u);
  EXPECT_EQ(told["contact"][0]["first"], Json::array({"upper.bottom"}));
  EXPECT_EQ(told["contact"][0]["edges"], 4);
  EXPECT_EQ(told["contact"][0]["gap"]["smallest"], 0.0);
}

TEST_F(JsonOutput, InfoTellsTheMesh) {
  write("square.inp",
        "*NODE\n1,0,0,5\n2,1,0,5\n3,1,1,5\n4,0,1,5\n*ELEMENT,TYPE=CPS4,ELSET=plate\n1,1,2,3,4\n"
        "*NSET,NSET=base\n1,2\n");
  const Ended ended = shell("bracket info square.inp --json");
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  const Json told = Json::parse(ended.out);
  EXPECT_EQ(told["bodies"], Json::parse(R"([{"name": "plate", "cells": 2, "area": 1.0}])"));
  EXPECT_EQ(told["boundary"], Json::parse(R"([{"name": "base", "edges": 1, "length": 1.0},
                                              {"name": null, "edges": 3, "length": 3.0}])"));
  EXPECT_EQ(told["notes"].size(), 2u);
  EXPECT_EQ(told["mesh"]["quality"]["smallest_angle"], 45.0);
}

TEST_F(JsonOutput, WhateverFailsSaysSoInJsonToo) {
  write("bad.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
  write("name.toml", std::string("title = \"") + "\xff\"\n");
  const std::string pulled = " scene.toml --set 'boundary.\"upper.top\".traction=[0, 0.1]'";
  for (const auto& [arguments, status, name] : {std::tuple(std::string("run nowhere.toml"), 2, "input_error"),
                                                {"run name.toml", 2, "input_error"},
                                                {"run scene.toml --fast", 2, "input_error"},
                                                {"info bad.msh", 3, "mesh_error"},
                                                {"run" + pulled, 4, "ill_posed"},
                                                {"check" + pulled, 4, "ill_posed"}}) {
    const Ended ended = shell("bracket " + arguments + " --json");
    EXPECT_EQ(ended.status, status) << ended.err;
    const Json told = Json::parse(ended.out);
    EXPECT_EQ(told["schema"], 1);
    EXPECT_EQ(told["status"], name);
    EXPECT_EQ(told["exit_status"], status);
    EXPECT_EQ("bracket: " + told["reason"].get<std::string>() + "\n", ended.err);
  }
}

TEST_F(JsonOutput, ARunThatEndsEarlyHasItsReportAlone) {
  const Ended ended = shell("bracket run scene.toml --no-report --json --set refine.target=1e-9");
  EXPECT_EQ(ended.status, 5);
  EXPECT_EQ(Json::parse(ended.out)["status"], "budget_spent");
}

}  // namespace
}  // namespace bracket::apps::tests
