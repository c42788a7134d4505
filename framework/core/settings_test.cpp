#include "core/settings.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace penumbra {
namespace {

Settings dials() {
    Settings s;
    s.number(
        {.name = "bias", .help = "depth bias", .unit = "texels", .maximum = 16, .value = 0.25});
    s.integer({.name = "taps", .help = "samples", .minimum = 1, .maximum = 64, .value = 16});
    s.toggle({.name = "fit", .help = "fit the map", .value = 1});
    s.choice({.name = "filter", .help = "filter", .value = 1, .choices = {"off", "2x2"}});
    return s;
}

std::string complaint(const std::string& assignment) {
    try {
        dials().assign(assignment);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST(Settings, StartAtTheirDeclaredValues) {
    const Settings s = dials();
    EXPECT_EQ(s["bias"], 0.25f);
    EXPECT_EQ(s["taps"], 16.0f);
    EXPECT_TRUE(s.on("fit"));
    EXPECT_EQ(s.chosen("filter"), "2x2");
}

TEST(Settings, TakeWhatTheCommandLineWrites) {
    Settings s = dials();
    for (const char* text : {"bias=1.5", "taps=4", "fit=off", "filter=off"}) s.assign(text);
    EXPECT_EQ(s["bias"], 1.5f);
    EXPECT_EQ(s.index("taps"), 4);
    EXPECT_FALSE(s.on("fit"));
    EXPECT_EQ(s.chosen("filter"), "off");
}

TEST(Settings, ThatPlayAdvanceAndStartAnewAtTheirEnd) {
    Settings s = dials();
    EXPECT_FALSE(s.advance(0.5));
    s.number({.name = "time", .help = "moment", .unit = "s", .maximum = 2, .plays = true});
    EXPECT_TRUE(s.advance(1.5));
    EXPECT_EQ(s["time"], 1.5f);
    EXPECT_TRUE(s.advance(0.75));
    EXPECT_EQ(s["time"], 0.0f);
    EXPECT_EQ(s["bias"], 0.25f);
}

TEST(Settings, KeepTheDeclaredValueForAReset) {
    Settings s = dials();
    s.assign("bias=3");
    EXPECT_EQ(s.all()[0].value, 3.0);
    EXPECT_EQ(s.all()[0].initial, 0.25);
}

TEST(Settings, TextIsWhatAssignReads) {
    Settings s = dials();
    s.assign("bias=0.1");
    for (const Setting& setting : s.all()) {
        Settings copy = dials();
        copy.assign(setting.name + "=" + Settings::text(setting));
        EXPECT_EQ(copy[setting.name], s[setting.name]) << setting.name;
    }
}

TEST(Settings, AnErrorNamesTheSettingAndItsRange) {
    EXPECT_EQ(complaint("bias=17"),
              "17 is out of range: setting bias; give a value from 0 to 16 texels");
    EXPECT_EQ(complaint("taps=2.5"),
              "'2.5' is not a whole number: setting taps; give a value from 1 to 64");
    EXPECT_EQ(complaint("filter=3x3"),
              "no such choice '3x3': setting filter; choose one of off, 2x2");
    EXPECT_EQ(complaint("bais=1"),
              "unknown setting 'bais': --set; choose one of bias, taps, fit, filter");
}

TEST(Settings, RefuseWhatIsNoNumber) {
    for (const char* text :
         {"bias=", "bias=nan", "bias=inf", "bias=1e999", "bias=1x", "bias= 1", "fit=yes", "fit=0.5",
          "taps=", "filter=", "filter=1", "bias", "=1", ""})
        EXPECT_NE(complaint(text), "") << text;
}

TEST(Settings, AFailedAssignmentChangesNothing) {
    Settings s = dials();
    EXPECT_THROW(s.assign("bias=99"), Error);
    EXPECT_EQ(s["bias"], 0.25f);
}

}  // namespace
}  // namespace penumbra
