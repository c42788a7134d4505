#include "scene/gltf_value.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace penumbra {

std::string printable(std::string text) {
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
    if (text.size() > 200) text = text.substr(0, 200) + "...";
    return text;
}

void GltfValue::fail(const std::string& problem, const std::string& advice) const {
    throw Error(printable(place_ + " " + problem), *file_, advice);
}

std::optional<GltfValue> GltfValue::find(const char* key) const {
    if (!value_->is_object()) fail("is not an object");
    const auto member = value_->find(key);
    if (member == value_->end()) return std::nullopt;
    return GltfValue(*member, place_.empty() ? key : place_ + "." + key, *file_);
}

GltfValue GltfValue::at(const char* key) const {
    auto member = find(key);
    if (!member) fail(fmt::format("has no {}", key));
    return *member;
}

GltfValue GltfValue::item(std::size_t i) const {
    return GltfValue((*value_)[i], fmt::format("{}[{}]", place_, i), *file_);
}

std::size_t GltfValue::size() const {
    if (!value_->is_array()) fail("is not an array");
    return value_->size();
}

double GltfValue::number() const {
    if (!value_->is_number()) fail("is not a number");
    const double number = value_->get<double>();
    if (!std::isfinite(number)) fail("is not finite");
    return number;
}

std::size_t GltfValue::whole() const {
    const double value = number();
    if (value < 0.0 || value > 9007199254740992.0 || value != std::floor(value))
        fail(fmt::format("is {}, not a whole number from 0", value));
    return std::size_t(value);
}

std::size_t GltfValue::index(std::size_t count) const {
    const std::size_t value = whole();
    if (value >= count) fail(fmt::format("is {}, but the file has {} of them", value, count));
    return value;
}

std::string GltfValue::text() const {
    if (!value_->is_string()) fail("is not a text");
    return value_->get<std::string>();
}

void GltfValue::numbers(double* out, std::size_t count) const {
    if (size() != count) fail(fmt::format("has {} values instead of {}", size(), count));
    for (std::size_t i = 0; i < count; ++i) out[i] = item(i).number();
}

double GltfValue::numberOr(const char* key, double otherwise) const {
    const auto member = find(key);
    return member ? member->number() : otherwise;
}

std::size_t GltfValue::wholeOr(const char* key, std::size_t otherwise) const {
    const auto member = find(key);
    return member ? member->whole() : otherwise;
}

std::string GltfValue::textOr(const char* key, const std::string& otherwise) const {
    const auto member = find(key);
    return member ? member->text() : otherwise;
}

bool GltfValue::flag(const char* key) const {
    const auto member = find(key);
    if (!member) return false;
    if (!member->value_->is_boolean()) member->fail("is neither true nor false");
    return member->value_->get<bool>();
}

}  // namespace penumbra
