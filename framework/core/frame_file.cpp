#include "core/frame_file.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.h"

namespace penumbra {

static_assert(std::endian::native == std::endian::little, "frame files hold little-endian floats");

namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::string_view kMagic = "PENUMBRA1\n";
constexpr std::size_t kMaximumHeader = 1 << 20;
constexpr std::size_t kMaximumName = 64;

[[noreturn]] void refuse(const fs::path& path, const std::string& what) {
    throw Error("not a frame file: " + what, path.string(), "render the frame again");
}

// A reader that never runs past the end the file system reported.
class Reader {
public:
    Reader(const fs::path& path, std::size_t size)
        : path_(path), stream_(path, std::ios::binary), left_(size) {
        if (!stream_) throw Error("cannot open frame file", path.string(), "check its permissions");
    }

    void read(void* target, std::size_t bytes, const std::string& what) {
        if (bytes > left_) refuse(path_, "cut short in " + what);
        if (!stream_.read(static_cast<char*>(target), std::streamsize(bytes)))
            refuse(path_, "unreadable in " + what);
        left_ -= bytes;
    }

    std::size_t left() const { return left_; }

private:
    fs::path path_;
    std::ifstream stream_;
    std::size_t left_;
};

std::size_t checkedSize(const fs::path& path, const FrameFileLimits& limits) {
    // A pipe or a link in the frame's place could hang the reader or show it another file.
    const auto status = fs::symlink_status(path);
    if (!fs::exists(status)) throw Error("no frame file", path.string(), "render the frame again");
    if (!fs::is_regular_file(status)) refuse(path, "not a regular file");
    std::error_code error;
    const auto size = fs::file_size(path, error);
    if (error) refuse(path, error.message());
    if (size > limits.maximumBytes)
        refuse(path,
               fmt::format("{} bytes are more than the {} allowed", size, limits.maximumBytes));
    return std::size_t(size);
}

json readHeader(Reader& reader, const fs::path& path) {
    std::string magic(kMagic.size(), '\0');
    reader.read(magic.data(), magic.size(), "its first line");
    if (magic != kMagic) refuse(path, "it starts with other bytes");
    std::size_t length = 0;
    for (char c = 0;;) {
        reader.read(&c, 1, "the header's length");
        if (c == '\n') break;
        if (c < '0' || c > '9') refuse(path, "the header's length is no number");
        length = 10 * length + std::size_t(c - '0');
        if (length > kMaximumHeader) refuse(path, "the header is too long");
    }
    std::string text(length, '\0');
    reader.read(text.data(), length, "its header");
    json header = json::parse(text, nullptr, false);
    if (!header.is_object() || !header.contains("images") || !header["images"].is_array())
        refuse(path, "the header is no list of images");
    return header;
}

int wholeNumber(const fs::path& path, const json& entry, const char* key, int maximum) {
    const auto it = entry.find(key);
    if (it == entry.end() || !it->is_number_integer())
        refuse(path, fmt::format("an image's {} is no whole number", key));
    const auto value = it->get<std::int64_t>();  // an unsigned past 2^63 comes out negative
    if (value < 1 || value > maximum)
        refuse(path, fmt::format("an image's {} is not in 1..{}", key, maximum));
    return int(value);
}

void readImages(Reader& reader, const fs::path& path, const json& header,
                const FrameFileLimits& limits, FrameFile& frame) {
    const json& list = header["images"];
    if (list.size() > std::size_t(limits.maximumImages))
        refuse(path, fmt::format("{} images are more than the {} allowed", list.size(),
                                 limits.maximumImages));
    for (const json& entry : list) {
        if (!entry.is_object() || !entry.contains("name") || !entry["name"].is_string())
            refuse(path, "an image has no name");
        const auto name = entry["name"].get<std::string>();
        if (name.empty() || name.size() > kMaximumName || frame.images.count(name) > 0)
            refuse(path, "an image's name is empty, too long or used twice");
        const int width = wholeNumber(path, entry, "width", limits.maximumSide);
        const int height = wholeNumber(path, entry, "height", limits.maximumSide);
        const int channels = wholeNumber(path, entry, "channels", 4);
        const std::size_t bytes =
            sizeof(float) * std::size_t(width) * std::size_t(height) * std::size_t(channels);
        if (bytes > reader.left())
            refuse(path, "cut short in image '" + name + "'");  // before memory
        Image image(width, height, channels);
        reader.read(image.pixels.data(), bytes, "image '" + name + "'");
        frame.images.emplace(name, std::move(image));
    }
    if (reader.left() > 0) refuse(path, fmt::format("{} bytes follow the images", reader.left()));
}

void readNotes(const fs::path& path, const json& header, FrameFile& frame) {
    if (const auto it = header.find("milliseconds"); it != header.end()) {
        if (!it->is_object()) refuse(path, "'milliseconds' is no table");
        for (const auto& [pass, value] : it->items()) {
            if (!value.is_number() || !std::isfinite(value.get<double>()) ||
                value.get<double>() < 0)
                refuse(path, "a pass has no time");
            frame.milliseconds[pass] = value.get<double>();
        }
    }
    if (const auto it = header.find("info"); it != header.end()) {
        if (!it->is_object()) refuse(path, "'info' is no table");
        for (const auto& [key, value] : it->items()) {
            if (!value.is_string()) refuse(path, "'info' holds more than text");
            frame.info[key] = value.get<std::string>();
        }
    }
}

}  // namespace

void saveFrameFile(const fs::path& path, const FrameFile& frame) {
    json header = {
        {"images", json::array()}, {"milliseconds", frame.milliseconds}, {"info", frame.info}};
    for (const auto& [name, image] : frame.images) {
        EXPECTS(!image.empty());
        header["images"].push_back({{"name", name},
                                    {"width", image.width},
                                    {"height", image.height},
                                    {"channels", image.channels}});
    }
    // Driver strings need not be UTF-8.
    const std::string text = header.dump(-1, ' ', false, json::error_handler_t::replace);
    const auto temporary = fs::path(path).concat(".part");
    {
        std::ofstream stream(temporary, std::ios::binary);
        stream << kMagic << text.size() << '\n' << text;
        for (const auto& [name, image] : frame.images)
            stream.write(reinterpret_cast<const char*>(image.pixels.data()),
                         std::streamsize(sizeof(float) * image.pixels.size()));
        stream.close();
        if (!stream) {
            std::error_code ignored;
            fs::remove(temporary, ignored);
            throw Error("cannot write frame file", path.string(),
                        "check the folder and the disk's space");
        }
    }
    std::error_code error;
    fs::rename(temporary, path, error);
    if (error) throw Error("cannot write frame file", path.string(), error.message());
}

FrameFile loadFrameFile(const fs::path& path, const FrameFileLimits& limits) {
    Reader reader(path, checkedSize(path, limits));
    const json header = readHeader(reader, path);
    FrameFile frame;
    readImages(reader, path, header, limits, frame);
    readNotes(path, header, frame);
    return frame;
}

}  // namespace penumbra
