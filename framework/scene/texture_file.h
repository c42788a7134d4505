// PNG and JPEG files to and from the 8-bit textures of a scene.
//
//   Texture2D bark = decodeTexture(bytes, "bark.png");
//   std::vector<std::uint8_t> png = encodeTexture(bark);
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace penumbra {

// Throws Error that names `where` for bytes that are no picture, or one larger than 16384 a side.
Texture2D decodeTexture(std::span<const std::uint8_t> bytes, const std::string& where);

// As PNG, lossless.
std::vector<std::uint8_t> encodeTexture(const Texture2D& texture);

}  // namespace penumbra
