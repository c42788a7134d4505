#include "core/cache_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

namespace penumbra {
namespace {

#ifndef _WIN32  // no setenv

// Sets a variable, or takes it away, until the end of the test.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        value ? setenv(name, value, 1) : unsetenv(name);
    }
    ~Variable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
    std::optional<std::string> before_;
};

TEST(CacheFolder, IsTheFirstOfFourPlacesThatIsNamed) {
    const Variable home("HOME", "/home/ada"), windows("LOCALAPPDATA", nullptr);
    const Variable none("XDG_CACHE_HOME", nullptr), empty("PENUMBRA_CACHE", "");
    EXPECT_EQ(cacheFolder(), "/home/ada/.cache/penumbra");
    const Variable relative("XDG_CACHE_HOME", "cache");  // the standard says: to be ignored
    EXPECT_EQ(cacheFolder(), "/home/ada/.cache/penumbra");
    const Variable xdg("XDG_CACHE_HOME", "/var/cache");
    EXPECT_EQ(cacheFolder(), "/var/cache/penumbra");
    const Variable ours("PENUMBRA_CACHE", "here");
    EXPECT_EQ(cacheFolder(), "here");
}

#endif

}  // namespace
}  // namespace penumbra
