// Base of tests that do whole jobs: one device for the program, and any validation message fails the test that caused
// it.
#pragma once

#include "lab/session/run_job.hpp"
#include "tests/support/must.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace glint::test {

/// The table's defaults with assignments on top: "screen.step=4", ... One frame tells more without a history, so there
/// is no denoising unless the assignments ask for it; and mirror images then end at the roughness where they are too
/// sharp.
inline render::ProgramSettings settingsOf(std::vector<std::string> assignments) {
    const auto plain = {"denoise.enabled=false", "reflect.roughnessFadeStart=0.2", "reflect.maxRoughness=0.4"};
    assignments.insert(assignments.begin(), plain.begin(), plain.end());
    return must(
        render::loadSettings({.defaults = {}, .preset = {}, .file = {}, .assignments = std::move(assignments)}));
}

class JobTest : public testing::Test {
protected:
    static gpu::Context& device() {
        static const std::unique_ptr<gpu::Context> context =
            must(gpu::Context::create({.device = {}, .validation = true}));
        return *context;
    }
    void SetUp() override { messagesBefore_ = device().validationMessages().size(); }
    void TearDown() override {
        const std::vector<std::string>& messages = device().validationMessages();
        for (size_t i = messagesBefore_; i < messages.size(); ++i)
            ADD_FAILURE() << "validation: " << messages[i];
    }

private:
    size_t messagesBefore_ = 0;
};

} // namespace glint::test
