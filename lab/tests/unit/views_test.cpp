// Views: every one that the library offers has a way to be shown, and values become the colours that the kind promises.
#include "lab/session/views.hpp"

#include "base/file.hpp"
#include "glint/reflections.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace glint::render {
namespace views_test {

using Bytes = std::vector<uint8_t>;

Bytes shown(ViewKind kind, float r, float g, float b) {
    const float rgba[] = {r, g, b, 1};
    return displayBytes(kind, rgba);
}

TEST(Views, EveryViewOfTheLibraryIsListed) {
    for (const std::string_view name : Reflections::viewNames())
        EXPECT_TRUE(findView(name).ok()) << name;
    EXPECT_EQ(viewList().front().name, "composite");
}

TEST(Views, TheCommittedPageIsTheGeneratedOne) {
    const auto page = readFile(GLINT_SOURCE_DIR "/docs/views.md", 1 << 20);
    ASSERT_TRUE(page.ok()) << page.error().message;
    EXPECT_EQ(*page, viewsPage()) << "run: scripts/glint views --markdown > docs/views.md";
}

TEST(Views, UnknownNamesGetTheNearest) {
    const std::string message = findView("dept").error().message;
    EXPECT_EQ(message.substr(0, 44), "unknown view 'dept'; did you mean 'depth'? t");
}

TEST(Views, ValuesBecomeColors) {
    EXPECT_EQ(shown(ViewKind::Fraction, 0, 0.5f, 2), (Bytes{0, 128, 255}));
    EXPECT_EQ(shown(ViewKind::Direction, -1, 0, 1), (Bytes{0, 128, 255}));
    EXPECT_EQ(shown(ViewKind::Distance, 0, 0, 0), (Bytes{0, 0, 0}));
    EXPECT_EQ(shown(ViewKind::Distance, 5, 5, 5), (Bytes{128, 128, 128}));
    EXPECT_EQ(shown(ViewKind::Motion, 0, 1 / 16.f, -1), (Bytes{128, 255, 0}));
    EXPECT_EQ(shown(ViewKind::Motion, 1 / 64.f, -1 / 64.f, 0), (Bytes{191, 64, 128}));
    EXPECT_EQ(shown(ViewKind::Count, 0, 0, 0), (Bytes{0, 0, 0}));
    EXPECT_EQ(shown(ViewKind::Count, 4096, 4096, 4096), (Bytes{255, 0, 0}));
    EXPECT_EQ(shown(ViewKind::Count, 63, 63, 63), (Bytes{0, 255, 0})); // the middle of the logarithmic scale
}

TEST(Views, WhatIsNoNumberIsMagentaAndInfinityIsTheEnd) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(shown(ViewKind::Fraction, nan, 0, 0), (Bytes{255, 0, 255}));
    EXPECT_EQ(shown(ViewKind::Fraction, inf, -inf, 0), (Bytes{255, 0, 0}));
    EXPECT_EQ(shown(ViewKind::Distance, inf, inf, inf), (Bytes{0, 0, 0}));
}

} // namespace views_test
} // namespace glint::render
