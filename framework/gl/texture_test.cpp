#include "gl/texture.h"

#include <cmath>

#include "gl/framebuffer.h"
#include "gl/test_context.h"

namespace penumbra {
namespace {

Image ramp(int width, int height, int channels) {
    Image image(width, height, channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = float(i) / float(image.pixels.size());
    return image;
}

class TextureTest : public testing::GlTest {};

TEST_F(TextureTest, FloatFormatsKeepEveryBit) {
    const std::pair<GLenum, int> formats[] = {
        {GL_R32F, 1}, {GL_RG32F, 2}, {GL_RGB32F, 3}, {GL_RGBA32F, 4}};
    for (const auto& [format, channels] : formats) {
        Texture texture({.size = {5, 3}, .format = format, .label = "ramp"});
        const Image image = ramp(5, 3, channels);
        texture.upload(image);
        EXPECT_EQ(texture.read().pixels, image.pixels) << channels;
    }
}

TEST_F(TextureTest, TheTopRowOfAnImageIsTheLastOfTheTexture) {
    Texture texture({.size = {2, 3}, .format = GL_R32F, .label = "rows"});
    Image image(2, 3, 1);
    image.at(0, 0) = 7;
    texture.upload(image);
    float values[6] = {};
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_FLOAT, values);
    EXPECT_EQ(values[4], 7.0f);
}

TEST_F(TextureTest, DepthFormatsKeepWhatTheirBitsHold) {
    const std::pair<GLenum, float> formats[] = {{GL_DEPTH_COMPONENT16, 0.5f / 65535},
                                                {GL_DEPTH_COMPONENT24, 1.0f / 16777215},
                                                {GL_DEPTH_COMPONENT32F, 0}};
    for (const auto& [format, step] : formats) {
        Texture texture({.size = {5, 3}, .format = format, .label = "depth"});
        EXPECT_TRUE(texture.isDepth());
        const Image image = ramp(5, 3, 1);
        texture.upload(image);
        const Image read = texture.read();
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            EXPECT_LE(std::abs(read.pixels[i] - image.pixels[i]), 1.0001f * step) << i;
    }
}

TEST_F(TextureTest, AClearedFramebufferReadsBack) {
    const Texture color({.size = {4, 4}, .format = GL_RGBA16F, .label = "color"});
    const Texture depth({.size = {4, 4}, .format = GL_DEPTH_COMPONENT32F, .label = "depth"});
    const Framebuffer target({.colors = {nullptr, &color}, .depth = &depth});
    target.clear({0.25f, 0.5f, 0.75f, 1.0f}, 0.125f);
    EXPECT_EQ(color.read().at(3, 3, 2), 0.75f);
    EXPECT_EQ(depth.read().at(0, 0), 0.125f);
}

TEST_F(TextureTest, ASizeThatCannotBeIsAnError) {
    EXPECT_THROW(Texture({.size = {0, 4}, .label = "flat"}), Error);
    EXPECT_THROW(Texture({.size = {1 << 30, 1}, .label = "wide"}), Error);
}

TEST_F(TextureTest, IsMovedNotCopied) {
    Texture a({.size = {1, 1}, .format = GL_R32F, .label = "a"});
    const GLuint id = a.id();
    const Texture b = std::move(a);
    EXPECT_EQ(b.id(), id);
    EXPECT_TRUE(glIsTexture(id));
}

TEST_F(TextureTest, DepthKeepsItsPlaceBesideAStencil) {
    for (const GLenum format : {GL_DEPTH24_STENCIL8, GL_DEPTH32F_STENCIL8}) {
        const Texture depth({.size = {4, 3}, .format = format, .label = "depth and stencil"});
        EXPECT_TRUE(depth.isDepth() && depth.hasStencil());
        const Framebuffer target({.depth = &depth});
        target.clear({}, 0.25f);
        target.clearStencil(7);
        EXPECT_NEAR(depth.read().at(2, 1), 0.25f, 1e-7);
        EXPECT_EQ(target.readStencil().at(2, 1), 7.0f);
        target.clear({}, 1.0f);
        EXPECT_EQ(target.readStencil().at(0, 0), 0.0f);
    }
}

TEST_F(TextureTest, TheTopRowOfAStencilImageIsTheFramebuffersLast) {
    const Texture depth({.size = {2, 3}, .format = GL_DEPTH24_STENCIL8, .label = "rows"});
    const Framebuffer target({.depth = &depth});
    target.clear({});
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 2, 2, 1);
    target.clearStencil(255);
    glDisable(GL_SCISSOR_TEST);
    EXPECT_EQ(target.readStencil().pixels, (std::vector<float>{255, 255, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace penumbra
