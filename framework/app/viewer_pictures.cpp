#include "app/viewer_pictures.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace penumbra {

namespace {

constexpr int kLargestInset = 768;  // pixels: an enlarged inset fills a usual window's height

void fit(Texture& texture, glm::ivec2 size, GLenum format, const char* label) {
    if (texture.id() == 0 || texture.size() != size)
        texture = Texture({.size = size, .format = format, .label = label});
}

// A frame's image as a texture; images from the CPU are uploaded into `scratch`.
const Texture* find(const Frame& frame, const std::string& name, Texture& scratch) {
    if (const auto it = frame.textures().find(name); it != frame.textures().end())
        return it->second;
    const auto it = frame.images().find(name);
    if (it == frame.images().end()) return nullptr;
    const Image& image = it->second;
    constexpr GLenum kFormats[] = {GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F};
    scratch = Texture({.size = {image.width, image.height},
                       .format = kFormats[image.channels - 1],
                       .label = name});
    scratch.upload(image);
    return &scratch;
}

const Texture& required(const Texture* texture, const char* name) {
    if (!texture)
        throw Error(std::string("no image named '") + name + "'", "this assignment's frame",
                    "hand it over with frame.output()");
    return *texture;
}

bool oneChannel(const Texture& texture) {
    const GLenum format = texture.format();
    return texture.isDepth() || format == GL_R8 || format == GL_R16F || format == GL_R32F;
}

// 1 is left out: in depth images it is where nothing was drawn.
glm::vec2 rangeOf(const Image& image) {
    glm::vec2 range(1e30f, -1e30f);
    for (const float v : image.pixels)
        if (std::isfinite(v) && v != 1.0f) range = {std::min(range.x, v), std::max(range.y, v)};
    return range.x < range.y ? range : glm::vec2(0, 1);
}

}  // namespace

Pictures::Pictures(const Layers& layers) : shaders_(layers) {
    glGenVertexArrays(1, &vertexArray_);
    // Whatever a technique set on its textures (comparison, filtering): here they are read as they
    // are.
    glGenSamplers(1, &sampler_);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glSamplerParameteri(sampler_, wrap, GL_CLAMP_TO_EDGE);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glSamplerParameteri(sampler_, filter, GL_NEAREST);
}

Pictures::~Pictures() {
    glDeleteSamplers(1, &sampler_);
    glDeleteVertexArrays(1, &vertexArray_);
}

void Pictures::draw(const Texture& target, const Program& program, const Texture& image) const {
    const Framebuffer framebuffer({.colors = {&target}});
    framebuffer.bind();
    for (const GLenum state : {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_STENCIL_TEST})
        glDisable(state);
    program.texture("image", 0, image);
    glBindSampler(0, sampler_);
    glBindSampler(1, sampler_);
    glBindVertexArray(vertexArray_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindSampler(0, 0);
    glBindSampler(1, 0);
}

void Pictures::drawColor(const Texture& target, const Texture& image, bool encode) {
    const Program& program = shaders_.program("viewer_full.vert", "viewer_color.frag");
    program.use();
    program.set("encode", int(encode));
    draw(target, program, image);
}

void Pictures::drawGrey(const Texture& target, const Texture& image, glm::vec2 range) {
    const Program& program = shaders_.program("viewer_full.vert", "viewer_grey.frag");
    program.use();
    program.set("range", range);
    draw(target, program, image);
}

void Pictures::take(const Frame& frame, const std::string& inset) {
    Texture colorScratch, visibilityScratch;
    const Texture& color = required(find(frame, "color", colorScratch), "color");
    const Texture& visibility =
        required(find(frame, "visibility", visibilityScratch), "visibility");
    fit(color_, color.size(), GL_RGBA8, "picture");
    drawColor(color_, color, true);
    fit(visibility_, visibility.size(), GL_R32F, "shown visibility");
    drawGrey(visibility_, visibility, {0, 1});
    takeInset(frame, inset);
}

void Pictures::takeInset(const Frame& frame, const std::string& name) {
    Texture scratch;
    const Texture* image = name.empty() ? nullptr : find(frame, name, scratch);
    if (!image) {
        inset_ = Texture();
        return;
    }
    const glm::vec2 full(image->size());
    const float scale = std::min(1.0f, float(kLargestInset) / std::max(full.x, full.y));
    const glm::ivec2 size = glm::max(glm::ivec2(scale * full), glm::ivec2(1));
    fit(inset_, size, GL_RGBA8, "inset");
    insetRange_ = {0, 1};
    if (!oneChannel(*image)) {
        drawColor(inset_, *image, name == "color");
        return;
    }
    fit(values_, size, GL_R32F, "inset values");
    drawGrey(values_, *image, {0, 1});
    insetRange_ = rangeOf(values_.read());
    drawGrey(inset_, values_, insetRange_);
}

void Pictures::setTruth(const Image& truth) {
    fit(truth_, {truth.width, truth.height}, GL_R32F, "truth");
    truth_.upload(truth);
}

const Texture& Pictures::compose(PictureView view, float divider) {
    if (view == PictureView::picture || !ready()) return color_;
    const glm::ivec2 size = visibility_.size();
    fit(shown_, size, GL_RGBA8, "shown picture");
    Framebuffer({.colors = {&shown_}}).clear(glm::vec4(0.3f, 0.3f, 0.3f, 1.0f));
    const bool mine = view == PictureView::visibility || view == PictureView::split;
    if (mine) drawGrey(shown_, visibility_, {0, 1});
    if (!hasTruth() || view == PictureView::visibility) return shown_;
    if (view == PictureView::difference) {
        const Program& program = shaders_.program("viewer_full.vert", "viewer_difference.frag");
        program.use();
        program.texture("truth", 1, truth_);
        draw(shown_, program, visibility_);
        return shown_;
    }
    if (view == PictureView::split) {
        const int left = int(divider * float(size.x));
        glEnable(GL_SCISSOR_TEST);
        glScissor(left, 0, size.x - left, size.y);
    }
    drawGrey(shown_, truth_, {0, 1});
    glDisable(GL_SCISSOR_TEST);
    return shown_;
}

}  // namespace penumbra
