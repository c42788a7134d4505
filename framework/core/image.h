// A float image in memory and on disk: what techniques render, truth computes and checks compare.
//
//   Image visibility(512, 512, 1);
//   visibility.at(x, y) = 1.0f;
//   saveExr(out / "visibility.exr", visibility);
#pragma once

#include <filesystem>
#include <vector>

namespace penumbra {

// Row 0 is the top row, as in files (OpenGL's read-back is flipped once, in gl/texture.cpp).
// Channels are interleaved; 1 to 4 of them.
struct Image {
    Image() = default;
    Image(int width, int height, int channels, float value = 0.0f);

    float& at(int x, int y, int channel = 0);
    float at(int x, int y, int channel = 0) const;
    std::size_t pixelCount() const { return std::size_t(width) * std::size_t(height); }
    bool empty() const { return pixels.empty(); }
    bool sameShape(const Image& other) const;

    int width = 0;
    int height = 0;
    int channels = 0;
    std::vector<float> pixels;
};

// Number of values that are infinite or not a number.
std::size_t nonFiniteCount(const Image& image);

// 32-bit float OpenEXR, lossless; channel names Y, RG, RGB or RGBA. Written to a temporary name
// and renamed, so that a reader never sees half a file. Throws Error.
void saveExr(const std::filesystem::path& path, const Image& image);
Image loadExr(const std::filesystem::path& path);

enum class Encoding {
    linear,  // the value itself: visibility, depth, differences
    srgb,    // linear colour, gamma-encoded for display
};

// 8-bit PNG of values clamped to [0,1]. Two channels are written as red and green.
void savePng(const std::filesystem::path& path, const Image& image, Encoding encoding);

// The bytes of that PNG, for pages that carry their own pictures.
std::vector<unsigned char> encodePng(const Image& image, Encoding encoding);

// Blue (negative), white (zero), red (positive): `difference` is mine - truth, in [-1,1].
Image falseColorDifference(const Image& mine, const Image& truth);

}  // namespace penumbra
