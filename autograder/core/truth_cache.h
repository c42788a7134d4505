// Truths of earlier runs on disk. A file's name is a hash of all that the truth depends on and of
// the code that computed it: nothing has to be thrown away when either changes.
//
//   TruthCache cache(build / "truths");
//   if (auto images = cache.load(key)) return *images;
//   cache.save(key, images);
//
// Several processes may share a folder. Files that are damaged, or cannot be written, cost time and
// nothing else. Whoever can write to the folder can decide what is true (docs/grading.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "core/image.h"
#include "core/truth_key.h"

namespace penumbra {

class TruthCache {
public:
    using Images = std::map<std::string, Image>;

    TruthCache() = default;  // holds nothing and keeps nothing
    explicit TruthCache(std::filesystem::path folder,
                        std::uintmax_t maximumBytes = std::uintmax_t(1) << 30);

    std::optional<Images> load(const TruthKey& key) const;
    void save(const TruthKey& key, const Images& images) const;

private:
    std::filesystem::path fileOf(const TruthKey& key) const;
    void removeOldest() const;  // until `maximumBytes_` hold all

    std::filesystem::path folder_;
    std::uintmax_t maximumBytes_ = 0;
};

// Hash of the code that computes truths on this machine: this program's and libpenumbra's bytes,
// other libraries by path, size and time, the processor's abilities. Empty where the system does
// not tell: then nothing is kept.
const std::string& codeHash();

}  // namespace penumbra
