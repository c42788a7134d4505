#include "volume_pass.h"

#include <cstdlib>

namespace penumbra {

namespace {

bool zFails(const View& view) { return view.settings.chosen("method") == "zfail"; }

StencilCounting countingOf(const View& view) {
    return zFails(view) ? checkedCounting(zFailCounting(), "z_fail.cpp")
                        : checkedCounting(zPassCounting(), "z_pass.cpp");
}

VolumeKind kindOf(const View& view) {
    return view.settings.chosen("volumes") == "silhouette" ? VolumeKind::silhouette
                                                           : VolumeKind::perTriangle;
}

void beginOverlay(const CameraTargets& targets) {
    targets.framebuffer.bind();
    glDepthMask(GL_FALSE);
    glEnablei(GL_BLEND, 0);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);  // visibility stays
}

}  // namespace

VolumePass::VolumePass() { glGenVertexArrays(1, &emptyVertexArray_); }

VolumePass::~VolumePass() { glDeleteVertexArrays(1, &emptyVertexArray_); }

void VolumePass::prepare(const View& view, const glm::mat4& clipFromWorld) {
    if (!volumes_ || (revision_ != view.revision && !volumes_->isFor(view.scene)))
        volumes_ = std::make_unique<SceneVolumes>(view.scene);
    revision_ = view.revision;
    if (!view.settings.on("cache")) volumes_->forget();
    culling_ = std::make_unique<VolumeCulling>(view, clipFromWorld);
}

// A cap lies on its own surface and never before it, so z-pass can do without; not where the
// surface has holes, through which the cap is seen.
std::vector<LightVolumes::Part> VolumePass::parts(const View& view, const Light& light) const {
    std::vector<LightVolumes::Part> parts;
    for (std::size_t i = 0; i < view.scene.meshes.size(); ++i) {
        if (culling_->skips(i, light)) continue;
        const auto material = std::size_t(view.scene.meshes[i].material);
        const bool holes = view.scene.materials[material].alphaCutoff > 0;
        parts.push_back({.mesh = i, .caps = zFails(view) || holes});
    }
    return parts;
}

LightVolumes& VolumePass::volumesOf(const View& view, std::size_t index, const Light& light) {
    return volumes_->ofLight(index, light.position(), kindOf(view));
}

void VolumePass::count(const View& view, std::size_t index, const Light& light,
                       const CameraTargets& targets, const BindBlocks& bindBlocks) {
    const std::vector<LightVolumes::Part> drawn = parts(view, light);
    LightVolumes& volumes = volumesOf(view, index, light);
    const StencilCounting counting = countingOf(view);
    if (view.settings.chosen("counter") == "float") {
        countInFloat(view, counting, volumes, drawn, targets, bindBlocks);
        return;
    }
    const Program& program = view.shaders.program("volume.vert", "depth.frag");
    bindBlocks(program);
    program.use();
    volumes_->bind();
    beginCounting(counting);
    volumes.draw(drawn, [&] { beginCounting(exchanged(counting)); });
}

void VolumePass::countInFloat(const View& view, const StencilCounting& counting,
                              LightVolumes& volumes, const std::vector<LightVolumes::Part>& parts,
                              const CameraTargets& targets, const BindBlocks& bindBlocks) {
    if (floatCounts_.id() == 0 || floatCounts_.size() != view.size)
        floatCounts_ = Texture({.size = view.size, .format = GL_R32F, .label = "counts"});
    const Framebuffer framebuffer({.colors = {&floatCounts_}, .depth = &targets.depth});
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_SCISSOR_TEST);  // beyond the light's reach the count is 0, too
    framebuffer.clearColor(0, glm::vec4(0.0f));
    glEnable(GL_SCISSOR_TEST);
    const Program& program = view.shaders.program("volume.vert", "count_float.frag");
    bindBlocks(program);
    program.use();
    const auto begin = [&](const StencilCounting& stencil) {
        const FloatCounting steps = floatCounting(stencil);
        program.set("frontStep", steps.front);
        program.set("backStep", steps.back);
        glDepthFunc(steps.depthTest);
    };
    glDisable(GL_STENCIL_TEST);
    glDepthMask(counting.writesDepth);
    glEnablei(GL_BLEND, 0);
    glBlendFunc(GL_ONE, GL_ONE);
    begin(counting);
    volumes_->bind();
    volumes.draw(parts, [&] { begin(exchanged(counting)); });

    // From now on as if the stencil buffer had counted.
    const Program& counted = view.shaders.program("screen.vert", "counted.frag");
    targets.framebuffer.bind();
    beginCounting(
        {.depthTest = GL_ALWAYS, .front = {.pass = GL_REPLACE}, .back = {.pass = GL_REPLACE}});
    glStencilFunc(GL_ALWAYS, 1, 0xff);
    counted.use();
    counted.texture("counts", 0, floatCounts_);
    glBindVertexArray(emptyVertexArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

Image VolumePass::counts(const View& view, const CameraTargets& targets) const {
    return view.settings.chosen("counter") == "float" ? floatCounts_.read()
                                                      : targets.framebuffer.readStencil();
}

void VolumePass::showVolumes(const View& view, std::size_t index, const Light& light,
                             const CameraTargets& targets, const BindBlocks& bindBlocks) {
    const Program& program = view.shaders.program("volume.vert", "show_volume.frag");
    bindBlocks(program);
    program.use();
    program.set("inward", 0);
    beginOverlay(targets);
    glDepthFunc(GL_LESS);
    volumes_->bind();
    volumesOf(view, index, light).draw(parts(view, light), [&] { program.set("inward", 1); });
    endStencilPasses();
}

void VolumePass::showSilhouettes(const View& view, std::size_t index, const Light& light,
                                 const CameraTargets& targets, const BindBlocks& bindBlocks) {
    LightVolumes& volumes = volumesOf(view, index, light);
    std::vector<GLuint> once, oftener;  // ends of edges
    for (const LightVolumes::Part part : parts(view, light)) {
        const CasterMesh& caster = volumes_->casters()[part.mesh];
        const std::vector<int>& sums = volumes.ofMesh(part.mesh).sums;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            if (sums[i] == 0) continue;
            const MeshEdge& edge = caster.edges.edges[i];
            std::vector<GLuint>& lines = std::abs(sums[i]) == 1 ? once : oftener;
            lines.insert(lines.end(),
                         {caster.firstVertex + edge.from, caster.firstVertex + edge.to});
        }
    }
    const Program& program = view.shaders.program("volume.vert", "show_edge.frag");
    bindBlocks(program);
    program.use();
    beginOverlay(targets);
    glDepthFunc(GL_ALWAYS);
    volumes_->bind();
    program.set("color", glm::vec3(1.0f, 0.5f, 0.0f));
    volumes.drawLines(once);
    program.set("color", glm::vec3(1.0f, 0.0f, 0.1f));
    volumes.drawLines(oftener);
    endStencilPasses();
}

}  // namespace penumbra
