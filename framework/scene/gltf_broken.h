// For tests of broken glTF files: what loading one says.
//
//   expectError(errorOf(model.glb()), "has no triangles", "empty mesh");
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/error.h"
#include "scene/gltf.h"
#include "scene/gltf_test_model.h"
#include "scene/scratch_folder.h"

namespace penumbra {

inline const ScratchFolder& scratch() {
    static const ScratchFolder folder;
    return folder;
}

inline std::string errorOfFile(const std::filesystem::path& path) {
    try {
        loadGltf(path);
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

inline std::string errorOf(const std::string& bytes) {
    writeBytes(scratch() / "broken.glb", bytes);
    return errorOfFile(scratch() / "broken.glb");
}

inline void expectError(const std::string& error, const std::string& part,
                        const std::string& name) {
    EXPECT_NE(error.find(part), std::string::npos) << name << ": " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << name;
    EXPECT_NE(error.find("; "), std::string::npos) << name << " gives no advice";
}

}  // namespace penumbra
