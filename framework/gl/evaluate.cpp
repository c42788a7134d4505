#include "gl/evaluate.h"

#include <fmt/format.h>

#include "core/error.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace penumbra {

namespace {

// A program made of text, not of files: the student's chunk between our inputs and our main().
class TextProgram {
public:
    TextProgram(const std::string& vertex, const ShaderSource& fragment) : id_(glCreateProgram()) {
        attach(GL_VERTEX_SHADER, vertex, nullptr);
        attach(GL_FRAGMENT_SHADER, fragment.text, &fragment);
        glLinkProgram(id_);
        GLint ok = 0;
        glGetProgramiv(id_, GL_LINK_STATUS, &ok);
        if (!ok) throw Error("expression does not link", "evaluate", "check the chunk's functions");
    }
    ~TextProgram() { glDeleteProgram(id_); }
    GLuint id() const { return id_; }

private:
    void attach(GLenum stage, const std::string& text, const ShaderSource* source) {
        const GLuint shader = glCreateShader(stage);
        const char* pointer = text.c_str();
        glShaderSource(shader, 1, &pointer, nullptr);
        glCompileShader(shader);
        GLint ok = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
        char log[4096] = {};
        glGetShaderInfoLog(shader, sizeof log, nullptr, log);
        glAttachShader(id_, shader);
        glDeleteShader(shader);  // lives on until the program goes
        if (!ok)
            throw Error("shader does not compile", source ? source->translate(log) : log,
                        "fix the line; the viewer reloads on save");
    }
    GLuint id_;
};

}  // namespace

Image evaluateGlsl(const Layers& layers, const std::string& chunk, const std::string& expression,
                   const std::map<std::string, Image>& inputs) {
    EXPECTS(!inputs.empty());
    const Image& first = inputs.begin()->second;
    ShaderSource fragment = loadShader(layers, chunk);
    std::string declarations, reads;
    for (const auto& [name, image] : inputs) {
        EXPECTS(image.sameShape(first) && image.channels == 4);
        declarations += fmt::format("uniform sampler2D input_{};\n", name);
        reads +=
            fmt::format("    vec4 {0} = texelFetch(input_{0}, ivec2(gl_FragCoord.xy), 0);\n", name);
    }
    // Behind the chunk, so that its line table stays right.
    fragment.text += declarations + "layout(location = 0) out vec4 result;\nvoid main() {\n" +
                     reads + "    result = " + expression + ";\n}\n";
    const TextProgram program(
        "#version 410 core\nvoid main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> "
        "1) * 4.0 - 1.0, "
        "0.0, 1.0); }\n",
        fragment);

    const glm::ivec2 size(first.width, first.height);
    const Texture output({.size = size, .format = GL_RGBA32F, .label = "evaluate output"});
    const Framebuffer target({.colors = {&output}});
    std::vector<Texture> textures;  // all made before the first is bound: making one binds it too
    for (const auto& [name, image] : inputs) {
        textures.emplace_back(
            TextureDescription{.size = size, .format = GL_RGBA32F, .label = name});
        textures.back().upload(image);
    }
    glUseProgram(program.id());
    for (int unit = 0; const auto& [name, image] : inputs) {
        glUniform1i(glGetUniformLocation(program.id(), ("input_" + name).c_str()), unit);
        glActiveTexture(GL_TEXTURE0 + GLenum(unit));
        glBindTexture(GL_TEXTURE_2D, textures[std::size_t(unit++)].id());
    }
    glActiveTexture(GL_TEXTURE0);
    GLuint vertexArray = 0;
    glGenVertexArrays(1, &vertexArray);
    glBindVertexArray(vertexArray);
    target.bind();
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDeleteVertexArrays(1, &vertexArray);
    return output.read();
}

}  // namespace penumbra
