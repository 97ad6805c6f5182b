#include "lab/tests/window/view_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

namespace glint::test {
namespace {

std::string readAll(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void pause() {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

bool onPath(const char* program) {
    std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + program).c_str(), X_OK) == 0)
            return true;
    return false;
}

/// In the child: becomes the program.
[[noreturn]] void become(const std::vector<std::string>& command) {
    std::vector<char*> argv;
    for (const std::string& word : command)
        argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    execvp(argv[0], argv.data());
    _exit(127);
}

} // namespace

Running::Running(const std::vector<std::string>& command, const std::string& folder,
                 const std::vector<std::string>& environment) {
    static int count = 0;
    outPath_ = folder + "run-" + std::to_string(++count) + ".out";
    errorPath_ = folder + "run-" + std::to_string(count) + ".err";
    pid_ = fork();
    if (pid_ != 0)
        return;
    for (const std::string& variable : environment) {
        const size_t equals = variable.find('=');
        if (equals == variable.npos)
            unsetenv(variable.c_str());
        else
            setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
    }
    const int out = open(outPath_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int error = open(errorPath_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (out < 0 || error < 0 || dup2(out, STDOUT_FILENO) < 0 || dup2(error, STDERR_FILENO) < 0 ||
        chdir(folder.c_str()) != 0)
        _exit(126);
    become(command);
}

Running::~Running() {
    if (runs()) {
        kill(pid_, SIGKILL);
        waitpid(pid_, &status_, 0);
    }
}

bool Running::runs() {
    if (pid_ > 0 && waitpid(pid_, &status_, WNOHANG) == pid_)
        pid_ = -1;
    return pid_ > 0;
}

Ended Running::wait() {
    const auto start = std::chrono::steady_clock::now();
    while (runs() && std::chrono::steady_clock::now() - start < std::chrono::duration<double>(kLongestSeconds))
        pause();
    Ended ended;
    if (!runs())
        ended.code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
    ended.out = readAll(outPath_);
    ended.error = readAll(errorPath_);
    return ended;
}

long Running::residentKilobytes() const {
    std::ifstream status("/proc/" + std::to_string(pid_) + "/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmRSS:"))
            return std::atol(line.c_str() + 6);
    return 0;
}

void WindowTest::SetUp() {
    if (!onPath("Xvfb"))
        GTEST_SKIP() << "no Xvfb: install the package xvfb";
    int ends[2] = {};
    ASSERT_EQ(pipe(ends), 0);
    server_ = fork();
    if (server_ == 0) {
        close(ends[0]);
        const int nothing = open("/dev/null", O_WRONLY);
        dup2(nothing, STDERR_FILENO);
        // By default the server starts anew, and refuses programs meanwhile, when its only one leaves.
        become({"Xvfb", "-noreset", "-displayfd", std::to_string(ends[1]), "-screen", "0", "1024x768x24", "-nolisten",
                "tcp"});
    }
    close(ends[1]);
    std::string number; // up to its newline, which comes by itself: closing before is the server's end
    for (pollfd ready = {ends[0], POLLIN, 0}; number.empty() || number.back() != '\n';) {
        char c = 0;
        if (::poll(&ready, 1, 20000) != 1 || read(ends[0], &c, 1) != 1)
            break;
        number += c;
    }
    close(ends[0]);
    ASSERT_TRUE(number.ends_with('\n')) << "Xvfb does not start";
    display_ = ":" + number.substr(0, number.size() - 1);
}

void WindowTest::TearDown() {
    if (server_ > 0) {
        kill(server_, SIGTERM);
        waitpid(server_, nullptr, 0);
    }
}

std::unique_ptr<Running> WindowTest::start(std::vector<std::string> arguments, std::vector<std::string> environment) {
    // What is compared is equal after any number of frames, and 30 of them, the default, take most of a test's time.
    if ((arguments.at(0) == "view" || arguments[0] == "render") && std::ranges::count(arguments, "--frames") == 0)
        arguments.insert(arguments.end(), {"--frames", "2"});
    std::vector<std::string> command = {GLINT_RUN, GLINT_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    // What the viewer remembers is not for this machine's people.
    for (const std::string& always : {"DISPLAY=" + display_, std::string("WAYLAND_DISPLAY"), std::string("XAUTHORITY"),
                                      "XDG_STATE_HOME=" + path("state")})
        environment.push_back(always);
    return std::make_unique<Running>(command, folder_.path(), environment);
}

Ended WindowTest::runScript(const std::string& script, std::vector<std::string> arguments) {
    std::ofstream(path("script.txt")) << script;
    std::vector<std::string> all = {"view",       "builtin:exact", "--size",    "320x180",
                                    "--validate", "--script",      "script.txt"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run(all);
}

Ended WindowTest::tool(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "xdotool");
    return Running(arguments, folder_.path(), {"DISPLAY=" + display_}).wait();
}

std::string WindowTest::bytes(const std::string& name) const {
    return readAll(path(name));
}

std::string WindowTest::waitForWindow(const std::string& scene) {
    const Ended found = tool({"search", "--sync", "--onlyvisible", "--name", "Glint: " + scene});
    EXPECT_EQ(found.code, 0) << found.error;
    return found.out.substr(0, found.out.find('\n'));
}

void WindowTest::endDisplay() {
    kill(server_, SIGKILL);
    waitpid(server_, nullptr, 0);
    server_ = -1;
}

bool WindowTest::waitFor(const std::string& name, double seconds) {
    std::error_code ignored;
    for (int i = 0; i < seconds * 50; ++i) {
        if (std::filesystem::exists(path(name), ignored))
            return true;
        pause();
    }
    return false;
}

} // namespace glint::test
