// Shader programs from a variant's folders, with #include, errors in the student's own lines, and
// reload.
//
//   ShaderLibrary shaders(layers);
//   Program& shade = shaders.program("camera_pass.vert", "camera_pass.frag");
//   shade.use();
//   shade.texture("shadowMap", 0, map);
//
// `#include "depth_bias.glsl"` takes the file of that name from the last folder that has one, once.
// The loader writes `#version 410 core` on top and refuses any other version.
#pragma once

#include <glad/gl.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/layers.h"
#include "gl/texture.h"
#include "gl/volume_texture.h"

namespace penumbra {

// GLSL text after includes, with the way back from each flattened line to file and line.
struct ShaderSource {
    struct Origin {
        std::filesystem::path file;
        int line = 0;
    };
    struct File {
        std::filesystem::path path;             // empty: there was none of that name
        std::filesystem::file_time_type stamp;  // from before it was read: a later save is seen
    };
    std::string text;
    std::vector<Origin> lines;          // lines[i] = where flattened line i + 1 came from
    std::map<std::string, File> files;  // every file taken, by the name that asked for it

    // Rewrites a driver's log ("0:31(5): error: …") to "pcss.glsl:31: error: …", one line a
    // message.
    std::string translate(const std::string& log) const;
};

// `chunks` follow the entry point's text. Throws Error for a missing file or a #version that is not
// ours.
ShaderSource loadShader(const Layers& layers, const std::string& name,
                        const std::vector<std::string>& chunks = {});
// The same into `source`, whose `files` name what was looked for even when it throws.
void loadShader(const Layers& layers, const std::string& name,
                const std::vector<std::string>& chunks, ShaderSource& source);

class Program {
public:
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void use() const { glUseProgram(id_); }
    // Uniforms and blocks that the linker removed are silently left out: a stub may not use them
    // yet.
    void set(const char* name, float value) const;
    void set(const char* name, int value) const;
    void set(const char* name, glm::vec2 value) const;
    void set(const char* name, glm::vec3 value) const;
    void set(const char* name, glm::vec4 value) const;
    void set(const char* name, const glm::mat4& value) const;
    void texture(const char* sampler, int unit, const Texture& texture) const;
    void texture(const char* sampler, int unit, const VolumeTexture& texture) const;
    void textureId(const char* sampler, int unit, GLuint id) const;
    void block(const char* name, int binding) const;

    GLuint id() const { return id_; }

private:
    friend class ShaderLibrary;
    Program(std::string vertex, std::string fragment, std::vector<std::string> chunks)
        : vertex_(std::move(vertex)), fragment_(std::move(fragment)), chunks_(std::move(chunks)) {}

    GLuint id_ = 0;  // 0: there was no good form yet
    std::string vertex_, fragment_;
    std::vector<std::string> chunks_;
    std::map<std::string, ShaderSource::File> files_;  // as of the last attempt, good or not
    std::optional<Error> error_;                       // of the last attempt; none = good
};

class ShaderLibrary {
public:
    explicit ShaderLibrary(Layers layers) : layers_(std::move(layers)) {}

    // Compiled on first use. `chunks` give bodies to functions that the fragment shader only
    // declares: how a setting picks a technique's form. Throws Error ("depth_bias.glsl:12: …") as
    // long as there is no good program.
    Program& program(const std::string& vertex, const std::string& fragment,
                     const std::vector<std::string>& chunks = {});

    // Compiles programs whose files changed on disk. A program with an error keeps its last good
    // form. Returns true when at least one program is new. Cheap: looks at time stamps.
    bool reload();

    // The message of the first program that is not as on disk, "" when all are.
    std::string error() const;
    const Layers& layers() const { return layers_; }

private:
    bool compile(Program& program);  // false: program.error_ says why
    bool changedOnDisk(const Program& program) const;

    Layers layers_;
    std::map<std::string, std::unique_ptr<Program>> programs_;
};

}  // namespace penumbra
