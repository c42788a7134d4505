// One rendered frame in one file: how an assignment's program answers a request of the grader. The
// reader trusts nothing: size, counts and finiteness are verified before a pixel is used.
//
//   saveFrameFile(path, frame);                          // in the student's process
//   FrameFile frame = loadFrameFile(path, {.maximumBytes = 64 << 20});   // in the grader
//
// Layout: "PENUMBRA1\n", the header's length in decimal and "\n", a JSON header
// {"images": [{"name", "width", "height", "channels"}], "milliseconds": {pass: ms}, "info": {…}},
// then every image's 32-bit little-endian floats in that order, nothing after them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

#include "core/image.h"

namespace penumbra {

struct FrameFile {
    std::map<std::string, Image> images;         // by name: visibility, color, depth, …
    std::map<std::string, double> milliseconds;  // by pass: light, camera, …
    std::map<std::string, std::string> info;     // GL strings, settings
};

struct FrameFileLimits {
    std::size_t maximumBytes = std::size_t(256) << 20;
    int maximumSide = 8192;
    int maximumImages = 32;
};

// Written to a temporary name and renamed. Throws Error.
void saveFrameFile(const std::filesystem::path& path, const FrameFile& frame);

// Throws Error that names what is wrong: missing, too large, cut short, trailing bytes, a bad
// header. Non-finite values are kept: the caller asks nonFiniteCount() so that its message can say
// where.
FrameFile loadFrameFile(const std::filesystem::path& path, const FrameFileLimits& limits = {});

}  // namespace penumbra
