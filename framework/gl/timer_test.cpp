#include "gl/timer.h"

#include <cmath>
#include <thread>

#include "gl/test_context.h"

namespace penumbra {
namespace {

class TimesTest : public testing::GlTest {};

void sleepMilliseconds(int count) { std::this_thread::sleep_for(std::chrono::milliseconds(count)); }

TEST_F(TimesTest, TimingsOfOneNameAddUp) {
    Times times;
    for (int i = 0; i < 2; ++i) {
        const auto timing = times.time("pass");
        sleepMilliseconds(5);
    }
    EXPECT_GE(times.milliseconds().at("pass"), 10.0);
}

TEST_F(TimesTest, ASoftwareRasteriserIsNotTimedByQueries) {
    EXPECT_EQ(usesTimerQueries(), !context_->software());
}

// A software rasteriser's timestamps tell no pass's time, but pass through the same plumbing.
TEST_F(TimesTest, TimestampsNestAndAreReadOnce) {
    Times times(true);
    {
        const auto frame = times.time("frame");
        for (const char* pass : {"light", "shade", "light"}) {
            const auto timing = times.time(pass);
            glClear(GL_COLOR_BUFFER_BIT);
            sleepMilliseconds(2);
        }
    }
    const auto first = times.milliseconds(), again = times.milliseconds();
    ASSERT_EQ(first.size(), 3u);
    for (const auto& [name, ms] : first) {
        EXPECT_TRUE(std::isfinite(ms) && ms >= 0) << name << " " << ms;
        EXPECT_EQ(ms, again.at(name));
    }
    // A timestamp counts nanoseconds: rounding of eight of them.
    EXPECT_LE(first.at("light") + first.at("shade"), first.at("frame") + 1e-5);
    EXPECT_GE(first.at("frame"), 6.0);  // the processor's work between begin and end counts
}

TEST_F(TimesTest, TimesThatNobodyReadsLeaveNoQueries) {
    GLuint query = 0;
    {
        Times times(true);
        { const auto timing = times.time("pass"); }
        const Times moved = std::move(times);
        glGenQueries(1, &query);  // names of the two before it
        ASSERT_TRUE(glIsQuery(query - 1) && glIsQuery(query - 2));
    }
    EXPECT_FALSE(glIsQuery(query - 1) || glIsQuery(query - 2));
    glDeleteQueries(1, &query);
}

}  // namespace
}  // namespace penumbra
