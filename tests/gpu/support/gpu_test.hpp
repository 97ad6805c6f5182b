// Base of every GPU test: one device for the whole program, validation and synchronization checks on, and any message
// from them fails the test that caused it.
#pragma once

#include "glint/context.hpp"
#include "gpu/transfer.hpp"
#include "support/must.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace glint::test {

class GpuTest : public testing::Test {
protected:
    /// The device of our own programs; created at first use, kept to the end.
    static gpu::Context& gpu();
    /// The same device as a host provides it to the library.
    static Context& library();

    void SetUp() override;
    void TearDown() override;

    /// Records, submits and waits.
    static void run(const std::function<void(VkCommandBuffer)>& record) { must(gpu().submitAndWait(record)); }

private:
    size_t messagesBefore_ = 0;
};

} // namespace glint::test
