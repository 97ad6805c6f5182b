// The program `glint` with a display of its own: Xvfb, which ends with the test.
#pragma once

#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

namespace glint::test {

struct Ended {
    int code = -1; ///< 128 + the signal that ended it; -1: it had to be ended after kLongestSeconds
    std::string out;
    std::string error;
};

/// A program that runs beside the test.
class Running {
public:
    static constexpr double kLongestSeconds = 120;

    /// `environment`  "NAME=VALUE", or "NAME" alone to take it away
    Running(const std::vector<std::string>& command, const std::string& folder,
            const std::vector<std::string>& environment);
    ~Running();
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    bool runs();
    Ended wait();
    long residentKilobytes() const; ///< of the program itself; 0: it has ended

private:
    pid_t pid_ = -1;
    std::string outPath_;
    std::string errorPath_;
    int status_ = 0;
};

/// Skips where there is no Xvfb.
class WindowTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    /// `glint ARGUMENTS` in `folder_`, on the test's own display, with more of an environment; of two frames unless the
    /// arguments say how many.
    std::unique_ptr<Running> start(std::vector<std::string> arguments, std::vector<std::string> environment = {});
    Ended run(std::vector<std::string> arguments) { return start(std::move(arguments))->wait(); }
    /// `glint view builtin:exact --size 320x180 --validate --script ...`, with more arguments.
    Ended runScript(const std::string& script, std::vector<std::string> arguments = {});
    /// `xdotool ARGUMENTS`
    Ended tool(std::vector<std::string> arguments);
    std::string path(const std::string& name) const { return folder_ + name; }
    std::string bytes(const std::string& name) const;           ///< of a file in the folder; empty: there is none
    bool waitFor(const std::string& name, double seconds = 30); ///< a file in the folder
    /// Until the window of `glint view SCENE` can be seen; its number, as xdotool has it.
    std::string waitForWindow(const std::string& scene);
    void endDisplay(); ///< under the feet of whoever is on it

    TempFolder folder_;

private:
    pid_t server_ = -1;
    std::string display_;
};

} // namespace glint::test
