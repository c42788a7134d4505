// All that a truth depends on, in 128 bits: values are added one after another, lengths before
// their lists.
//
//   TruthKey("areaVisibility", scene, size, samples).text()   // "3f0a…": a file's name
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/image.h"
#include "scene/scene.h"

namespace penumbra {

class TruthKey {
public:
    // First the truth's name: what else would tell two truths of one scene apart?
    template <typename... Parts>
    explicit TruthKey(std::string_view name, const Parts&... parts) {
        add(name);
        (add(parts), ...);
    }

    void add(std::string_view text);
    void add(const char* text) { add(std::string_view(text)); }
    void add(const std::string& text) { add(std::string_view(text)); }
    void add(const Image& image);
    void add(const Mesh& mesh);
    void add(const Material& material);
    void add(const Texture2D& texture);
    void add(const Camera& camera);
    void add(const Light& light);
    void add(const Scene& scene);

    template <typename T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value) {
        addBytes(&value, sizeof value);
    }
    template <glm::length_t N, typename T>
    void add(const glm::vec<N, T>& vector) {
        addBytes(&vector, sizeof vector);
    }
    template <glm::length_t C, glm::length_t R, typename T>
    void add(const glm::mat<C, R, T>& matrix) {
        addBytes(&matrix, sizeof matrix);
    }
    template <typename T>
    void add(const std::vector<T>& list) {
        add(list.size());
        if constexpr (std::is_class_v<T> && !requires { T::length(); })
            for (const T& entry : list) add(entry);
        else
            addBytes(list.data(), sizeof(T) * list.size());
    }

    std::string text() const;  // 32 hexadecimal digits

private:
    void addBytes(const void* bytes, std::size_t count);

    // Two lanes of FNV-1a's form over words of eight bytes: against accidents, not against forgers.
    std::uint64_t first_ = 0xcbf29ce484222325u, second_ = 0x6c62272e07bb0142u;
};

}  // namespace penumbra
