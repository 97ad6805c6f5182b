#include "lab/view/open_list.hpp"
#include "lab/view/recent_files.hpp"

#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace glint::view {
namespace open_list_test {

using test::TempFolder;
using testing::ElementsAre;

std::vector<std::string> names(const std::vector<OpenEntry>& entries, OpenEntry::Kind kind) {
    std::vector<std::string> found;
    for (const OpenEntry& entry : entries)
        if (entry.kind == kind)
            found.push_back(entry.name);
    return found;
}

class OpenListTest : public testing::Test {
protected:
    OpenListTest() {
        std::filesystem::create_directories(folder_ + "rooms/deep");
        for (const char* name : {"b.glb", "A.GLTF", "sky.hdr", "notes.txt", ".hidden.glb", "rooms/hall.glb"})
            std::ofstream(folder_ + name) << "x";
        here_ = std::filesystem::path(folder_.path()).parent_path().string();
    }
    TempFolder folder_;
    std::string here_;
};

TEST_F(OpenListTest, FoldersAndFilesThatCanBeOpened) {
    const std::vector<std::string> recent = {"/elsewhere/old.glb"};
    const auto entries = openEntries(here_, "", recent);
    EXPECT_THAT(names(entries, OpenEntry::Kind::Recent), ElementsAre("/elsewhere/old.glb"));
    EXPECT_THAT(names(entries, OpenEntry::Kind::Folder), ElementsAre("../", "rooms/"));
    EXPECT_THAT(names(entries, OpenEntry::Kind::File), ElementsAre("A.GLTF", "b.glb", "sky.hdr"));
    EXPECT_THAT(names(entries, OpenEntry::Kind::Builtin), testing::Contains("builtin:hall"));
    EXPECT_EQ(entries.front().kind, OpenEntry::Kind::Recent);
}

TEST_F(OpenListTest, AFewLettersFindAndAPathCompletes) {
    EXPECT_EQ(openEntries(here_, "sky", {}).front().name, "sky.hdr");
    EXPECT_EQ(openEntries(here_, "oldglb", std::vector<std::string>{"/elsewhere/old.glb"}).front().name,
              "/elsewhere/old.glb");
    const auto inside = openEntries(here_, "rooms/h", {});
    ASSERT_EQ(inside.size(), 1u);
    EXPECT_EQ(inside.front().path, here_ + "/rooms/hall.glb");
    EXPECT_EQ(openEntries(here_, here_ + "/", {}).size(), 4u);
    EXPECT_TRUE(openEntries(here_, "none/such/", {}).empty());
}

TEST_F(OpenListTest, AFolderThatCannotBeReadHasAWayOut) {
    EXPECT_THAT(names(openEntries(here_ + "/none", "", {}), OpenEntry::Kind::Folder), ElementsAre("../"));
    EXPECT_TRUE(names(openEntries("/", "", {}), OpenEntry::Kind::Folder).front() != "../");
}

TEST_F(OpenListTest, RecentFilesAreRememberedTheNewestFirst) {
    const std::string file = folder_ + "state/glint/recent";
    RecentFiles recent(file);
    recent.add(folder_ + "b.glb");
    recent.add("builtin:hall");
    recent.add(folder_ + "rooms/../b.glb"); // the same
    EXPECT_THAT(recent.list(), ElementsAre(folder_ + "b.glb", "builtin:hall"));
    EXPECT_EQ(RecentFiles(file).list(), recent.list());
    RecentFiles other(file); // another window
    other.add("builtin:mirror");
    recent.add("builtin:exact");
    EXPECT_THAT(recent.list(), ElementsAre("builtin:exact", "builtin:mirror", folder_ + "b.glb", "builtin:hall"));
    for (int i = 0; i < 30; ++i)
        recent.add(folder_ + std::to_string(i) + ".glb");
    EXPECT_EQ(RecentFiles(file).list().size(), RecentFiles::kMost);
}

TEST_F(OpenListTest, RecentFilesDoNotNeedADisk) {
    RecentFiles recent(folder_ + "b.glb/recent"); // a file is no folder
    recent.add("builtin:hall");
    EXPECT_THAT(recent.list(), ElementsAre("builtin:hall"));
    RecentFiles nowhere;
    nowhere.add("builtin:hall");
    EXPECT_THAT(nowhere.list(), ElementsAre("builtin:hall"));
}

TEST_F(OpenListTest, TheListLiesWhereStateBelongs) {
    const char* const before = std::getenv("XDG_STATE_HOME");
    const std::string kept = before ? before : "";
    setenv("XDG_STATE_HOME", "/somewhere/state", 1);
    EXPECT_EQ(RecentFiles::usualFile(), "/somewhere/state/glint/recent");
    setenv("XDG_STATE_HOME", "relative", 1); // is to be ignored
    EXPECT_TRUE(RecentFiles::usualFile().ends_with("/.local/state/glint/recent"));
    before ? setenv("XDG_STATE_HOME", kept.c_str(), 1) : unsetenv("XDG_STATE_HOME");
}

} // namespace open_list_test
} // namespace glint::view
