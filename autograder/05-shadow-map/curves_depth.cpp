// What a depth format can tell apart, whatever a student writes: drawn by the grader itself.
#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <cmath>

#include "core/curves.h"
#include "core/output_folder.h"
#include "gl/context.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace penumbra {
namespace {

constexpr double kFar = 10000, kDistance = 1000;
constexpr int kSide = 64, kPoints = kSide * kSide;  // a point a pixel

constexpr const char* kVertex = R"(
layout(location = 0) in float distance;
uniform vec2 row;   // clip z = row.x * distance + row.y
uniform float side;
void main() {
    vec2 pixel = vec2(gl_VertexID % int(side), gl_VertexID / int(side)) + 0.5;
    gl_Position = vec4((2.0 * pixel / side - 1.0) * distance, row.x * distance + row.y, distance);
}
)";

struct Format {
    const char* name;
    GLenum format;
    bool reversed, zeroToOne;
};

class DepthStage {
public:
    DepthStage() : context_(createHeadlessContext()) {
        clipControl_ = reinterpret_cast<ClipControl>(
            context_->extension("GL_ARB_clip_control", "glClipControl"));
        const auto folder = GradingSession::current().scratch();
        writeText(folder / "distance.vert", kVertex);
        writeText(folder / "nothing.frag", "void main() {}\n");
        shaders_ = std::make_unique<ShaderLibrary>(Layers({folder}));
        glGenVertexArrays(1, &array_), glGenBuffers(1, &buffer_);
    }
    ~DepthStage() {
        glDeleteVertexArrays(1, &array_), glDeleteBuffers(1, &buffer_);
        shaders_.reset();
    }
    DepthStage(const DepthStage&) = delete;
    DepthStage& operator=(const DepthStage&) = delete;

    bool hasClipControl() const { return clipControl_ != nullptr; }

    // The least difference in distance that gets another depth, around kDistance; infinite if all
    // from half of it to one and a half get one or two.
    double resolution(const Format& format, double nearPlane) {
        double distinct = 0, span = 0;
        for (span = 1e-6 * kDistance; span <= kDistance; span *= 2) {
            distinct = double(distinctDepths(format, nearPlane, span));
            if (distinct >= 100) break;  // known to a hundredth
        }
        span = std::min(span, kDistance);
        return distinct > 2 ? span / (distinct - 1) : double(INFINITY);
    }

private:
    using ClipControl = void(GLAD_API_PTR*)(GLenum, GLenum);

    std::size_t distinctDepths(const Format& format, double n, double span) {
        std::vector<float> distances;
        for (int i = 0; i < kPoints; ++i)
            distances.push_back(float(kDistance + span * ((i + 0.5) / kPoints - 0.5)));
        const Texture depth({.size = {kSide, kSide}, .format = format.format, .label = "depth"});
        const Framebuffer target({.depth = &depth});
        target.clear({0, 0, 0, 0}, 1.0f);
        const dvec2 standard = format.zeroToOne ? dvec2(kFar, -kFar * n) / (kFar - n)
                                                : dvec2(kFar + n, -2 * kFar * n) / (kFar - n);
        dvec2 row = standard;  // reversed: 1 - z, or -z where clip space is symmetric
        if (format.reversed) row = dvec2(format.zeroToOne ? 1 : 0, 0) - standard;
        if (format.zeroToOne) clipControl_(GL_LOWER_LEFT, 0x935F);  // GL_ZERO_TO_ONE
        const Program& program = shaders_->program("distance.vert", "nothing.frag");
        program.use();
        program.set("row", glm::vec2(row));
        program.set("side", float(kSide));
        glBindVertexArray(array_);
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(sizeof(float) * distances.size()),
                     distances.data(), GL_STREAM_DRAW);
        glVertexAttribPointer(0, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
        glEnableVertexAttribArray(0);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_ALWAYS);
        glDepthMask(GL_TRUE);
        glDrawArrays(GL_POINTS, 0, kPoints);
        if (format.zeroToOne) clipControl_(GL_LOWER_LEFT, 0x935E);  // GL_NEGATIVE_ONE_TO_ONE
        throwOnGlErrors();
        std::vector<float> depths = depth.readTexels();
        std::sort(depths.begin(), depths.end());
        return std::size_t(std::unique(depths.begin(), depths.end()) - depths.begin());
    }

    using dvec2 = glm::dvec2;
    std::unique_ptr<Context> context_;
    std::unique_ptr<ShaderLibrary> shaders_;
    ClipControl clipControl_ = nullptr;
    GLuint array_ = 0, buffer_ = 0;
};

CURVE(depth_precision) {
    DepthStage stage;
    std::vector<Format> formats{{"16 bits", GL_DEPTH_COMPONENT16, false, false},
                                {"24 bits", GL_DEPTH_COMPONENT24, false, false},
                                {"float", GL_DEPTH_COMPONENT32F, false, false},
                                {"reversed, z −1…1", GL_DEPTH_COMPONENT32F, true, false}};
    if (stage.hasClipControl())
        formats.push_back({"reversed, z 0…1", GL_DEPTH_COMPONENT32F, true, true});
    Curve curve{.title = "What a depth format tells apart at 1000, far plane at 10 000",
                .says =
                    "Between near and far plane all but one lose what lies far away; a float "
                    "reversed keeps it, if clip space runs from 0 to 1.",
                .x = {"far / near", true},
                .panels = {{{"least difference in distance", true}, {}}}};
    auto& series = curve.panels[0].series;
    for (const Format& format : formats) {
        series.push_back({.name = format.name});
        for (double ratio = 20; ratio < 2e6; ratio *= std::sqrt(10.0))
            series.back().points.emplace_back(ratio, stage.resolution(format, kFar / ratio));
        // the last at a far / near of a million
        series.back().points.back() = {1e6, stage.resolution(format, kFar / 1e6)};
    }
    // Where the last but one was measured: there the span is so short that distances round alike.
    const std::size_t at = series[0].points.size() - 2;
    const double n = kFar / series[0].points[at].x;
    const double step = kDistance * kDistance * (kFar - n) / (kFar * n) * std::ldexp(1.0, -24);
    const double in24Bits = series[1].points[at].y / step, inFloats = series[2].points[at].y / step,
                 reversedAlone = series[3].points[at].y / step;
    EXPECT_VALUE(std::abs(in24Bits - 1), LessOrEqual, 0.1, "w² (f - n) / (f n) times 2^-24");
    EXPECT_VALUE(std::abs(inFloats - 1), LessOrEqual, 0.1,
                 "floats just below 1 are 2^-24 apart: no better than 24 bits");
    EXPECT_VALUE(reversedAlone, GreaterOrEqual, 0.45,
                 "z / w just above -1 is rounded to 2^-24 before it is halved: half a step");
    if (stage.hasClipControl())
        EXPECT_VALUE(series[4].points.back().y, LessOrEqual, 4 * std::ldexp(kDistance, -24),
                     "a float's relative rounding of distance and depth, whatever the near plane");
    return curve;
}

}  // namespace
}  // namespace penumbra
