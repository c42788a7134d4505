#include "core/handout_hash.h"

#include <fmt/format.h>

#include <cctype>
#include <cstdint>
#include <fstream>

#include "core/error.h"

namespace penumbra {

namespace {

// The end of the quoted text that starts at `i`: what stands between quotes is code, spaces
// included.
std::size_t endOfQuoted(std::string_view s, std::size_t i) {
    const char quote = s[i];
    for (++i; i < s.size() && s[i] != quote && s[i] != '\n'; ++i)
        if (s[i] == '\\') ++i;
    return std::min(i + 1, s.size());
}

}  // namespace

std::string codeOnly(std::string_view s) {
    std::string code;
    for (std::size_t i = 0; i < s.size();) {
        if (s.substr(i, 2) == "//") {
            i = std::min(s.find('\n', i), s.size());
        } else if (s.substr(i, 2) == "/*") {
            const auto end = s.find("*/", i + 2);
            i = end == std::string_view::npos ? s.size() : end + 2;
        } else if (s[i] == '"') {
            const auto end = endOfQuoted(s, i);
            code += s.substr(i, end - i);
            i = end;
        } else {
            if (!std::isspace(static_cast<unsigned char>(s[i]))) code += s[i];
            ++i;
        }
    }
    return code;
}

std::string hashOf(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return fmt::format("{:016x}", hash);
}

std::string contentHash(std::string_view source) { return hashOf(codeOnly(source)); }

std::string contentHash(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw Error("cannot read file", file.string(), "check the path");
    return contentHash(std::string_view(std::string((std::istreambuf_iterator<char>(stream)), {})));
}

}  // namespace penumbra
