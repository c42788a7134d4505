#include "render/frame.h"

#include "core/error.h"

namespace penumbra {

std::map<std::string, Image> Frame::read() const {
    std::map<std::string, Image> result;
    for (const auto& [name, image] : images_)
        if (wants(name)) result[name] = image;
    for (const auto& [name, texture] : textures_)
        if (wants(name)) result[name] = texture->read();
    if (wanted_)
        for (const std::string& name : *wanted_)
            if (!result.count(name)) {
                std::string known;
                for (const auto& [other, texture] : textures_) known += " " + other;
                for (const auto& [other, image] : images_) known += " " + other;
                throw Error("no image named '" + name + "'", "this assignment's frame",
                            "it hands over:" + known);
            }
    // Textures that draw in four channels because three are not drawable everywhere.
    for (const char* name : {"color"})
        if (auto it = result.find(name); it != result.end() && it->second.channels == 4) {
            Image rgb(it->second.width, it->second.height, 3);
            for (std::size_t i = 0; i < rgb.pixelCount(); ++i)
                for (std::size_t c = 0; c < 3; ++c)
                    rgb.pixels[3 * i + c] = it->second.pixels[4 * i + c];
            it->second = std::move(rgb);
        }
    return result;
}

}  // namespace penumbra
