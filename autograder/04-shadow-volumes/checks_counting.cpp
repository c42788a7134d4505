// Shadow volumes: counting before the surface and behind it, caps, and the infinite projection.
#include <glad/gl.h>

#include <fmt/format.h>
#include <algorithm>

#include "volume_checks.h"

namespace penumbra {
namespace {

const SettingList kZPass{"method=zpass"};
const SettingList kZFail{"method=zfail"};
const std::string kTable = "the constants of glStencilOp and glDepthFunc themselves";

SettingList with(SettingList settings, const char* more) {
    settings.emplace_back(more);
    return settings;
}

// A row of counting_state: depthTest, writesDepth, then three operations each of front and back.
std::vector<int> countingTable(int row) {
    const Rendered frame =
        render({.scene = "boxes", .size = {16, 16}, .images = {{"counting_state", {8, 2}}}});
    std::vector<int> values;
    for (int i = 0; i < 8; ++i) values.push_back(int(frame.at("counting_state").at(i, row)));
    return values;
}

void expectDepthLeftAlone(const SettingList& settings) {
    const auto frame = [](const SettingList& some) {
        return render({.scene = "stairs",
                       .size = {kSize, kSize},
                       .settings = some,
                       .images = {"depth", "stencil_count"}});
    };
    const Rendered mine = frame(settings), bare = frame(with(settings, "shadows=off"));
    EXPECT_IMAGE_NEAR(mine.at("depth"), bare.at("depth"),
                      {.maximum = 0, .cause = "the same surfaces: not one bit differs"});
    EXPECT_VALUE(shareOfZeros(mine.at("stencil_count")), Less, 0.99, "volumes were drawn");
}

constexpr const char* kHundredsOfLayers = "nested@300";  // more than 8 bits can hold

// The steps of `stairs` touch: faces that one covers for another have rims in the side's plane,
// which a rasteriser, snapping them, may show, and rays never meet.
const CountTolerance kTouchingSteps{
    3, "rims of faces between steps that touch, shown by the rasteriser alone; 1 measured"};

// --- Task 3 ---

TEST(Task3ZPass, AFrontCountsUpAndABackDown) {
    const std::vector<int> mine = countingTable(0);
    expectEqualLists("depthTest, writesDepth", {mine[0], mine[1]}, {GL_LESS, 0}, kTable);
    expectEqualLists("front and back of zPassCounting()", {mine.begin() + 2, mine.end()},
                     {GL_KEEP, GL_KEEP, GL_INCR_WRAP, GL_KEEP, GL_KEEP, GL_DECR_WRAP}, kTable);
}

TEST(Task3ZPass, CountsEqualCrossings) {
    for (const char* scene : {"boxes@3", "fence@2"}) expectCounts(scene, kZPass);
    expectCounts("stairs@2", kZPass, kTouchingSteps);
}

TEST(Task3ZPass, VolumesLeaveDepthAlone) { expectDepthLeftAlone(kZPass); }

TEST(Task3ZPass, HundredsOfLayersWrapAround) { expectCounts(kHundredsOfLayers, kZPass); }

// --- Task 4: counting ---

TEST(Task4ZFail, BehindTheSurfaceABackCountsUpAndAFrontDown) {
    const std::vector<int> mine = countingTable(1);
    expectEqualLists("depthTest, writesDepth", {mine[0], mine[1]}, {GL_LESS, 0}, kTable);
    expectEqualLists("front and back of zFailCounting()", {mine.begin() + 2, mine.end()},
                     {GL_KEEP, GL_DECR_WRAP, GL_KEEP, GL_KEEP, GL_INCR_WRAP, GL_KEEP}, kTable);
}

TEST(Task4ZFail, VolumesLeaveDepthAlone) { expectDepthLeftAlone(kZFail); }

TEST(Task4ZFail, CountsEqualCrossings) {
    expectCounts("boxes@3", kZFail);
    expectCounts("stairs@2", kZFail, kTouchingSteps);
}

TEST(Task4ZFail, TheEyeMayStandInAVolume) {
    for (const char* scene : {"eye_inside", "eye_inside@2"}) expectCounts(scene, kZFail);
}

TEST(Task4ZFail, AVolumeMayCutTheNearPlane) {
    for (const char* scene : {"near_cut", "near_cut@2"}) expectCounts(scene, kZFail);
}

TEST(Task4ZFail, TheSunNeedsNoFarCap) {
    expectCounts("sun", kZFail);
    const Stage stage = staged({box({-1, -1, -1}, {1, 1, 1}, 0)}, {sunFrom({1, 3, 2})});
    const MeshLists lists = listsOf(stage, kZFail)[0];
    const auto far = [](const VolumeTriangle& t) { return t[0].far || t[1].far || t[2].far; };
    EXPECT_VALUE(std::count_if(lists.outwardCaps.begin(), lists.outwardCaps.end(), far), Equal, 0,
                 "all twins are one point: nothing to close");
}

TEST(Task4ZFail, HundredsOfLayersWrapAround) { expectCounts(kHundredsOfLayers, kZFail); }

// --- Task 4: caps ---

// The list, each triangle turned so that its smallest corner comes first: rotation is free.
std::vector<VolumeTriangle> turned(std::vector<VolumeTriangle> triangles) {
    for (VolumeTriangle& t : triangles)
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

int missing(const std::vector<VolumeTriangle>& wanted, const std::vector<VolumeTriangle>& list) {
    std::vector<VolumeTriangle> result;
    const auto a = turned(wanted), b = turned(list);
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return int(result.size());
}

struct Caps {
    std::vector<VolumeTriangle> near, turnedNear, far;  // of weights 1, of weights -1, of both
};

Caps capsOf(const Mesh& mesh, const MeshLists& lists) {
    Caps caps;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        VolumeTriangle near, far;
        for (int k = 0; k < 3; ++k) {
            const int vertex = int(lists.edges.welded[mesh.triangles[i][k]]);
            near[std::size_t(k)] = {vertex, false}, far[std::size_t(k)] = {vertex, true};
        }
        if (lists.weights[i] == 0) continue;
        (lists.weights[i] > 0 ? caps.near : caps.turnedNear).push_back(near);
        if (lists.weights[i] > 0) std::swap(far[1], far[2]);
        caps.far.push_back(far);
    }
    return caps;
}

std::vector<VolumeTriangle> both(std::vector<VolumeTriangle> a,
                                 const std::vector<VolumeTriangle>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

TEST(Task4ZFail, CapsCloseBothEnds) {
    // Closed, open and facing, open and averted.
    const Mesh sheet = triangleMesh({{0, 2, 0}, {0, 2, 1}, {1, 2, 0}});
    const Stage stage = staged({potato(3), sheet, insideOut(sheet)}, {lampAt({0.4f, 4, 0.8f})});
    const std::vector<MeshLists> lists = listsOf(stage, kZFail);
    for (std::size_t i = 0; i < lists.size(); ++i) {
        const Caps caps = capsOf(stage.scene.meshes[i], lists[i]);
        const auto wanted = both(caps.near, caps.far);
        if (i == 0) EXPECT_VALUE(wanted.size(), Greater, 0, "some triangles face the light");
        EXPECT_VALUE(missing(caps.near, lists[i].outwardCaps), Equal, 0,
                     "near caps: triangles that face the light, as they are");
        EXPECT_VALUE(missing(caps.far, lists[i].outwardCaps), Equal, 0,
                     "far caps: their twins, facing away from the light");
        EXPECT_VALUE(missing(caps.turnedNear, lists[i].inwardCaps), Equal, 0,
                     "near caps of averted triangles: as they are, inward");
        EXPECT_VALUE(
            missing(lists[i].outwardCaps, wanted) + missing(lists[i].inwardCaps, caps.turnedNear),
            Equal, 0, "other caps");
    }
}

// Hundreds of lit facets, near and far, some edge-on: where a cap's depth is off by a bit, the
// count is off by one.
TEST(Task4ZFail, CapsHaveTheDepthOfTheirSurface) {
    Scene scene;
    scene.name = "bumps";
    scene.materials = {{.name = "grey"}};
    for (int i = 0; i < 12; ++i) {
        Mesh bump = potato(unsigned(i));
        for (vec3& p : bump.positions)
            p = 0.9f * p + vec3(float(i % 3) - 1.0f, 0.1f * float(i), -1.37f * float(i));
        scene.meshes.push_back(bump);
    }
    scene.lights = {lampAt({2.3f, 9.1f, 3.7f})};
    scene.camera = {.eye = {0.3f, 1.9f, 2.7f},
                    .target = {0, 0.6f, -5},
                    .verticalFov = 0.9f,
                    .nearPlane = 0.001f,
                    .farPlane = 1000.0f};
    expectCounts(sceneFile(scene), kZFail);
}

// --- Task 4: projection ---

glm::dmat4 projectionOf(float verticalFov, float nearPlane, glm::ivec2 size) {
    Scene scene = loadScene("boxes");
    scene.camera.verticalFov = verticalFov;
    scene.camera.nearPlane = nearPlane;
    scene.camera.farPlane = 1e5f * nearPlane;
    const Rendered frame =
        render({.scene = sceneFile(scene), .size = size, .images = {{"clip_from_view", {4, 4}}}});
    glm::dmat4 m;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            m[column][row] = frame.at("clip_from_view").at(column, row);
    return m;
}

TEST(Task4ZFail, TheProjectionHasNoFarPlane) {
    for (const auto& [fov, nearPlane, size] :
         {std::tuple{0.7f, 0.1f, glm::ivec2(32, 16)}, std::tuple{1.9f, 0.0005f, glm::ivec2(16, 40)},
          std::tuple{0.2f, 250.0f, glm::ivec2(16, 16)}}) {
        const glm::dmat4 m = projectionOf(fov, nearPlane, size);
        const double scale = 1.0 / std::tan(0.5 * double(fov));
        glm::dmat4 truth(0.0);
        truth[0][0] = scale * size.y / size.x, truth[1][1] = scale;
        truth[2][2] = truth[2][3] = -1, truth[3][2] = -2.0 * double(nearPlane);
        Rows mine, exact;
        for (int column = 0; column < 4; ++column) {
            mine.emplace_back(m[column]);
            exact.emplace_back(truth[column]);
        }
        EXPECT_ROWS_NEAR(mine, exact,
                         {.absolute = 0,
                          .relative = 1e-6,
                          .components = 4,
                          .cause = "float32 tangent and quotients; 0 and -1 are exact"});
    }
}

TEST(Task4ZFail, PointsAtInfinityLieInTheClipVolume) {
    const glm::mat4 m(projectionOf(0.9f, 0.03f, {16, 16}));
    Dice dice{std::mt19937(41)};
    int outside = 0, before = 0;
    for (int i = 0; i < 512; ++i) {
        const vec4 direction(dice(-1, 1), dice(-1, 1), dice(-2, -0.01), 0);
        const vec4 clip = m * direction;  // in float32, as the vertex shader has it
        outside += !(clip.z <= clip.w && clip.z >= -clip.w && clip.w > 0);
        const vec4 far = m * vec4(1e4f * vec3(direction), 1.0f);
        before += !(far.z <= far.w);
    }
    EXPECT_VALUE(outside, Equal, 0, "-w <= z <= w for w = 0 in front of the eye, to the bit");
    EXPECT_VALUE(before, Equal, 0, "and for every finite point, however far");
}

}  // namespace
}  // namespace penumbra
