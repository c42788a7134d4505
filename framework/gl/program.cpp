#include "gl/program.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "core/error.h"

namespace penumbra {

namespace {

// A shader or program object that goes when compilation fails half-way.
struct GlObject {
    GLuint id;
    void (*destroy)(GLuint);
    ~GlObject() {
        if (id) destroy(id);
    }
};

std::string infoLog(GLuint id, bool program) {
    GLint length = 0;
    (program ? glGetProgramiv : glGetShaderiv)(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(std::size_t(std::max(length, 1)), '\0');
    (program ? glGetProgramInfoLog : glGetShaderInfoLog)(id, length, nullptr, log.data());
    while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) log.pop_back();
    return log;
}

void compileStage(GLuint shader, const ShaderSource& source, const std::string& name) {
    const char* text = source.text.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint ok = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (!ok)
        throw Error("shader does not compile", source.translate(infoLog(shader, false)),
                    "fix " + name + " or a chunk it includes, the viewer reloads on save");
}

GLuint link(const std::string& vertexName, const ShaderSource& vertex,
            const std::string& fragmentName, const ShaderSource& fragment) {
    const GlObject vertexShader{glCreateShader(GL_VERTEX_SHADER), glDeleteShader};
    const GlObject fragmentShader{glCreateShader(GL_FRAGMENT_SHADER), glDeleteShader};
    compileStage(vertexShader.id, vertex, vertexName);
    compileStage(fragmentShader.id, fragment, fragmentName);
    GlObject linked{glCreateProgram(), glDeleteProgram};
    glAttachShader(linked.id, vertexShader.id);
    glAttachShader(linked.id, fragmentShader.id);
    glLinkProgram(linked.id);
    GLint ok = 0;
    glGetProgramiv(linked.id, GL_LINK_STATUS, &ok);
    if (!ok)
        throw Error("shaders do not link",
                    vertexName + " + " + fragmentName + ": " + infoLog(linked.id, true),
                    "make the outputs of one stage match the inputs of the next");
    return std::exchange(linked.id, 0);
}

void bindToUnit(int unit, GLenum target, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    glBindTexture(target, texture);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace

Program::~Program() {
    if (id_) glDeleteProgram(id_);
}

void Program::set(const char* name, float value) const {
    glUniform1f(glGetUniformLocation(id_, name), value);
}
void Program::set(const char* name, int value) const {
    glUniform1i(glGetUniformLocation(id_, name), value);
}
void Program::set(const char* name, glm::vec2 value) const {
    glUniform2fv(glGetUniformLocation(id_, name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, glm::vec3 value) const {
    glUniform3fv(glGetUniformLocation(id_, name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, glm::vec4 value) const {
    glUniform4fv(glGetUniformLocation(id_, name), 1, glm::value_ptr(value));
}
void Program::set(const char* name, const glm::mat4& value) const {
    glUniformMatrix4fv(glGetUniformLocation(id_, name), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::texture(const char* sampler, int unit, const Texture& texture) const {
    textureId(sampler, unit, texture.id());
}

void Program::textureId(const char* sampler, int unit, GLuint id) const {
    set(sampler, unit);
    bindToUnit(unit, GL_TEXTURE_2D, id);
}

void Program::texture(const char* sampler, int unit, const VolumeTexture& texture) const {
    set(sampler, unit);
    bindToUnit(unit, GL_TEXTURE_3D, texture.id());
}

void Program::block(const char* name, int binding) const {
    const GLuint index = glGetUniformBlockIndex(id_, name);
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(id_, index, GLuint(binding));
}

Program& ShaderLibrary::program(const std::string& vertex, const std::string& fragment,
                                const std::vector<std::string>& chunks) {
    std::string key = vertex + "|" + fragment;
    for (const std::string& chunk : chunks) key += "|" + chunk;
    auto& slot = programs_[key];
    if (!slot) {
        slot.reset(new Program(vertex, fragment, chunks));
        compile(*slot);
    }
    if (!slot->id_) throw *slot->error_;
    return *slot;
}

bool ShaderLibrary::compile(Program& program) {
    ShaderSource vertex, fragment;
    try {
        loadShader(layers_, program.vertex_, {}, vertex);
        loadShader(layers_, program.fragment_, program.chunks_, fragment);
        GlObject linked{link(program.vertex_, vertex, program.fragment_, fragment),
                        glDeleteProgram};
        std::swap(program.id_, linked.id);  // the old program goes with `linked`
        program.error_.reset();
    } catch (const Error& e) {
        program.error_ = e;
    }
    // Those of a failed attempt too: it is tried again when a file is saved, not at every poll.
    program.files_ = std::move(vertex.files);
    program.files_.merge(fragment.files);
    return !program.error_;
}

bool ShaderLibrary::changedOnDisk(const Program& program) const {
    for (const auto& [name, file] : program.files_) {
        const auto place = layers_.find(name);
        if (!place) continue;  // none for a moment while an editor replaces the file
        std::error_code gone;
        const auto stamp = std::filesystem::last_write_time(*place, gone);
        if (!gone && (*place != file.path || stamp != file.stamp)) return true;
    }
    return false;
}

bool ShaderLibrary::reload() {
    bool anyNew = false;
    for (auto& [name, program] : programs_)
        if (changedOnDisk(*program)) anyNew |= compile(*program);
    return anyNew;
}

std::string ShaderLibrary::error() const {
    for (const auto& [name, program] : programs_)
        if (program->error_) return program->error_->what();
    return "";
}

}  // namespace penumbra
