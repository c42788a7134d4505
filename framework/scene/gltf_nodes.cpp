#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "scene/gltf_parts.h"

namespace penumbra {

namespace {

glm::dmat4 parentFromNode(const GltfValue& node) {
    if (const auto matrix = node.find("matrix")) {
        double m[16];
        matrix->numbers(m, 16);
        if (m[3] != 0.0 || m[7] != 0.0 || m[11] != 0.0 || m[15] != 1.0)
            matrix->fail("is not affine");
        glm::dmat4 result;
        for (int k = 0; k < 16; ++k) result[k / 4][k % 4] = m[k];
        return result;
    }
    double t[3] = {0, 0, 0}, r[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
    if (const auto translation = node.find("translation")) translation->numbers(t, 3);
    if (const auto scale = node.find("scale")) scale->numbers(s, 3);
    glm::dmat4 result(1.0);
    if (const auto rotation = node.find("rotation")) {
        rotation->numbers(r, 4);
        const double length = std::hypot(std::hypot(r[0], r[1]), std::hypot(r[2], r[3]));
        if (!(length > 1e-9 && length < 1e9)) rotation->fail("is not a unit quaternion");
        result =
            glm::mat4_cast(glm::dquat(r[3] / length, r[0] / length, r[1] / length, r[2] / length));
    }
    for (int k = 0; k < 3; ++k) result[k] *= s[k];
    result[3] = glm::dvec4(t[0], t[1], t[2], 1.0);
    return result;
}

constexpr std::size_t kNone = std::size_t(-1);

std::vector<std::size_t> readParents(const GltfValue& nodes) {
    std::vector<std::size_t> parents(nodes.size(), kNone);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto children = nodes.item(i).find("children");
        for (std::size_t k = 0; children && k < children->size(); ++k) {
            const std::size_t child = children->item(k).index(nodes.size());
            if (parents[child] != kNone)
                children->item(k).fail(fmt::format("is node {}, a child twice", child));
            parents[child] = i;
        }
    }
    return parents;
}

// With one parent each, a cycle is a way up that never ends. Every node's way is followed once.
void checkForCycles(const GltfValue& nodes, const std::vector<std::size_t>& parents) {
    std::vector<std::size_t> visitedFrom(parents.size(), kNone);
    for (std::size_t start = 0; start < parents.size(); ++start)
        for (std::size_t i = start; i != kNone; i = parents[i]) {
            if (visitedFrom[i] == start) nodes.item(i).fail("is its own ancestor (a cycle)");
            if (visitedFrom[i] != kNone) break;
            visitedFrom[i] = start;
        }
}

std::vector<std::size_t> rootNodes(const GltfFile& file, const std::vector<std::size_t>& parents) {
    std::vector<std::size_t> roots;
    const GltfValue scenes = file.list("scenes");
    if (scenes.size() == 0) {
        for (std::size_t i = 0; i < parents.size(); ++i)
            if (parents[i] == kNone) roots.push_back(i);
        return roots;
    }
    const auto chosen = file.root().find("scene");
    const GltfValue scene = scenes.item(chosen ? chosen->index(scenes.size()) : 0);
    std::vector<bool> used(parents.size(), false);
    const auto list = scene.find("nodes");
    for (std::size_t i = 0; list && i < list->size(); ++i) {
        const std::size_t node = list->item(i).index(parents.size());
        if (parents[node] != kNone || used[node])
            list->item(i).fail(fmt::format("is node {}, which is used twice", node));
        used[node] = true;
        roots.push_back(node);
    }
    return roots;
}

}  // namespace

std::vector<GltfNode> readNodes(const GltfFile& file) {
    const GltfValue nodes = file.list("nodes");
    const auto parents = readParents(nodes);
    checkForCycles(nodes, parents);

    std::vector<GltfNode> result;
    for (const std::size_t root : rootNodes(file, parents)) result.push_back({root});
    // A queue instead of recursion: files may chain a hundred thousand nodes.
    for (std::size_t i = 0; i < result.size(); ++i) {
        const GltfValue node = nodes.item(result[i].index);
        result[i].worldFromNode = result[i].worldFromNode * parentFromNode(node);
        for (int k = 0; k < 16; ++k)
            if (!std::isfinite(result[i].worldFromNode[k / 4][k % 4]))
                node.fail("has a transform that is not finite");
        const auto children = node.find("children");
        for (std::size_t k = 0; children && k < children->size(); ++k)
            result.push_back({children->item(k).whole(), result[i].worldFromNode});
    }
    return result;
}

}  // namespace penumbra
