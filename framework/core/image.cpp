#include "core/image.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include "core/error.h"

namespace penumbra {

namespace {

const char* const kChannelNames[4][4] = {{"Y"}, {"R", "G"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};

std::filesystem::path temporaryName(const std::filesystem::path& path) {
    return std::filesystem::path(path).concat(".part");
}

std::uint8_t toByte(float value, Encoding encoding) {
    float v = std::isfinite(value) ? std::clamp(value, 0.0f, 1.0f) : 0.0f;
    if (encoding == Encoding::srgb)
        v = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
    return std::uint8_t(std::lround(255.0f * v));
}

Imf::FrameBuffer frameBuffer(Image& image) {
    Imf::FrameBuffer buffer;
    const std::size_t xStride = sizeof(float) * std::size_t(image.channels);
    for (int c = 0; c < image.channels; ++c)
        buffer.insert(kChannelNames[image.channels - 1][c],
                      Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(image.pixels.data() + c),
                                 xStride, xStride * std::size_t(image.width)));
    return buffer;
}

}  // namespace

Image::Image(int width, int height, int channels, float value)
    : width(width), height(height), channels(channels) {
    EXPECTS(width > 0 && height > 0 && channels >= 1 && channels <= 4);
    pixels.assign(pixelCount() * std::size_t(channels), value);
}

float& Image::at(int x, int y, int channel) {
    return pixels[(std::size_t(y) * std::size_t(width) + std::size_t(x)) * std::size_t(channels) +
                  std::size_t(channel)];
}

float Image::at(int x, int y, int channel) const {
    return const_cast<Image*>(this)->at(x, y, channel);
}

bool Image::sameShape(const Image& other) const {
    return width == other.width && height == other.height && channels == other.channels;
}

std::size_t nonFiniteCount(const Image& image) {
    return std::size_t(std::count_if(image.pixels.begin(), image.pixels.end(),
                                     [](float v) { return !std::isfinite(v); }));
}

void saveExr(const std::filesystem::path& path, const Image& image) {
    EXPECTS(!image.empty());
    const auto part = temporaryName(path);
    try {
        Imf::Header header(image.width, image.height);
        header.compression() = Imf::ZIP_COMPRESSION;
        for (int c = 0; c < image.channels; ++c)
            header.channels().insert(kChannelNames[image.channels - 1][c],
                                     Imf::Channel(Imf::FLOAT));
        Imf::OutputFile file(part.string().c_str(), header);
        file.setFrameBuffer(frameBuffer(const_cast<Image&>(image)));
        file.writePixels(image.height);
    } catch (const std::exception& e) {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        throw Error("cannot write image", path.string(), e.what());
    }
    std::filesystem::rename(part, path);
}

Image loadExr(const std::filesystem::path& path) {
    try {
        Imf::InputFile file(path.string().c_str());
        const auto window = file.header().dataWindow();
        const auto& channels = file.header().channels();
        const int count = channels.findChannel("A")   ? 4
                          : channels.findChannel("B") ? 3
                          : channels.findChannel("G") ? 2
                                                      : 1;
        if (count == 1 && !channels.findChannel("Y"))
            throw std::runtime_error("it has neither a Y channel nor R and G");
        Image image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, count);
        if (window.min.x != 0 || window.min.y != 0)
            throw std::runtime_error("its data window does not start at 0, 0");
        file.setFrameBuffer(frameBuffer(image));
        file.readPixels(window.min.y, window.max.y);
        return image;
    } catch (const std::exception& e) {
        throw Error("cannot read image", path.string(), e.what());
    }
}

std::vector<unsigned char> encodePng(const Image& image, Encoding encoding) {
    EXPECTS(!image.empty());
    const int channels = image.channels == 2 ? 3 : image.channels;
    std::vector<std::uint8_t> bytes(image.pixelCount() * std::size_t(channels));
    for (std::size_t i = 0; i < image.pixelCount(); ++i)
        for (int c = 0; c < image.channels; ++c)
            bytes[i * std::size_t(channels) + std::size_t(c)] =
                toByte(image.pixels[i * std::size_t(image.channels) + std::size_t(c)],
                       c == 3 ? Encoding::linear : encoding);
    std::vector<unsigned char> png;
    stbi_write_png_to_func(
        [](void* context, void* data, int size) {
            const auto* from = static_cast<unsigned char*>(data);
            static_cast<std::vector<unsigned char>*>(context)->insert(
                static_cast<std::vector<unsigned char>*>(context)->end(), from, from + size);
        },
        &png, image.width, image.height, channels, bytes.data(), image.width * channels);
    return png;
}

void savePng(const std::filesystem::path& path, const Image& image, Encoding encoding) {
    const auto png = encodePng(image, encoding);
    const auto part = temporaryName(path);
    std::ofstream file(part, std::ios::binary);
    file.write(reinterpret_cast<const char*>(png.data()), std::streamsize(png.size()));
    file.close();
    if (!file)
        throw Error("cannot write image", path.string(), "check that the folder is writable");
    std::filesystem::rename(part, path);
}

Image falseColorDifference(const Image& mine, const Image& truth) {
    EXPECTS(mine.sameShape(truth) && mine.channels == 1);
    Image color(mine.width, mine.height, 3);
    for (std::size_t i = 0; i < mine.pixels.size(); ++i) {
        const float d = std::clamp(mine.pixels[i] - truth.pixels[i], -1.0f, 1.0f);
        color.pixels[3 * i + 0] = d < 0 ? 1 + d : 1.0f;
        color.pixels[3 * i + 1] = 1 - std::abs(d);
        color.pixels[3 * i + 2] = d > 0 ? 1 - d : 1.0f;
    }
    return color;
}

}  // namespace penumbra
