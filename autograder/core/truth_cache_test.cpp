#include "core/truth_cache.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <set>

#include "core/grading_session.h"
#include "core/truths.h"

namespace penumbra {
namespace {

namespace fs = std::filesystem;

Image noise(int side, unsigned seed) {
    Image image(side, side, 1);
    for (float& v : image.pixels) v = float(seed = 1664525u * seed + 1013904223u) / 4294967296.0f;
    return image;
}

Scene triangle() {
    Scene scene;
    scene.name = "triangle";
    scene.materials = {{.name = "grey"}};
    Mesh mesh;
    mesh.positions = {{-5, 0, -5}, {5, 0, -5}, {0, 0, 5}};
    mesh.triangles = {{0, 1, 2}};
    scene.meshes = {mesh};
    scene.lights = {Light()};
    return scene;
}

std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    return files;
}

class Truths : public testing::Test {
protected:
    // How often the function ran.
    Image ask(const TruthKey& key, const Image& truth) {
        return cached(key, [&] {
            ++computed;
            return truth;
        });
    }
    ScratchFolder scratch;
    fs::path folder = scratch.path() / "truths";
    GradingSession session{{}, {.truths = TruthCache(folder)}};
    int computed = 0;
};

TEST_F(Truths, AHitIsTheSameImageBitForBit) {
    Image truth = noise(33, 7);
    truth.at(1, 2) = -0.0f, truth.at(2, 2) = 1e-42f;
    const Image first = ask(TruthKey("noise", 33), truth);
    const Image second = ask(TruthKey("noise", 33), noise(33, 8));  // not asked
    EXPECT_EQ(computed, 1);
    for (const Image& image : {first, second}) {
        ASSERT_TRUE(image.sameShape(truth));
        EXPECT_EQ(std::memcmp(image.pixels.data(), truth.pixels.data(),
                              sizeof(float) * truth.pixels.size()),
                  0);
    }
}

TEST_F(Truths, AnotherKeyIsComputedAnew) {
    const Image truth = noise(4, 1);
    for (const int samples : {16, 17}) ask(TruthKey("area", samples), truth);
    ask(TruthKey("point", 16), truth);
    ask(TruthKey("area", 16.0f), truth);
    EXPECT_EQ(computed, 4);
    ask(TruthKey("area", 17), truth);
    EXPECT_EQ(computed, 4);
}

TEST(TruthKey, KnowsEveryPartOfAScene) {
    const Scene scene = triangle();
    std::vector<Scene> others(12, scene);
    others[0].meshes[0].positions[1].y = 1e-7f;
    others[1].meshes[0].triangles[0] = {0, 2, 1};
    others[2].meshes.push_back(scene.meshes[0]);
    others[3].meshes[0].uvs = {{0, 0}, {1, 0}, {0, 1}};
    others[4].materials[0].alphaCutoff = 0.5f;
    others[5].textures.push_back({1, 1, {255, 255, 255, 0}});
    others[6].camera.verticalFov += 0.01f;
    others[7].lights[0].width += 0.01f;
    others[8].lights[0].directional = true;
    others[9].lights.push_back(scene.lights[0]);
    others[10].meshes[0].material = 1;
    others[11].lights[0].range = 9.0f;
    std::set<std::string> keys{TruthKey("scene", scene).text()};
    for (const Scene& other : others) keys.insert(TruthKey("scene", other).text());
    EXPECT_EQ(keys.size(), others.size() + 1);
    EXPECT_EQ(keys.count(TruthKey("scene", triangle()).text()), 1u);
}

TEST(TruthKey, TellsWhereOneListEndsAndTheNextBegins) {
    using Floats = std::vector<float>;
    EXPECT_NE(TruthKey("", Floats{1, 2}, Floats{3}).text(),
              TruthKey("", Floats{1}, Floats{2, 3}).text());
    EXPECT_NE(TruthKey("ab", "c").text(), TruthKey("a", "bc").text());
    EXPECT_NE(TruthKey("", Floats{1}).text(), TruthKey("", Floats{1, 0}).text());
}

TEST(TruthKey, TheCodeIsKnown) { EXPECT_EQ(codeHash().size(), 32u); }

TEST_F(Truths, DamagedFilesAreComputedAnew) {
    const Image truth = noise(16, 3);
    const TruthKey key("noise", 16);
    const auto damage = [&](const std::function<void(const fs::path&)>& how) {
        ask(key, truth);
        const auto files = filesIn(folder);
        ASSERT_EQ(files.size(), 1u);
        how(files[0]);
        const int before = computed;
        EXPECT_EQ(ask(key, truth).pixels, truth.pixels);
        EXPECT_EQ(computed, before + 1);
    };
    damage([](const fs::path& file) { fs::resize_file(file, fs::file_size(file) - 5); });
    damage([](const fs::path& file) { fs::resize_file(file, 0); });
    damage([](const fs::path& file) { std::ofstream(file) << "garbage"; });
    damage([](const fs::path& file) {  // one bit of one value
        std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
        stream.seekg(-7, std::ios::end);
        const char byte = char(stream.get() ^ 1);
        stream.seekp(-7, std::ios::end);
        stream.put(byte);
    });
}

// Children of the test write and read the same truths at once; each looks at every bit.
TEST_F(Truths, ManyProcessesMayShareAFolder) {
    std::vector<pid_t> children;
    for (int child = 0; child < 4; ++child) {
        const pid_t pid = fork();
        if (pid == 0) {
            int wrong = 0;
            for (unsigned i = 0; i < 100; ++i) {
                const Image truth = noise(64, i % 5);
                wrong += ask(TruthKey("noise", i % 5), truth).pixels != truth.pixels;
            }
            _exit(wrong == 0 ? 0 : 1);
        }
        children.push_back(pid);
    }
    for (const pid_t pid : children) {
        int status = -1;
        waitpid(pid, &status, 0);
        EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    }
    EXPECT_EQ(filesIn(folder).size(), 5u);  // and nothing half written
}

TEST_F(Truths, TheLongestUnusedGoWhenTheFolderIsFull) {
    const TruthCache small(folder, 15000);  // three images of 32², not four
    const auto key = [](int i) { return TruthKey("noise", i); };
    for (int i = 0; i < 3; ++i) {
        small.save(key(i), toImages(noise(32, unsigned(i))));
        for (const auto& file : filesIn(folder))  // an hour passes
            fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(1));
    }
    EXPECT_TRUE(small.load(key(0)));
    small.save(key(3), toImages(noise(32, 3)));
    EXPECT_TRUE(small.load(key(0)) && small.load(key(2)) && small.load(key(3)));
    EXPECT_FALSE(small.load(key(1)));
}

TEST_F(Truths, WithoutAFolderNothingIsKept) {
    const TruthCache none;
    none.save(TruthKey("noise"), toImages(noise(8, 1)));
    EXPECT_FALSE(none.load(TruthKey("noise")));
    // A folder that cannot be written costs time alone.
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_EQ(ask(TruthKey("noise"), noise(8, 2)).pixels, noise(8, 2).pixels);
    fs::permissions(folder, fs::perms::owner_all);
}

void expectSame(const Receivers& a, const Receivers& b) {
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.facetNormals, b.facetNormals);
    EXPECT_EQ(a.hit, b.hit);
}

TEST_F(Truths, ATracedSceneIsTheSameTwice) {
    const glm::ivec2 size(24, 16);
    const TracedScene first(triangle(), size), second(triangle(), size);
    expectSame(first.receivers(), RayTracer(triangle()).receivers(triangle().camera, size));
    expectSame(first.receivers(), second.receivers());
    EXPECT_EQ(first.areaVisibility(9).pixels, second.areaVisibility(9).pixels);
    EXPECT_EQ(first.pointVisibility().pixels, second.pointVisibility().pixels);
    EXPECT_EQ(first.volumeCount().decidable.pixels, second.volumeCount().decidable.pixels);
    EXPECT_EQ(filesIn(folder).size(), 4u);
}

}  // namespace
}  // namespace penumbra
