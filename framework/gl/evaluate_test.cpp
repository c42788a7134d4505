#include "gl/evaluate.h"

#include "core/test_folder.h"
#include "gl/test_context.h"

namespace penumbra {
namespace {

using testing::TestFolder;

class EvaluateTest : public testing::GlTest {
protected:
    TestFolder folder_;
    Layers layers_{{folder_.path()}};
};

TEST_F(EvaluateTest, ReturnsTheRowOfEachInput) {
    folder_.write("chunk.glsl", "float twice(float x) { return 2.0 * x; }\n");
    Image a(100, 2, 4), b(100, 2, 4);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 100; ++x) {
            a.at(x, y, 0) = float(x) + 1000.0f * float(y);
            b.at(x, y, 3) = 0.125f * float(x);
        }
    const Image result = evaluateGlsl(layers_, "chunk.glsl", "vec4(twice(a.x), b.w, 0.0, 1.0)",
                                      {{"a", a}, {"b", b}});
    ASSERT_TRUE(result.sameShape(a));
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 100; ++x) {
            EXPECT_EQ(result.at(x, y, 0), 2 * a.at(x, y, 0));
            EXPECT_EQ(result.at(x, y, 1), b.at(x, y, 3));
        }
}

TEST_F(EvaluateTest, AnErrorCarriesTheChunksLine) {
    folder_.write("inner.glsl", "// one\n// two\nfloat half_(float x) { return 0.5 * y; }\n");
    folder_.write("chunk.glsl", "#include \"inner.glsl\"\n");
    try {
        evaluateGlsl(layers_, "chunk.glsl", "vec4(half_(a.x))", {{"a", Image(1, 1, 4)}});
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("inner.glsl:3: "), std::string::npos) << e.what();
    }
}

TEST_F(EvaluateTest, AFunctionThatIsMissingIsAnError) {
    folder_.write("chunk.glsl", "// nothing\n");
    EXPECT_THROW(evaluateGlsl(layers_, "chunk.glsl", "vec4(bias(a.x))", {{"a", Image(1, 1, 4)}}),
                 Error);
}

}  // namespace
}  // namespace penumbra
