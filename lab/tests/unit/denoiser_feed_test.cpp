// The feed of other denoisers, from views whose answers are known.
#include "lab/measure/motion/denoiser_feed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace glint::measure {
namespace denoiser_feed_test {

using Pixel = std::array<float, 4>;

/// The feed of one pixel.
class OnePixel {
public:
    OnePixel() {
        for (std::string& name : feedViews(Settings()))
            views_.push_back({std::move(name), std::vector<float>(4, 0.0f), {}});
    }
    OnePixel& with(std::string_view view, const Pixel& value) {
        const auto found = std::ranges::find(views_, view, &render::RenderedView::name);
        EXPECT_NE(found, views_.end()) << view;
        found->rgba.assign(value.begin(), value.end());
        return *this;
    }
    Pixel layer(std::string_view name) const {
        const auto found = std::ranges::find(feedLayers(), name, &FeedLayer::name);
        EXPECT_NE(found, feedLayers().end()) << name;
        const std::vector<float> pixel = feedPixels(views_)[static_cast<size_t>(found - feedLayers().begin())];
        return {pixel[0], pixel[1], pixel[2], pixel[3]};
    }

private:
    std::vector<render::RenderedView> views_;
};

/// As a view shows the bits of 1 / distance.
float shownBits(float nearness) {
    return static_cast<float>(std::bit_cast<uint32_t>(nearness));
}

TEST(DenoiserFeed, DistancesSurviveTheirWayThroughAnInteger) {
    for (const float distance : {0.001f, 0.37f, 1.0f, 2.5f, 17.3f, 900.0f})
        EXPECT_NEAR(sentDistance(shownBits(1 / distance)), distance, 2e-5f * distance);
    EXPECT_EQ(sentDistance(shownBits(0)), 0);  // it hit nothing
    EXPECT_EQ(sentDistance(shownBits(-1)), 0); // none was sent
    EXPECT_EQ(sentDistance(shownBits(-2)), 0); // nor here, where neighbours' rays are taken
    EXPECT_EQ(sentDistance(std::numeric_limits<float>::quiet_NaN()), 0);
    EXPECT_EQ(sentDistance(4294967296.0f), 0);
}

TEST(DenoiserFeed, PixelsWithoutARayHaveNoSignal) {
    OnePixel pixel;
    pixel.with("denoise/gather:noisy", {3, 2, 1, 0.5f}).with("denoise/gather:sentRay", {0, shownBits(0.25f), 0, 1});
    for (const float sent : {0.0f, 0.25f}) { // 0.25: waits for its neighbours' rays
        pixel.with("raySent", {sent, sent, sent, 1});
        EXPECT_EQ(pixel.layer("noisy"), (Pixel{0, 0, 0, 0}));
        EXPECT_EQ(pixel.layer("hitDistance")[0], 0);
        EXPECT_EQ(pixel.layer("raySent")[0], sent);
    }
    pixel.with("raySent", {1, 1, 1, 1});
    EXPECT_EQ(pixel.layer("noisy"), (Pixel{3, 2, 1, 0.5f}));
    EXPECT_EQ(pixel.layer("hitDistance")[0], 4);
}

TEST(DenoiserFeed, TheRestIsWhatOtherSourcesAdd) {
    OnePixel pixel;
    pixel.with("denoise/filter:answer", {8, 4, 2, 0.75f}).with("reflection", {7, 4, 1, 1});
    // The environment took the remaining weight; ten bits tell the shares.
    pixel.with("weights", {0, 256 / 1023.0f, 767 / 1023.0f, 0});
    EXPECT_EQ(pixel.layer("rest"), (Pixel{1, 1, 0, 0})); // never negative
    // A planar mirror before the denoised answer leaves half of the weight.
    pixel.with("weights", {0, 0, 512 / 1023.0f, 0}).with("weightPlanar", {0.5f, 0.5f, 0.5f, 1});
    EXPECT_NEAR(pixel.layer("rest")[0], 7 - 8 * 0.5f, 0.01f);
    // Nothing else took part: what differs is rounding.
    pixel.with("weights", {0.5f, 0, 0, 0}).with("weightPlanar", {0, 0, 0, 1});
    EXPECT_EQ(pixel.layer("rest"), (Pixel{0, 0, 0, 0}));
    // Where nothing is denoised, all of it.
    pixel.with("denoise/filter:answer", {0, 0, 0, 0}).with("weights", {0, 1, 0, 0});
    EXPECT_EQ(pixel.layer("rest"), (Pixel{7, 4, 1, 0}));
}

TEST(DenoiserFeed, WhatIsStabilizedIsNoRest) {
    Settings settings;
    settings.denoise.stabilizeSeconds = 1;
    std::vector<render::RenderedView> views;
    for (std::string& name : feedViews(settings)) {
        const bool shown = name == "reflection" || name == "denoise/stabilize:answer";
        const bool weights = name == "weights";
        views.push_back({std::move(name), std::vector<float>(4, shown ? 1.0f : weights ? 0.5f : 0.0f), {}});
    }
    const auto layer = std::ranges::find(feedLayers(), "rest", &FeedLayer::name);
    // Half of the answer's weight is the screen's: reflection - 0.5 * answer, and with the rays' half nothing.
    EXPECT_NEAR(feedPixels(views)[static_cast<size_t>(layer - feedLayers().begin())][0], 0, 1e-3);
}

TEST(DenoiserFeed, EveryLayerIsDescribed) {
    EXPECT_EQ(feedPixels([] {
                  std::vector<render::RenderedView> views;
                  for (std::string& name : feedViews(Settings()))
                      views.push_back({std::move(name), std::vector<float>(8, 0.0f), {}});
                  return views;
              }())
                  .size(),
              feedLayers().size());
    for (const FeedLayer& layer : feedLayers()) {
        EXPECT_FALSE(layer.channels.empty()) << layer.name;
        EXPECT_GT(layer.meaning.size(), 5u) << layer.name;
    }
}

} // namespace denoiser_feed_test
} // namespace glint::measure
