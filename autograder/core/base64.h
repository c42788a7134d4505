// Bytes as text (RFC 4648), for pictures inside a page.
#pragma once

#include <span>
#include <string>

namespace penumbra {

std::string base64(std::span<const unsigned char> bytes);

}  // namespace penumbra
