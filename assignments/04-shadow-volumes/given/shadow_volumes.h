// What given code calls of yours in C++.
//
// A shadow volume is a weighted sum of triangles' volumes. Every triangle has a weight: +1 it faces
// the light, -1 it is averted and turned round, 0 it has no part. An edge's sum of those weights,
// with the direction in which each triangle runs along it, says how often the volume has a side
// there.
//
// A mesh of n vertices has 2n vertices in a volume: v is the vertex itself, v + farOffset its twin,
// which your extruded() sends to infinity, away from the light. `light` is Light::position(): w = 1
// for a point light, w = 0 for a directional one.
#pragma once

#include <glad/gl.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/mesh_edges.h"
#include "scene/orientation.h"
#include "scene/scene.h"

namespace penumbra {

// What happens to a pixel's stencil value: as glStencilOp takes them.
struct StencilOperations {
    GLenum stencilFail = GL_KEEP, depthFail = GL_KEEP, pass = GL_KEEP;
};

// How volumes are drawn, both sides of every triangle in one pass.
struct StencilCounting {
    GLenum depthTest = GL_LESS;  // a fragment passes if its depth is … the stored one
    bool writesDepth = false;
    StencilOperations front, back;  // counter-clockwise triangles on the screen, and clockwise ones
};

// Triangles of a volume, as vertex numbers.
struct VolumeTriangles {
    std::vector<glm::uvec3> outward;  // counter-clockwise seen from outside of the volume
    std::vector<glm::uvec3>
        inward;  // the other way: drawn with front and back operations exchanged
};

// How one light's share is added to the picture.
struct LightPass {
    bool clearsStencil = false;  // to 0, before this light's volumes are counted
    GLenum depthTest = GL_EQUAL;
    bool writesDepth = false;
    GLenum stencilTest = GL_ALWAYS;  // a fragment passes if stencilReference is … the stored value
    int stencilReference = 0;
    GLenum source = GL_ZERO, destination = GL_ONE;  // blend factors, as glBlendFunc takes them
};

// silhouette.cpp
std::vector<int> facingTriangles(const Mesh& mesh, glm::vec4 light);
std::vector<int> edgeSums(const MeshEdges& edges, std::span<const int> weights);

// z_pass.cpp, z_fail.cpp, projection.cpp
StencilCounting zPassCounting();
StencilCounting zFailCounting();
void appendCaps(glm::uvec3 triangle, int weight, std::uint32_t farOffset, bool directional,
                VolumeTriangles& caps);
glm::mat4 infiniteProjection(float verticalFov, float aspect, float nearPlane);

// sides.cpp
void appendSide(std::uint32_t from, std::uint32_t to, std::uint32_t farOffset, bool directional,
                std::vector<glm::uvec3>& sides);

// open_meshes.cpp
bool needsAllTriangles(const Mesh& mesh, const MeshEdges& edges, glm::vec4 light);
std::vector<int> allTriangles(const Mesh& mesh, glm::vec4 light);

// several_lights.cpp
LightPass addLight();

}  // namespace penumbra
