#include "lab/cli/child_process.hpp"

#include <gtest/gtest.h>

namespace glint::cli {
namespace child_process_test {

TEST(ChildProcess, BothOutputsAndTheCodeComeBack) {
    const auto said = runChild({"sh", "-c", "printf out; printf wrong >&2; exit 3"});
    ASSERT_TRUE(said);
    EXPECT_EQ(said->code, 3);
    EXPECT_EQ(said->out, "out");
    EXPECT_EQ(said->error, "wrong");
    const auto much = runChild({"sh", "-c", "head -c 300000 /dev/zero; head -c 300000 /dev/zero >&2; kill -9 $$"});
    ASSERT_TRUE(much);
    EXPECT_EQ(much->code, 128 + 9);
    EXPECT_EQ(much->out.size(), 300000u);
    EXPECT_EQ(much->error.size(), 300000u);
    const auto none = runChild({"no-such-program"});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::NotFound);
}

} // namespace child_process_test
} // namespace glint::cli
