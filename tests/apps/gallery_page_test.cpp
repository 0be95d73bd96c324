// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// docs/gallery.md: what its command writes, again and again; every scene is there.
#include <regex>

#include "tests/apps/command.h"

namespace bracket::apps::tests {
namespace {

namespace fs = std::filesystem;

class GalleryPage : public Command {
 protected:
  /// What the page says of a scene, without the digits of its intervals, which other processors may tell otherwise.
  static std::string section(const std::string& page, const std::string& name) {
    const std::size_t end = page.find("`bracket run apps/scenes/" + name + ".toml`");
    EXPECT_NE(end, std::string::npos) << name;
    const std::size_t begin = page.rfind("\n## ", end);
    return std::regex_replace(page.substr(begin, end - begin), std::regex(R"(\[-?[0-9.e+-]+, -?[0-9.e+-]+\])"), "[]");
  }
};

TEST_F(GalleryPage, IsWhatItsCommandWritesAndASecondRunChangesNothing) {
  const std::vector<std::string> names = {"example_1", "linear_pressure", "patch", "wedge", "space/patch"};
  std::string scenes;
  for (const std::string& name : names) scenes += " '" BRACKET_SCENES "/" + name + ".toml'";
  for (const char* folder : {"once", "twice"}) {
    const Ended ended =
        shell(std::string("sh '" BRACKET_DOCS "/gallery/make.sh' '" BRACKET_PROGRAM "' ") + folder + scenes);
    EXPECT_EQ(ended.status, 0) << ended.err;
  }
  const Ended same = shell("diff -r once twice");
  EXPECT_EQ(same.status, 0) << same.out;
  shell("cp '" BRACKET_DOCS "/gallery.md' committed.md");
  for (const std::string& name : names)
    EXPECT_EQ(section(read("once/gallery.md"), name), section(read("committed.md"), name));
}

TEST_F(GalleryPage, HasEverySceneAndItsPicture) {
  shell("cp '" BRACKET_DOCS "/gallery.md' committed.md");
  const std::string page = read("committed.md");
  for (const auto& entry : fs::recursive_directory_iterator(BRACKET_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    const std::string name = fs::relative(entry.path(), BRACKET_SCENES).replace_extension().string();
    EXPECT_NE(section(page, name).find("](images/gallery/" + name + ".png)"), std::string::npos) << name;
    EXPECT_TRUE(fs::exists(BRACKET_DOCS "/images/gallery/" + name + ".png")) << name;
  }
}

}  // namespace
}  // namespace bracket::apps::tests
