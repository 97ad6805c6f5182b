// Files appear whole under their name, or not at all.
#include "base/file.hpp"
#include "support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <filesystem>
#include <thread>

namespace glint {
namespace file_test {

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

TEST_F(FileTest, ALinkStaysALinkAndAFileKeepsItsPermissions) {
    namespace fs = std::filesystem;
    ASSERT_TRUE(writeFile(folder_ + "a", "old").ok());
    fs::permissions(folder_ + "a", fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_exec);
    fs::create_directory(folder_ + "inner");
    fs::create_symlink("../a", folder_ + "inner/link");
    fs::create_symlink("nowhere", folder_ + "dangling");
    ASSERT_TRUE(writeFile(folder_ + "inner/link", "new").ok());
    ASSERT_TRUE(writeFile(folder_ + "dangling", "made").ok());
    EXPECT_TRUE(fs::is_symlink(folder_ + "inner/link"));
    EXPECT_EQ(*readFile(folder_ + "a", 10), "new");
    EXPECT_EQ(fs::status(folder_ + "a").permissions(),
              fs::perms::owner_read | fs::perms::owner_write | fs::perms::others_exec);
    EXPECT_EQ(*readFile(folder_ + "nowhere", 10), "made");
}

TEST_F(FileTest, DevicesAndPipesAreWrittenInPlace) {
    EXPECT_TRUE(writeFile("/dev/null", "gone").ok());
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_EQ(writeFile("/dev/full", "1").error().message, "/dev/full: No space left on device");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));

    const std::string pipe = folder_ + "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::string read;
    std::thread reader([&] { read = *readFile(pipe, 10); });
    {
        FileInMaking making(pipe); // as the writers of EXR files do
        EXPECT_TRUE(writeFile(making.temporaryPath(), "through").ok());
        EXPECT_TRUE(making.commit().ok());
    }
    reader.join();
    EXPECT_EQ(read, "through");
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
    EXPECT_EQ(filesInFolder(), 1u);
}

} // namespace file_test
} // namespace glint
