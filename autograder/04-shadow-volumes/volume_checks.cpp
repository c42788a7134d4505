#include "volume_checks.h"

#include <algorithm>
#include <map>

namespace penumbra {

// --- Scenes ---

Light lampAt(vec3 center) { return Light::lookingAt(center, center - vec3(0, 1, 0), 0.5f); }

Light sunFrom(vec3 direction) {
    Light light = Light::lookingAt(direction, vec3(0.0f), 0.5f);
    light.directional = true;
    return light;
}

Stage staged(Scene scene) {
    const std::string file = sceneFile(scene);
    return {loadScene(file), file};
}

Stage staged(std::vector<Mesh> meshes, std::vector<Light> lights) {
    Scene scene;
    scene.name = "meshes of a check";
    scene.materials = {{.name = "grey"}};
    scene.meshes = std::move(meshes);
    scene.lights = std::move(lights);
    const Box box = bounds(scene);
    scene.camera = {.eye = box.center() + vec3(0, 0.5f, 2) * box.diagonal(),
                    .target = box.center(),
                    .nearPlane = 0.01f * box.diagonal(),
                    .farPlane = 10.0f * box.diagonal()};
    return staged(std::move(scene));
}

Mesh triangleMesh(const std::vector<vec3>& corners) {
    Mesh mesh;
    mesh.positions = corners;
    for (unsigned i = 0; i + 2 < corners.size(); i += 3) {
        mesh.triangles.emplace_back(i, i + 1, i + 2);
        const vec3 n = glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
        mesh.normals.insert(mesh.normals.end(), 3,
                            glm::length(n) > 0 ? glm::normalize(n) : vec3(0, 1, 0));
    }
    return mesh;
}

Mesh potato(unsigned seed) {
    Mesh mesh = sphere(vec3(0.0f), 1.0f, 6, 0);
    for (vec3& p : mesh.positions) {
        const float bump = std::sin(2.3f * p.x + float(seed)) + std::sin(3.1f * p.y - p.z);
        p = glm::round(1024 * (0.7f + 0.15f * bump) * p) / 1024.0f;
    }
    return mesh;
}

Mesh insideOut(Mesh mesh) {
    for (glm::uvec3& t : mesh.triangles) std::swap(t.y, t.z);
    return mesh;
}

Mesh withoutTriangle(Mesh mesh, std::size_t triangle) {
    mesh.triangles.erase(mesh.triangles.begin() + std::ptrdiff_t(triangle));
    return mesh;
}

// --- Lists ---

namespace {

// `count` numbers of a list that starts at `first`.
std::vector<int> slice(const Image& list, std::size_t first, std::size_t count) {
    std::vector<int> result;
    for (std::size_t i = first; i < first + count; ++i)
        result.push_back(i < list.pixels.size() ? int(list.pixels[i]) : 0);
    return result;
}

void addVolumeTriangles(const Image& list, std::vector<MeshLists>& meshes) {
    if (list.channels != 4) return;  // an empty list
    for (std::size_t i = 0; i + 12 <= list.pixels.size(); i += 12) {
        const float* const values = &list.pixels[i];
        MeshLists& mesh = meshes.at(std::size_t(values[0]));
        VolumeTriangle triangle;
        for (std::size_t k = 0; k < 3; ++k)
            triangle[k] = {int(mesh.edges.welded.at(std::size_t(values[4 * k + 1]))),
                           values[4 * k + 2] > 0};
        const bool padding = triangle[0] == triangle[1] && triangle[1] == triangle[2];
        if (padding) continue;
        const int kind = int(values[3]);
        (kind == 0   ? mesh.sides
         : kind == 1 ? mesh.outwardCaps
                     : mesh.inwardCaps)
            .push_back(triangle);
    }
}

}  // namespace

std::vector<MeshLists> listsOf(const Stage& stage, const SettingList& settings) {
    const glm::ivec2 any{0, 0};
    const Rendered frame = render({.scene = stage.file,
                                   .size = {16, 16},
                                   .settings = settings,
                                   .images = {{"facing", any},
                                              {"weights", any},
                                              {"edge_sums", any},
                                              {"mesh_kinds", any},
                                              {"volume_triangles", any}}});
    std::vector<MeshLists> meshes;
    std::size_t triangle = 0, edge = 0;
    for (const Mesh& mesh : stage.scene.meshes) {
        MeshLists lists;
        lists.edges = meshEdges(mesh);
        const std::size_t triangles = mesh.triangles.size(), edges = lists.edges.edges.size();
        lists.facing = slice(frame.at("facing"), triangle, triangles);
        lists.weights = slice(frame.at("weights"), triangle, triangles);
        lists.edgeSums = slice(frame.at("edge_sums"), edge, edges);
        lists.kind = slice(frame.at("mesh_kinds"), meshes.size(), 1)[0];
        triangle += triangles, edge += edges;
        meshes.push_back(std::move(lists));
    }
    addVolumeTriangles(frame.at("volume_triangles"), meshes);
    return meshes;
}

void expectEqualLists(const char* subject, const std::vector<int>& mine,
                      const std::vector<int>& truth, const std::string& cause) {
    const auto rows = [](const std::vector<int>& list) {
        Rows result;
        for (const int value : list) result.emplace_back(float(value));
        return result;
    };
    expectRowsNear(subject, rows(mine), rows(truth),
                   {.absolute = 0, .relative = 0, .components = 1, .cause = cause});
}

std::vector<int> sidesOfLight(const Mesh& mesh, vec4 light) {
    std::vector<int> signs;
    const auto& p = mesh.positions;
    for (const glm::uvec3 t : mesh.triangles)
        signs.push_back(orientation(p[t.x], p[t.y], p[t.z], light));
    return signs;
}

void addEdge(Boundary& boundary, VolumeCorner from, VolumeCorner to, int times, bool sunlit) {
    for (VolumeCorner* corner : {&from, &to})
        if (sunlit && corner->far) corner->vertex = 0;
    if (from == to) return;
    if (to < from) std::swap(from, to), times = -times;
    const auto entry = boundary.try_emplace({from, to}, 0).first;
    entry->second += times;
    if (entry->second == 0) boundary.erase(entry);
}

void addBoundary(Boundary& boundary, const std::vector<VolumeTriangle>& triangles, int times,
                 bool sunlit) {
    for (const VolumeTriangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) addEdge(boundary, t[k], t[(k + 1) % 3], times, sunlit);
}

int differences(const Boundary& mine, const Boundary& truth) {
    int count = 0;
    for (const auto& [edge, times] : truth) {
        const auto found = mine.find(edge);
        count += found == mine.end() || found->second != times;
    }
    for (const auto& [edge, times] : mine) count += !truth.contains(edge);
    return count;
}

// --- Counts ---

namespace {

// Counting is the dearest truth, and several checks ask for the same scene.
const VolumeCount& countsOf(const std::string& name) {
    static std::map<std::string, VolumeCount> known;
    const auto found = known.find(name);
    if (found != known.end()) return found->second;
    return known[name] = TracedScene(loadScene(name), {kCountSize, kCountSize}).volumeCount();
}

}  // namespace

void expectCounts(const std::string& scene, const SettingList& settings,
                  const CountTolerance& tolerance) {
    SettingList all{"cull_range=off", "scissor=off"};  // else no count where the light is too far
    all.insert(all.end(), settings.begin(), settings.end());
    const Rendered frame = render({.scene = scene,
                                   .size = {kCountSize, kCountSize},
                                   .settings = all,
                                   .images = {"stencil_count"}});
    const VolumeCount& truth = countsOf(scene);
    const bool isFloat = std::find(all.begin(), all.end(), "counter=float") != all.end();
    Image exact = truth.count;
    for (float& count : exact.pixels)
        if (!isFloat) count = float(int(count) & 255);
    const auto decidable =
        std::count(truth.decidable.pixels.begin(), truth.decidable.pixels.end(), 1.0f);
    const bool ofTheCheck = scene.find('/') != std::string::npos;
    expectImageNear(
        ("stencil_count in " + (ofTheCheck ? std::string("the check's scene") : scene)).c_str(),
        frame.at("stencil_count"), exact,
        {.outliers = tolerance.mayDiffer / double(decidable),
         .outlierDistance = 0.5,
         .cause = tolerance.cause},
        truth.decidable);
}

// --- Pictures ---

double shareOfZeros(const Image& image) {
    return double(std::count(image.pixels.begin(), image.pixels.end(), 0.0f)) /
           double(image.pixels.size());
}

namespace {

bool sameSurface(const Receivers& r, std::size_t i, std::size_t k) {
    if (r.hit[i] != r.hit[k]) return false;
    if (!r.hit[i]) return true;
    const vec3 between = r.positions[k] - r.positions[i];
    return glm::dot(r.facetNormals[i], r.facetNormals[k]) > 0.9999f &&
           std::abs(glm::dot(r.facetNormals[i], between)) <= 1e-3f * glm::length(between);
}

}  // namespace

RayPicture::RayPicture(const Scene& scene, glm::ivec2 size) {
    const TracedScene traced(scene, size);
    receivers = traced.receivers();
    for (std::size_t light = 0; light < scene.lights.size(); ++light)
        visibility.push_back(traced.pointVisibility(light));
    const auto index = [&](int x, int y) {
        return std::size_t(y) * std::size_t(size.x) + std::size_t(x);
    };
    const auto inside = [&](int x, int y) {
        for (int py = std::max(0, y - 1); py <= std::min(size.y - 1, y + 1); ++py)
            for (int px = std::max(0, x - 1); px <= std::min(size.x - 1, x + 1); ++px) {
                if (!sameSurface(receivers, index(x, y), index(px, py))) return false;
                for (const Image& v : visibility)
                    if (v.at(x, y) != v.at(px, py)) return false;
            }
        return true;
    };
    interior = cached(TruthKey("interior", scene, size), [&] {
        Image mask(size.x, size.y, 1);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) mask.at(x, y) = inside(x, y) ? 1.0f : 0.0f;
        return mask;
    });
}

bool edgeAround(const Scene& scene, glm::ivec2 size, glm::ivec2 pixel, vec3 receiver) {
    const glm::dmat4 clipFromWorld =
        glm::dmat4(scene.camera.clipFromView(float(size.x) / float(size.y))) *
        glm::dmat4(scene.camera.viewFromWorld());
    const double distance = (clipFromWorld * dvec4(receiver, 1.0)).w;
    const glm::dvec2 center(pixel.x + 0.5, pixel.y + 0.5), half = 0.5 * glm::dvec2(size);
    const auto inPixels = [&](dvec4 clip) {
        return half * glm::dvec2(1.0 + clip.x / clip.w, 1.0 - clip.y / clip.w);
    };
    const auto passes = [&](vec3 from, vec3 to) {
        const dvec4 a = clipFromWorld * dvec4(from, 1.0), b = clipFromWorld * dvec4(to, 1.0);
        if (a.w <= 0 || b.w <= 0) return false;
        const glm::dvec2 p = inPixels(a), along = inPixels(b) - p;
        const double length = glm::dot(along, along);
        const double t =
            length > 0 ? glm::clamp(glm::dot(center - p, along) / length, 0.0, 1.0) : 0.0;
        // 1/w is linear on the screen.
        const double w = 1.0 / ((1.0 - t) / a.w + t / b.w);
        return glm::length(center - p - t * along) <= 1.0 && w <= 1.001 * distance;
    };
    for (const Mesh& mesh : scene.meshes)
        for (const glm::uvec3 t : mesh.triangles)
            for (int k = 0; k < 3; ++k)
                if (passes(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]])) return true;
    return false;
}

Image colorTruth(const Scene& scene, const RayPicture& rays) {
    constexpr float kAmbient = 0.22f;  // shading.glsl
    const Material& material = scene.materials[0];
    Image color(rays.receivers.width, rays.receivers.height, 3, 0.0f);
    for (std::size_t i = 0; i < rays.receivers.hit.size(); ++i) {
        if (!rays.receivers.hit[i]) continue;
        vec3 light(0.0f);
        for (std::size_t k = 0; k < scene.lights.size(); ++k) {
            const vec4 at = scene.lights[k].position();
            const vec3 towards = vec3(at) - at.w * rays.receivers.positions[i];
            const float distance = glm::length(towards);
            const float cosine = glm::dot(rays.receivers.facetNormals[i], towards) / distance;
            light += rays.visibility[k].pixels[i] * std::max(cosine, 0.0f) *
                     (at.w > 0 ? scene.lights[k].falloff(distance) : 1.0f) * scene.lights[k].color;
        }
        const vec3 c =
            material.emissive + material.baseColor * (kAmbient + (1.0f - kAmbient) * light);
        for (int channel = 0; channel < 3; ++channel)
            color.pixels[3 * i + std::size_t(channel)] = c[channel];
    }
    return color;
}

}  // namespace penumbra
