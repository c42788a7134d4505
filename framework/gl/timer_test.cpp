#include "gl/timer.h"

#include <thread>

#include "gl/test_context.h"

namespace penumbra {
namespace {

class PassTimerTest : public testing::GlTest {};

TEST_F(PassTimerTest, TimingsOfOnePassAddUp) {
    if (usesTimerQueries()) GTEST_SKIP() << "a GPU's queries do not count sleep";
    double milliseconds = 0;
    for (int i = 0; i < 2; ++i) {
        const PassTimer timing(milliseconds);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_GE(milliseconds, 10.0);
}

TEST_F(PassTimerTest, ASoftwareRasteriserIsNotTimedByQueries) {
    EXPECT_EQ(usesTimerQueries(), !context_->software());
}

}  // namespace
}  // namespace penumbra
