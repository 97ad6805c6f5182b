// A folder of one test alone, gone with it. CTest runs several tests at once, each in a process of its own: a folder
// that two of them share is emptied by the first to end.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace glint::test {

class TempFolder {
public:
    TempFolder() {
        if (mkdtemp(path_.data()) == nullptr)
            throw std::runtime_error(path_ + ": no folder can be made there");
        path_ += '/';
    }
    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    /// Ends in a slash.
    const std::string& path() const { return path_; }
    std::string operator+(const std::string& name) const { return path_ + name; }

private:
    std::string path_ = testing::TempDir() + "glint_XXXXXX";
};

} // namespace glint::test
