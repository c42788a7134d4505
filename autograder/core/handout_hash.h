// Whether a student has begun: a file whose code equals the handout's is "not started".
//
//   contentHash("float bias() { return 0.0; }  // yours") == contentHash("float bias(){return
//   0.0;}")
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace penumbra {

// The text without // and /* */ comments and without white space, so that neither counts as work.
std::string codeOnly(std::string_view source);

// 64-bit FNV-1a in hexadecimal: guards against accidents, not against forgers, who gain nothing.
std::string hashOf(std::string_view bytes);

std::string contentHash(std::string_view source);            // hashOf(codeOnly(source))
std::string contentHash(const std::filesystem::path& file);  // throws Error

}  // namespace penumbra
