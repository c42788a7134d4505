#include <fmt/format.h>

#include <map>

#include "scene/gltf_parts.h"
#include "scene/texture_file.h"

namespace penumbra {

namespace {

constexpr std::size_t kLargestTextureBytes = std::size_t(1) << 30;  // all of them together

// Index into `textures` of a glTF texture's picture, decoded at its first use.
class TextureReader {
public:
    TextureReader(const GltfFile& file, std::vector<Texture2D>& textures)
        : file_(file), textures_(textures) {}

    int operator()(const GltfValue& reference) {
        const GltfValue textures = file_.list("textures");
        const GltfValue texture = textures.item(reference.at("index").index(textures.size()));
        if (const auto sampler = texture.find("sampler"))
            sampler->index(file_.list("samplers").size());
        const GltfValue images = file_.list("images");
        const std::size_t image = texture.at("source").index(images.size());
        if (const auto known = byImage_.find(image); known != byImage_.end()) return known->second;

        const std::string where =
            fmt::format("{} of {}", images.item(image).place(), file_.path.string());
        textures_.push_back(decodeTexture(file_.imageBytes(image), where));
        total_ += textures_.back().rgba.size();
        if (total_ > kLargestTextureBytes)
            images.item(image).fail("brings the textures to more than 1 GiB",
                                    "shrink the pictures");
        return byImage_[image] = int(textures_.size()) - 1;
    }

private:
    const GltfFile& file_;
    std::vector<Texture2D>& textures_;
    std::map<std::size_t, int> byImage_;
    std::size_t total_ = 0;
};

// The alpha below which a texel is a hole; 0 = none. A blended surface would need coloured, partial
// shadows, which no technique here renders: cutting it at one half keeps the holes that shape the
// shadow of a leaf or a net.
double alphaCutoff(const GltfValue& material) {
    const std::string mode = material.textOr("alphaMode", "OPAQUE");
    const double cutoff = material.numberOr("alphaCutoff", 0.5);
    if (cutoff < 0.0) material.fail("has a negative alphaCutoff");
    if (mode == "OPAQUE") return 0.0;
    if (mode == "MASK") return cutoff;
    if (mode == "BLEND") return 0.5;
    material.fail("has alphaMode " + mode + ", not OPAQUE, MASK or BLEND");
}

// Factor times strength; an emissive texture is left out.
glm::vec3 emissive(const GltfValue& material) {
    double factor[3] = {0, 0, 0}, strength = 1.0;
    if (const auto given = material.find("emissiveFactor")) given->numbers(factor, 3);
    if (const auto extensions = material.find("extensions"))
        if (const auto given = extensions->find("KHR_materials_emissive_strength"))
            strength = given->numberOr("emissiveStrength", 1.0);
    const glm::dvec3 light = strength * glm::dvec3(factor[0], factor[1], factor[2]);
    for (int k = 0; k < 3; ++k)
        if (!(light[k] >= 0.0 && light[k] <= 1e6))
            material.fail("has an emissiveFactor out of range");
    return light;
}

}  // namespace

GltfMaterials readMaterials(const GltfFile& file) {
    GltfMaterials result;
    TextureReader readTexture(file, result.textures);
    const GltfValue materials = file.list("materials");
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const GltfValue material = materials.item(i);
        double factor[4] = {1, 1, 1, 1};
        Material read;
        read.name = material.textOr("name", fmt::format("material{}", i));
        std::size_t texCoord = 0;
        if (const auto pbr = material.find("pbrMetallicRoughness")) {
            if (const auto color = pbr->find("baseColorFactor")) color->numbers(factor, 4);
            for (const double f : factor)
                if (f < 0.0 || f > 1e6) pbr->fail("has a baseColorFactor out of range");
            if (const auto texture = pbr->find("baseColorTexture")) {
                read.texture = readTexture(*texture);
                texCoord = texture->wholeOr("texCoord", 0);
            }
        }
        read.baseColor = {factor[0], factor[1], factor[2]};
        // Files give every part with an emissive texture a factor of 1: without the texture it
        // would shine all over.
        if (!material.find("emissiveTexture")) read.emissive = emissive(material);
        // glTF tests factor x texel against the cutoff, a Material its texel alone.
        const double cutoff = alphaCutoff(material);
        const double needed = factor[3] > 0.0 ? cutoff / factor[3] : cutoff > 0.0 ? 2.0 : 0.0;
        read.alphaCutoff = float(needed);
        result.invisible.push_back(needed > 1.0);
        result.materials.push_back(read);
        result.texCoord.push_back(texCoord);
    }
    return result;
}

}  // namespace penumbra
