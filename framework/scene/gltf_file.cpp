#include "scene/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "core/error.h"

namespace penumbra {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t(1) << 31;
constexpr int kDeepestJson = 64;  // real files stay below 12; bounds recursion when it is freed

std::vector<std::uint8_t> readFile(const fs::path& path) {
    std::error_code error;
    if (!fs::exists(path, error))
        throw Error("no such file", path.string(), "check the path, or see ./course list");
    if (!fs::is_regular_file(path, error))
        throw Error("not a file", path.string(), "name a .glb or .gltf file");
    const std::uintmax_t size = fs::file_size(path, error);
    if (error || size > kLargestFile)
        throw Error("file is too large", path.string(), "models up to 2 GiB are read");
    std::vector<std::uint8_t> bytes(size);
    std::ifstream stream(path, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
    if (!stream) throw Error("cannot read file", path.string(), "check its permissions");
    return bytes;
}

std::uint32_t littleEndian(std::span<const std::uint8_t> bytes, std::size_t offset) {
    return std::uint32_t(bytes[offset]) | std::uint32_t(bytes[offset + 1]) << 8 |
           std::uint32_t(bytes[offset + 2]) << 16 | std::uint32_t(bytes[offset + 3]) << 24;
}

struct Chunks {
    std::span<const std::uint8_t> json;
    std::span<const std::uint8_t> binary;
    bool hasBinary = false;
};

Chunks splitGlb(std::span<const std::uint8_t> bytes, const std::string& name) {
    const auto broken = [&](const std::string& what) -> Error {
        return {what, name, "copy or export the model again"};
    };
    if (bytes.size() < 20) throw broken("file is cut short within the GLB header");
    if (const auto version = littleEndian(bytes, 4); version != 2)
        throw broken(fmt::format("GLB version {} instead of 2", version));
    const std::size_t length = littleEndian(bytes, 8);
    if (length > bytes.size() || length < 20)
        throw broken(fmt::format("file is cut short: its header promises {} bytes, there are {}",
                                 length, bytes.size()));
    Chunks chunks;
    std::size_t offset = 12;
    for (int number = 0; offset + 8 <= length; ++number) {
        const std::size_t size = littleEndian(bytes, offset);
        const std::uint32_t kind = littleEndian(bytes, offset + 4);
        if (size > length - offset - 8)
            throw broken(
                fmt::format("GLB chunk {} of {} bytes reaches past the end", number, size));
        const auto body = bytes.subspan(offset + 8, size);
        if (number == 0) {
            if (kind != 0x4e4f534a) throw broken("the first GLB chunk is not JSON");
            chunks.json = body;
        } else if (kind == 0x004e4942 && !chunks.hasBinary) {
            chunks.binary = body;
            chunks.hasBinary = true;
        }
        offset += 8 + size;
    }
    return chunks;
}

// Before parsing, in one sweep: the parser's own callback takes time quadratic in long arrays.
int nestingDepth(std::span<const std::uint8_t> text) {
    int depth = 0, deepest = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::uint8_t c = text[i];
        if (quoted && c == '\\')
            ++i;  // the escaped character
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && (c == '[' || c == '{'))
            deepest = std::max(deepest, ++depth);
        else if (!quoted && (c == ']' || c == '}'))
            --depth;
    }
    return deepest;
}

nlohmann::json parseJson(std::span<const std::uint8_t> text, const std::string& name) {
    if (nestingDepth(text) > kDeepestJson)
        throw Error("JSON is nested too deep", name, "export the model again");
    try {
        return nlohmann::json::parse(text.begin(), text.end());
    } catch (const nlohmann::json::exception& e) {
        throw Error("not a glTF model", name, printable(e.what()));
    }
}

std::vector<std::uint8_t> decodeBase64(const std::string& text, std::size_t from,
                                       const GltfValue& where) {
    static const auto table = [] {
        std::array<int, 256> t;
        t.fill(-1);
        const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        for (int i = 0; i < 64; ++i) t[static_cast<unsigned char>(letters[i])] = i;
        return t;
    }();
    std::vector<std::uint8_t> bytes;
    bytes.reserve((text.size() - from) / 4 * 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (std::size_t i = from; i < text.size() && text[i] != '='; ++i) {
        const int digit = table[static_cast<unsigned char>(text[i])];
        if (digit < 0) where.fail("is not base64");
        bits = (bits << 6 | std::uint32_t(digit)) & 0xffffff;
        if (++count % 4 != 1) bytes.push_back(std::uint8_t(bits >> (6 - 2 * ((count - 1) % 4))));
    }
    return bytes;
}

std::string percentDecoded(const std::string& uri, const GltfValue& where) {
    const auto digit = [&](char c) -> int {
        if (c >= '0' && c <= '9') return c - '0';
        if (c >= 'a' && c <= 'f') return c - 'a' + 10;
        if (c >= 'A' && c <= 'F') return c - 'A' + 10;
        where.fail("has a bad %-escape");
    };
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            text += uri[i];
            continue;
        }
        if (i + 2 >= uri.size()) where.fail("has a bad %-escape");
        text += char(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
        i += 2;
    }
    return text;
}

bool liesInside(const fs::path& path, const fs::path& folder) {
    const auto [end, unused] =
        std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end();
}

void checkHeader(const GltfFile& file) {
    const std::string version = file.root().at("asset").at("version").text();
    if (version.rfind("2.", 0) != 0)
        file.root().at("asset").fail("has version " + version + ", only 2.x is read");
    // What changes neither triangles nor base colour, or is implemented.
    const auto harmless = [](const std::string& extension) {
        return extension == "KHR_lights_punctual" || extension == "KHR_mesh_quantization" ||
               extension.rfind("KHR_materials_", 0) == 0;
    };
    const GltfValue required = file.list("extensionsRequired");
    for (std::size_t i = 0; i < required.size(); ++i) {
        const std::string extension = required.item(i).text();
        if (harmless(extension) && extension != "KHR_materials_pbrSpecularGlossiness") continue;
        required.item(i).fail("is " + extension + ", which is not supported",
                              "export the model without it (for compression: uncompressed)");
    }
}

}  // namespace

GltfValue GltfFile::list(const char* key) const {
    static const nlohmann::json none = nlohmann::json::array();
    const auto found = root().find(key);
    if (!found) return GltfValue(none, key, name_);
    found->size();
    return *found;
}

std::vector<std::uint8_t> GltfFile::uriBytes(const GltfValue& uri) const {
    const std::string text = uri.text();
    if (text.rfind("data:", 0) == 0) {
        const std::size_t comma = text.find(";base64,");
        if (comma == std::string::npos) uri.fail("is a data URI without base64");
        return decodeBase64(text, comma + 8, uri);
    }
    const auto refuse = [&] {
        uri.fail("is \"" + text + "\", outside the model's folder",
                 "put the file beside the model and name it by a relative path");
    };
    if (text.find(':') != std::string::npos || text.find('\\') != std::string::npos) refuse();
    const std::string name = percentDecoded(text, uri);
    if (name.empty() || name.find('\0') != std::string::npos) uri.fail("names no file");
    if (fs::path(name).is_absolute() || fs::path(name).has_root_name()) refuse();
    // Resolved, so that neither ".." nor a symbolic link leads out.
    std::error_code error;
    const fs::path folder = fs::weakly_canonical(fs::absolute(path).parent_path(), error);
    const fs::path target = fs::weakly_canonical(folder / name, error);
    if (error || !liesInside(target, folder)) refuse();
    return readFile(target);
}

std::span<const std::uint8_t> GltfFile::bufferView(std::size_t index) const {
    const GltfValue view = item("bufferViews", index);
    const auto& buffer = buffers_[view.at("buffer").index(buffers_.size())];
    const std::size_t offset = view.wholeOr("byteOffset", 0);
    const std::size_t length = view.at("byteLength").whole();
    if (offset > buffer.size() || length > buffer.size() - offset)
        view.fail(fmt::format("spans bytes {} to {} of a buffer of {}", offset, offset + length,
                              buffer.size()));
    return std::span(buffer).subspan(offset, length);
}

std::vector<std::uint8_t> GltfFile::imageBytes(std::size_t index) const {
    const GltfValue image = item("images", index);
    if (const auto uri = image.find("uri")) return uriBytes(*uri);
    const auto bytes = bufferView(image.at("bufferView").index(list("bufferViews").size()));
    return {bytes.begin(), bytes.end()};
}

GltfFile openGltf(const fs::path& path) {
    GltfFile file;
    file.path = path;
    file.name_ = path.string();
    const std::vector<std::uint8_t> bytes = readFile(path);
    const bool binary = bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
    const Chunks chunks =
        binary ? splitGlb(bytes, file.name_) : Chunks{.json = bytes, .binary = {}};
    file.json_ = parseJson(chunks.json, file.name_);
    if (!file.json_.is_object())
        throw Error("not a glTF model", file.name_, "its JSON is no object");
    checkHeader(file);

    const GltfValue buffers = file.list("buffers");
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const GltfValue buffer = buffers.item(i);
        std::vector<std::uint8_t> content;
        if (const auto uri = buffer.find("uri"))
            content = file.uriBytes(*uri);
        else if (i == 0 && chunks.hasBinary)
            content.assign(chunks.binary.begin(), chunks.binary.end());
        else
            buffer.fail("has neither a uri nor a binary chunk");
        const std::size_t length = buffer.at("byteLength").whole();
        if (length > content.size())
            buffer.fail(fmt::format("declares {} bytes, but holds {}", length, content.size()));
        content.resize(length);  // a binary chunk is padded
        file.buffers_.push_back(std::move(content));
    }
    return file;
}

}  // namespace penumbra
