#include "shadow_volumes.h"

namespace penumbra {

void appendSide(std::uint32_t from, std::uint32_t to, std::uint32_t farOffset, bool directional,
                std::vector<glm::uvec3>& sides) {
    sides.push_back({to, from, from + farOffset});
    if (!directional) sides.push_back({to, from + farOffset, to + farOffset});
}

}  // namespace penumbra
