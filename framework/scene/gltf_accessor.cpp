#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "scene/gltf_file.h"

namespace penumbra {

namespace {

static_assert(std::endian::native == std::endian::little, "glTF buffers are little-endian");

enum ComponentType : std::size_t {
    kByte = 5120,
    kUnsignedByte = 5121,
    kShort = 5122,
    kUnsignedShort = 5123,
    kUnsignedInt = 5125,
    kFloat = 5126,
};

// Zero-filled accessors take memory that no byte of the file stands for.
constexpr std::size_t kLargestZeroFilled = std::size_t(1) << 24;

std::size_t componentSize(const GltfValue& type) {
    switch (type.whole()) {
        case kByte:
        case kUnsignedByte:
            return 1;
        case kShort:
        case kUnsignedShort:
            return 2;
        case kUnsignedInt:
        case kFloat:
            return 4;
        default:
            type.fail(fmt::format("is {}, which is no component type", type.whole()));
    }
}

int componentCount(const GltfValue& type) {
    const std::string text = type.text();
    if (text == "SCALAR") return 1;
    if (text == "VEC2") return 2;
    if (text == "VEC3") return 3;
    if (text == "VEC4") return 4;
    type.fail("is " + text + ", not SCALAR, VEC2, VEC3 or VEC4");
}

template <typename T>
T load(const std::uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

float loadFloat(const std::uint8_t* bytes, std::size_t type, bool normalized) {
    switch (type) {  // glTF 2.0, section 3.11: how normalized integers become floats
        case kByte: {
            const float v = load<std::int8_t>(bytes);
            return normalized ? std::max(v / 127.0f, -1.0f) : v;
        }
        case kUnsignedByte:
            return normalized ? float(*bytes) / 255.0f : float(*bytes);
        case kShort: {
            const float v = load<std::int16_t>(bytes);
            return normalized ? std::max(v / 32767.0f, -1.0f) : v;
        }
        case kUnsignedShort: {
            const float v = load<std::uint16_t>(bytes);
            return normalized ? v / 65535.0f : v;
        }
        case kUnsignedInt:
            return float(load<std::uint32_t>(bytes));
        default:
            return load<float>(bytes);
    }
}

std::uint32_t loadIndex(const std::uint8_t* bytes, std::size_t type) {
    switch (type) {
        case kUnsignedByte:
            return *bytes;
        case kUnsignedShort:
            return load<std::uint16_t>(bytes);
        default:
            return load<std::uint32_t>(bytes);
    }
}

// `count` elements of `size` bytes, `stride` apart, all of them inside their buffer view.
struct Elements {
    const std::uint8_t* first = nullptr;
    std::size_t stride = 0;
    const std::uint8_t* operator[](std::size_t i) const { return first + i * stride; }
};

Elements elements(const GltfFile& file, const GltfValue& accessor, std::size_t count,
                  std::size_t size) {
    const GltfValue views = file.list("bufferViews");
    const std::size_t viewIndex = accessor.at("bufferView").index(views.size());
    const auto bytes = file.bufferView(viewIndex);
    const std::size_t offset = accessor.wholeOr("byteOffset", 0);
    const std::size_t stride = views.item(viewIndex).wholeOr("byteStride", size);
    if (stride < size || stride > 252)
        views.item(viewIndex).fail(
            fmt::format("has a byteStride of {}, not {} to 252", stride, size));
    // Written so that no sum or product can overflow.
    const bool fits = offset <= bytes.size() && size <= bytes.size() - offset &&
                      (count - 1) <= (bytes.size() - offset - size) / stride;
    if (!fits)
        accessor.fail(fmt::format("needs {} elements of {} bytes, but its buffer view has {} bytes",
                                  count, size, bytes.size()));
    return {bytes.data() + offset, stride};
}

std::size_t indexType(const GltfValue& type) {
    const std::size_t value = type.whole();
    if (value != kUnsignedByte && value != kUnsignedShort && value != kUnsignedInt)
        type.fail(fmt::format("is {}, but indices are unsigned integers", value));
    return value;
}

void replaceSparse(const GltfFile& file, const GltfValue& accessor, std::size_t size,
                   const auto& replace) {
    const GltfValue sparse = accessor.at("sparse");
    const std::size_t total = accessor.at("count").whole();
    const std::size_t count = sparse.at("count").whole();
    if (count == 0 || count > total)
        sparse.fail(fmt::format("has a count of {} of {}", count, total));
    const GltfValue indices = sparse.at("indices");
    const std::size_t type = indexType(indices.at("componentType"));
    const Elements at = elements(file, indices, count, componentSize(indices.at("componentType")));
    const Elements values = elements(file, sparse.at("values"), count, size);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t index = loadIndex(at[i], type);
        if (index >= total) indices.fail(fmt::format("has index {} of {}", index, total));
        replace(index, values[i]);
    }
}

}  // namespace

std::size_t GltfFile::accessorCount(std::size_t index) const {
    const GltfValue count = item("accessors", index).at("count");
    if (count.whole() == 0) count.fail("is 0");
    return count.whole();
}

std::vector<float> GltfFile::floats(std::size_t index, int components) const {
    const GltfValue accessor = item("accessors", index);
    const int found = componentCount(accessor.at("type"));
    if (found != components)
        accessor.fail(fmt::format("has {} components, {} are needed", found, components));
    const auto n = std::size_t(components);
    const std::size_t count = accessorCount(index);
    const std::size_t type = accessor.at("componentType").whole();
    const std::size_t size = componentSize(accessor.at("componentType"));
    const bool normalized = accessor.flag("normalized");
    const bool sparse = accessor.find("sparse").has_value();

    std::vector<float> values;
    const auto store = [&](std::size_t i, const std::uint8_t* from) {
        for (std::size_t k = 0; k < n; ++k)
            values[i * n + k] = loadFloat(from + k * size, type, normalized);
    };
    if (accessor.find("bufferView")) {
        const Elements from = elements(*this, accessor, count, n * size);
        values.resize(count * n);
        for (std::size_t i = 0; i < count; ++i) store(i, from[i]);
    } else {
        if (!sparse) accessor.fail("has no bufferView");
        if (count > kLargestZeroFilled) accessor.fail(fmt::format("has a count of {}", count));
        values.resize(count * n);
    }
    if (sparse) replaceSparse(*this, accessor, n * size, store);
    for (const float v : values)
        if (!std::isfinite(v)) accessor.fail("holds a value that is not finite");
    return values;
}

std::vector<std::uint32_t> GltfFile::indices(std::size_t index) const {
    const GltfValue accessor = item("accessors", index);
    if (componentCount(accessor.at("type")) != 1) accessor.fail("holds indices, but is no SCALAR");
    if (accessor.find("sparse")) accessor.fail("holds sparse indices, which are not supported");
    const std::size_t count = accessorCount(index);
    const std::size_t type = indexType(accessor.at("componentType"));
    const Elements from =
        elements(*this, accessor, count, componentSize(accessor.at("componentType")));
    std::vector<std::uint32_t> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = loadIndex(from[i], type);
    return values;
}

}  // namespace penumbra
