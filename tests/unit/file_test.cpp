// Files appear whole under their name, or not at all.
#include "base/file.hpp"
#include "support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace glint {
namespace {

class FileTest : public testing::Test {
protected:
    size_t filesInFolder() const {
        return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder_), {}));
    }
    const test::TempFolder temp_;
    const std::string& folder_ = temp_.path();
};

TEST_F(FileTest, ReadsBackWhatItWrote) {
    const std::string bytes("a\0b\n\xff", 5);
    ASSERT_TRUE(writeFile(folder_ + "a", bytes).ok());
    const auto read = readFile(folder_ + "a", 5);
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(*read, bytes);
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(FileTest, AFileThatIsTooLongIsNotRead) {
    ASSERT_TRUE(writeFile(folder_ + "a", "12345").ok());
    EXPECT_EQ(readFile(folder_ + "a", 4).error().message, folder_ + "a: the file is longer than 4 bytes");
}

TEST_F(FileTest, ErrorsNameThePathAndTheReason) {
    EXPECT_EQ(readFile(folder_ + "none", 1).error().code, ErrorCode::NotFound);
    EXPECT_EQ(writeFile(folder_ + "none/a", "1").error().message, folder_ + "none/a: No such file or directory");
    EXPECT_FALSE(writeFile(folder_, "1").ok());
    EXPECT_EQ(filesInFolder(), 0u);
}

TEST_F(FileTest, WithoutACommitTheOldFileStays) {
    ASSERT_TRUE(writeFile(folder_ + "a", "old").ok());
    {
        FileInMaking making(folder_ + "a");
        ASSERT_TRUE(writeFile(making.temporaryPath(), "new").ok());
    }
    EXPECT_EQ(*readFile(folder_ + "a", 10), "old");
    EXPECT_EQ(filesInFolder(), 1u);
}

} // namespace
} // namespace glint
