// A place in a glTF file's JSON that knows its own name, so that every access is checked and every
// complaint says where: "meshes[0].primitives[1].indices is 7, but the file has 3 accessors".
//
//   GltfValue node = file.list("nodes").item(4);
//   if (auto mesh = node.find("mesh")) index = mesh->index(file.list("meshes").size());
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace penumbra {

// Holds references into the GltfFile it came from.
class GltfValue {
public:
    using json = nlohmann::json;

    GltfValue(const json& value, std::string place, const std::string& file)
        : value_(&value), place_(std::move(place)), file_(&file) {}

    // Throws Error "<place> <problem>: <file>; <advice>".
    [[noreturn]] void fail(const std::string& problem,
                           const std::string& advice = "export the model again") const;

    std::optional<GltfValue> find(const char* key) const;  // this must be an object
    GltfValue at(const char* key) const;                   // a member that must be there
    GltfValue item(std::size_t i) const;                   // i < size()
    std::size_t size() const;                              // this must be an array

    double number() const;                       // finite
    std::size_t whole() const;                   // 0, 1, … up to 2^53
    std::size_t index(std::size_t count) const;  // whole() < count
    std::string text() const;
    void numbers(double* out, std::size_t count) const;  // an array of exactly `count` numbers

    double numberOr(const char* key, double otherwise) const;
    std::size_t wholeOr(const char* key, std::size_t otherwise) const;
    std::string textOr(const char* key, const std::string& otherwise) const;
    bool flag(const char* key) const;  // false if missing
    bool isObject() const { return value_->is_object(); }

    const std::string& place() const { return place_; }

private:
    const json* value_;
    std::string place_;
    const std::string* file_;
};

// Control characters of text that comes from a file become '?': an Error stays one line.
std::string printable(std::string text);

}  // namespace penumbra
