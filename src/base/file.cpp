#include "base/file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <random>

namespace glint {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

Error systemError(const std::string& path, int number) {
    const ErrorCode code = number == ENOENT ? ErrorCode::NotFound : ErrorCode::Io;
    return makeError(code, "{}: {}", path, std::strerror(number));
}

/// Two concurrent writers of one file must not share a temporary name, whether in one process, in two, or on two
/// machines that share the folder: there processes may have the same number, but hardly the same random one too.
std::string temporaryName(const std::string& path) {
    static std::atomic<unsigned> counter = 0;
    static const unsigned random = std::random_device()();
    return formatText("{}.{}-{:08x}.{}.tmp", path, getpid(), random, counter++);
}

/// The file that a path means when its links are followed, so that they are still there when it is replaced.
std::string targetOf(const std::string& path) {
    std::error_code error;
    std::filesystem::path target = path;
    constexpr int kMostLinks = 40; // as the kernel has it; a longer chain is a circle, which opening the file reports
    for (int link = 0; link < kMostLinks && std::filesystem::is_symlink(target, error); ++link)
        target = target.parent_path() / std::filesystem::read_symlink(target, error);
    return target.string();
}

/// Writes into what is there already, from where it stands: a shell may have opened it for others too.
Result<void> writeStream(const std::string& path, std::string_view bytes) {
    const bool own = path == "-" || path == "/dev/stdout"; // after what was printed so far
    const File opened(own ? nullptr : std::fopen(path.c_str(), "ab"));
    std::FILE* const file = own ? stdout : opened.get();
    if (!file)
        return systemError(path, errno);
    if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() || std::fflush(file) != 0)
        return systemError(own ? "standard output" : path, errno);
    return {};
}

} // namespace

Result<std::string> readFile(const std::string& path, size_t longest) {
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file)
        return systemError(path, errno);
    std::string bytes;
    char chunk[65536];
    while (const size_t count = std::fread(chunk, 1, sizeof chunk, file.get())) {
        if (bytes.size() + count > longest)
            return invalidInput("{}: the file is longer than {} bytes", path, longest);
        bytes.append(chunk, count);
    }
    if (std::ferror(file.get()))
        return systemError(path, errno);
    return bytes;
}

bool namesStream(const std::string& path) {
    if (path == "-" || path.starts_with("/dev/fd/") || path.starts_with("/proc/self/fd/") || path == "/dev/stdout" ||
        path == "/dev/stderr")
        return true;
    struct stat status = {};
    return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

std::string fileIdentity(const std::string& path) {
    const std::string target = targetOf(path);
    struct stat status = {};
    if (stat(target.c_str(), &status) == 0)
        return formatText("{}:{}", status.st_dev, status.st_ino);
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(std::filesystem::absolute(target), error);
    return error ? target : whole.string();
}

FileInMaking::FileInMaking(std::string path) : path_(std::move(path)), target_(targetOf(path_)) {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    temporaryPath_ = temporaryName(namesStream(path_) ? (folder / "glint").string() : target_);
}

FileInMaking::~FileInMaking() {
    if (!committed_)
        std::remove(temporaryPath_.c_str());
}

Result<void> FileInMaking::commit() {
    if (namesStream(path_)) {
        GLINT_TRY(bytes, readFile(temporaryPath_, std::numeric_limits<size_t>::max()));
        return writeStream(path_, bytes);
    }
    struct stat old = {};
    if (stat(target_.c_str(), &old) == 0 && S_ISREG(old.st_mode))
        // Best effort: where another one's file may be replaced but not be given away, the new one is ours.
        if (chmod(temporaryPath_.c_str(), old.st_mode & 07777) != 0 ||
            chown(temporaryPath_.c_str(), old.st_uid, old.st_gid) != 0)
            errno = 0;
    if (std::rename(temporaryPath_.c_str(), target_.c_str()) != 0)
        return systemError(path_, errno);
    committed_ = true;
    return {};
}

Result<void> writeFile(const std::string& path, std::string_view bytes) {
    if (namesStream(path))
        return writeStream(path, bytes);
    FileInMaking making(path);
    File file(std::fopen(making.temporaryPath().c_str(), "wb"));
    if (!file)
        return systemError(path, errno);
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    // The last bytes are written on close, so a full disk may be reported only here.
    if (std::fclose(file.release()) != 0 || !written)
        return systemError(path, errno);
    return making.commit();
}

} // namespace glint
