#include "lab/cli/child_process.hpp"

#include "base/text.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

extern char** environ;

namespace glint::cli {
namespace {

/// Both ends of a pipe, closed on destruction.
struct Pipe {
    int ends[2] = {-1, -1};
    bool open() { return pipe2(ends, O_CLOEXEC) == 0; }
    void close(int end) {
        if (ends[end] >= 0)
            ::close(std::exchange(ends[end], -1));
    }
    Pipe() = default;
    ~Pipe() {
        close(0);
        close(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
};

/// Reads both pipes together, as the child blocks on a full one.
void drain(Pipe& out, std::string& outText, Pipe& error, std::string& errorText) {
    std::array<char, 65536> buffer;
    while (out.ends[0] >= 0 || error.ends[0] >= 0) {
        pollfd ready[2] = {{out.ends[0], POLLIN, 0}, {error.ends[0], POLLIN, 0}};
        if (::poll(ready, 2, -1) < 0 && errno != EINTR)
            return;
        for (int i = 0; i < 2; ++i) {
            if (ready[i].fd < 0 || ready[i].revents == 0)
                continue;
            const ssize_t count = read(ready[i].fd, buffer.data(), buffer.size());
            if (count > 0)
                (i == 0 ? outText : errorText).append(buffer.data(), static_cast<size_t>(count));
            else if (count == 0 || errno != EINTR)
                (i == 0 ? out : error).close(0);
        }
    }
}

} // namespace

Result<ProgramOutput> runChild(const std::vector<std::string>& command) {
    const std::string name = printable(command.front());
    Pipe out, error;
    if (!out.open() || !error.open())
        return makeError(ErrorCode::Io, "{} cannot be started: {}", name, std::strerror(errno));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, error.ends[1], STDERR_FILENO);
    std::vector<char*> argv;
    for (const std::string& word : command)
        argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    pid_t child = -1;
    const int failed = posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0)
        return makeError(failed == ENOENT ? ErrorCode::NotFound : ErrorCode::Io, "{} cannot be started: {}", name,
                         std::strerror(failed));
    out.close(1);
    error.close(1);
    ProgramOutput output;
    drain(out, output.out, error, output.error);
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR)
            return makeError(ErrorCode::Io, "{}: {}", name, std::strerror(errno));
    output.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return output;
}

} // namespace glint::cli
