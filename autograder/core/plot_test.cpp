#include "core/plot.h"

#include <gtest/gtest.h>

#include <cmath>

namespace penumbra {
namespace {

int countOf(const std::string& text, const std::string& part) {
    int count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

std::string drawn(bool log) {
    return curveSvg(
        {.title = "a < b",
         .says = "",
         .x = {"x"},
         .panels = {{{"y", log}, {{"s", {{1, 5}, {2, 0}, {3, NAN}, {4, INFINITY}, {5, 7}}}}}}});
}

TEST(Plot, NoPointIsDroppedSilently) {
    const std::string svg = drawn(true);
    EXPECT_EQ(countOf(svg, "<circle"), 2);
    EXPECT_EQ(countOf(svg, "<title>0</title>"), 1);  // a logarithm has no place for it
    EXPECT_EQ(countOf(svg, "<title>NaN</title>"), 1);
    EXPECT_EQ(countOf(svg, "<title>infinite</title>"), 1);
    EXPECT_EQ(countOf(drawn(false), "<circle"), 3);
}

TEST(Plot, EscapesItsWordsAndNamesItsNumbers) {
    const std::string svg = drawn(false);
    EXPECT_NE(svg.find("a &lt; b"), std::string::npos);
    EXPECT_EQ(svg.find("=\"nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf "), std::string::npos);
}

}  // namespace
}  // namespace penumbra
