// What `--config` may say, and what it stands for.
#include "lab/cli/config_option.hpp"

#include <gtest/gtest.h>

namespace glint::cli {
namespace config_option_test {

using Strings = std::vector<std::string>;

render::SettingsRequest read(std::string_view text) {
    auto request = readConfig(text);
    EXPECT_TRUE(request.ok()) << text << ": " << (request.ok() ? "" : request.error().message);
    return request.ok() ? *request : render::SettingsRequest();
}

TEST(ConfigOption, ABaseAssignmentsOrBoth) {
    EXPECT_EQ(read("babylon").preset, "babylon");
    EXPECT_TRUE(read("babylon").assignments.empty());
    EXPECT_EQ(read("my/own+tune,d.json").file, "my/own+tune,d.json");
    EXPECT_EQ(read("screen.step=4,fade.border=none").assignments, (Strings{"screen.step=4", "fade.border=none"}));
    EXPECT_EQ(read("screen.step=4,fade.border=none").preset, "");
    for (const char* text : {"compute-ssr+screen.step=4,thickness=0.5", "compute-ssr,screen.step=4,thickness=0.5"}) {
        EXPECT_EQ(read(text).preset, "compute-ssr");
        EXPECT_EQ(read(text).assignments, (Strings{"screen.step=4", "thickness=0.5"}));
    }
    EXPECT_EQ(read("a.json+screen.step=4").file, "a.json");
    EXPECT_EQ(read("a.json+screen.step=4").assignments, Strings{"screen.step=4"});
}

TEST(ConfigOption, APlusInAValueIsTheValues) {
    EXPECT_EQ(read("screen.maxDistance=1e+3").assignments, Strings{"screen.maxDistance=1e+3"});
    EXPECT_EQ(read("fast+screen.maxDistance=1e+3").assignments, Strings{"screen.maxDistance=1e+3"});
}

TEST(ConfigOption, AMeanOfFramesCannotBeCompared) {
    const auto job = makeConfigJob({}, "builtin:exact", "fast,display.antialias=accumulate");
    ASSERT_FALSE(job.ok());
    EXPECT_EQ(job.error().code, ErrorCode::InvalidArgument);
    EXPECT_EQ(job.error().message,
              "--config fast,display.antialias=accumulate: display.antialias accumulate is for glint render and glint "
              "view; what compares settings measures single frames: none, fxaa or msaa4");
}
TEST(ConfigOption, WhatCannotBeReadIsNamed) {
    for (const std::string text :
         {"", "slow", "babylon+", "babylon,", "fast,balanced", "fast+step", "=4", "a=1,,b=2"}) {
        const auto request = readConfig(text);
        ASSERT_FALSE(request.ok()) << text;
        EXPECT_EQ(request.error().code, ErrorCode::InvalidArgument);
        EXPECT_TRUE(request.error().message.starts_with("--config " + text + ": ")) << request.error().message;
    }
    EXPECT_NE(readConfig("slow").error().message.find("babylon, balanced"), std::string::npos);
}

} // namespace config_option_test
} // namespace glint::cli
