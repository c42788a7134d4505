#include "core/layers.h"

#include <gtest/gtest.h>

#include "core/test_folder.h"

namespace penumbra {
namespace {

using testing::TestFolder;

TEST(Layers, ALaterFolderReplacesFilesOfTheSameName) {
    const TestFolder folder;
    folder.write("handout/a.glsl", "");
    folder.write("handout/b.glsl", "");
    folder.write("solution/a.glsl", "");
    const Layers layers({folder / "handout", folder / "solution"});
    EXPECT_EQ(layers.find("a.glsl"), folder / "solution" / "a.glsl");
    EXPECT_EQ(layers.find("b.glsl"), folder / "handout" / "b.glsl");
    EXPECT_EQ(layers.find("c.glsl"), std::nullopt);
}

TEST(Layers, ANameNeverLeavesItsFolder) {
    const TestFolder folder;
    folder.write("secret", "");
    folder.write("handout/a.glsl", "");
    const Layers layers({folder / "handout"});
    for (const std::string& name : {std::string("../secret"), std::string(""), std::string("."),
                                    std::string(".."), (folder / "secret").string()})
        EXPECT_EQ(layers.find(name), std::nullopt) << name;
}

TEST(Layers, AFolderIsNoFile) {
    const TestFolder folder;
    folder.write("handout/given/a.glsl", "");
    EXPECT_EQ(Layers({folder / "handout"}).find("given"), std::nullopt);
}

}  // namespace
}  // namespace penumbra
