// Where the sample models lie. They are not part of the repository: tests that want them skip where they are absent.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace glint::test {

inline std::filesystem::path assetsFolder() {
    const char* chosen = std::getenv("GLINT_ASSETS");
    return chosen ? std::filesystem::path(chosen) : std::filesystem::path(GLINT_SOURCE_DIR "/../shared/assets");
}

} // namespace glint::test

/// First line of a test that reads `name`, a path below the assets' folder; declares `path`.
#define GLINT_NEED_ASSET(path, name)                                                                                   \
    const std::string path = (glint::test::assetsFolder() / (name)).string();                                          \
    if (!std::filesystem::exists(path))                                                                                \
    GTEST_SKIP() << "no " << path << "; set GLINT_ASSETS to the folder of the sample assets"
