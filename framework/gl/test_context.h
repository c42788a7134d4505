// A GL context for the tests of one file, or a skip where the machine has none.
//
//   class Texture : public GlTest {};   TEST_F(TextureTest, …)
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "core/error.h"
#include "gl/context.h"

namespace penumbra::testing {

class GlTest : public ::testing::Test {
protected:
    void SetUp() override {
        try {
            context_ = createHeadlessContext();
        } catch (const Error& e) {
            GTEST_SKIP() << e.what();
        }
    }
    void TearDown() override {
        if (context_) {
            EXPECT_NO_THROW(throwOnGlErrors());
        }
        context_.reset();
    }

    std::unique_ptr<Context> context_;
};

}  // namespace penumbra::testing
