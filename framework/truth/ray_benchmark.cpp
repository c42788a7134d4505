// Rays per second of areaVisibility against a bare loop over ready-made packets of the same kind.
//
//   penumbra-ray-benchmark [side] [samples] [repeats]     defaults: 192 64 9
//
// The bare loop is the most that Embree gives here: packets of 16 rays from one receiver to
// neighbouring light points, made beforehand, robust mode, same threads, nothing else in the loop.
// The share that areaVisibility keeps is what its sampling, horizon rule and counting cost.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <functional>

#include "truth/embree.h"
#include "truth/parallel.h"
#include "truth/strata.h"
#include "truth/test_scene.h"
#include "truth/visibility.h"

using namespace penumbra;

namespace {

// Globes in a field: 100 000 triangles, every kind of receiver, penumbrae on a third of the floor.
Scene field() {
    std::vector<Mesh> meshes{testing::floorSquare(24)};
    for (int z = -2; z <= 2; ++z)
        for (int x = -2; x <= 2; ++x)
            meshes.push_back(testing::globe({2.2f * float(x), 0.9f, 2.2f * float(z)}, 0.8f, 32));
    Scene scene = testing::sceneOf(std::move(meshes));
    scene.camera.eye = {0, 6, 9};
    scene.lights[0] = Light::lookingAt({4, 8, 3}, {0, 0, 0}, 1.5f);
    return scene;
}

struct BareScene {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene scene = rtcNewScene(device);

    explicit BareScene(const Scene& source) {
        rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        for (const Mesh& mesh : source.meshes) {
            RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
            auto* positions = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
                geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.positions.size()));
            auto* triangles = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
                geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size()));
            std::copy(mesh.positions.begin(), mesh.positions.end(), positions);
            std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
            rtcCommitGeometry(geometry);
            rtcAttachGeometry(scene, geometry);
            rtcReleaseGeometry(geometry);
        }
        rtcCommitScene(scene);
    }
    ~BareScene() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
};

// One row of pixels: 16 strata centres of one receiver a packet; `samples` is a multiple of 16.
// Points below the horizon are left out, as areaVisibility leaves them out: the same rays on both
// sides.
std::vector<RTCRay16> packets(const RayTracer& tracer, const Receivers& receivers,
                              const Light& light, int samples, int y) {
    const auto strata = makeStrata(samples);
    std::vector<RTCRay16> result;
    int lane = 16;
    for (int x = 0; x < receivers.width; ++x) {
        const std::size_t i = std::size_t(y * receivers.width + x);
        if (!receivers.hit[i]) continue;
        const glm::vec3 normal = receivers.facetNormals[i];
        const glm::vec3 start =
            receivers.positions[i] + tracer.startOffset(receivers.positions[i]) * normal;
        for (std::size_t k = 0; k < strata.size(); ++k) {
            const glm::vec3 along = light.point(strata.s[k] + 0.5f * strata.width[k],
                                                strata.t[k] + 0.5f * strata.height[k]) -
                                    start;
            if (glm::dot(along, normal) <= 0.0f) continue;
            if (lane == 16) lane = 0, result.emplace_back();
            RTCRay16& rays = result.back();
            rays.org_x[lane] = start.x, rays.org_y[lane] = start.y, rays.org_z[lane] = start.z;
            rays.dir_x[lane] = along.x, rays.dir_y[lane] = along.y, rays.dir_z[lane] = along.z;
            rays.tnear[lane] = 0.0f, rays.tfar[lane] = 1.0f;
            rays.mask[lane] = ~0u;
            ++lane;
        }
    }
    if (!result.empty())
        for (; lane < 16; ++lane) result.back().tnear[lane] = 1.0f, result.back().tfar[lane] = 0.0f;
    return result;
}

struct Cost {
    double wall, cpu;  // seconds
};

// Processor time of all threads beside the wall clock: on a busy machine only the former compares.
Cost cost(const std::function<void()>& work) {
    const std::clock_t cpu = std::clock();
    const auto start = std::chrono::steady_clock::now();
    work();
    const auto wall = std::chrono::steady_clock::now() - start;
    return {std::chrono::duration<double>(wall).count(),
            double(std::clock() - cpu) / double(CLOCKS_PER_SEC)};
}

struct Spread {
    double lowest, median, highest;
};

Spread spread(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return {values.front(), values[values.size() / 2], values.back()};
}

int argument(int count, char** values, int index, int otherwise) {
    return index < count ? std::max(1, std::atoi(values[index])) : otherwise;
}

}  // namespace

int main(int count, char** values) {
    const int side = argument(count, values, 1, 192);
    const int samples = (argument(count, values, 2, 64) + 15) / 16 * 16;
    const int repeats = argument(count, values, 3, 9);
    const Scene scene = field();
    const RayTracer tracer(scene);
    const Receivers receivers = tracer.receivers(scene.camera, {side, side});
    const BareScene bare(scene);
    std::vector<std::vector<RTCRay16>> rows;
    double rays = 0;
    for (int y = 0; y < side; ++y) {
        rows.push_back(packets(tracer, receivers, scene.lights[0], samples, y));
        for (const RTCRay16& packet : rows.back())
            for (int i = 0; i < 16; ++i) rays += packet.tfar[i] > 0.0f ? 1 : 0;
    }

    std::vector<double> bareRate, ourRate, ratio;
    std::atomic<long> blocked = 0;
    for (int i = 0; i < repeats; ++i) {
        auto fresh = rows;  // tracing overwrites tfar
        const Cost bareCost = cost([&] {
            parallelFor(side, [&](int y) {
                alignas(64) int valid[16];
                std::fill_n(valid, 16, -1);
                long sum = 0;
                for (RTCRay16& packet : fresh[std::size_t(y)]) {
                    embree::occluded16(valid, bare.scene, packet);
                    sum += packet.tfar[0] < 0.0f;
                }
                blocked += sum;
            });
        });
        const Cost ourCost =
            cost([&] { areaVisibility(tracer, receivers, scene.lights[0], samples); });
        bareRate.push_back(1e-6 * rays / bareCost.wall);
        ourRate.push_back(1e-6 * rays / ourCost.wall);
        ratio.push_back(bareCost.cpu / ourCost.cpu);
    }
    fmt::print(
        "{} triangles, {} x {} pixels, {} samples, {:.2f} M shadow rays, {} threads, {} runs\n",
        triangleCount(scene), side, side, samples, 1e-6 * rays, threadCount(), repeats);
    const auto line = [](const char* name, const char* unit, const Spread& s) {
        fmt::print("{:<16}{:7.2f} {:<8} ({:.2f} to {:.2f})\n", name, s.median, unit, s.lowest,
                   s.highest);
    };
    line("bare Embree", "Mray/s", spread(bareRate));
    line("areaVisibility", "Mray/s", spread(ourRate));
    line("ratio", "(CPU)", spread(ratio));
    return blocked >= 0 ? 0 : 1;
}
