#include "base/file.hpp"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

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

/// Two concurrent writers of one file, in one process or two, must not share a temporary name.
std::string temporaryName(const std::string& path) {
    static std::atomic<unsigned> counter = 0;
    return fmt::format("{}.{}.{}.tmp", path, getpid(), counter++);
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

FileInMaking::FileInMaking(std::string path) : path_(std::move(path)), temporaryPath_(temporaryName(path_)) {}

FileInMaking::~FileInMaking() {
    if (!committed_)
        std::remove(temporaryPath_.c_str());
}

Result<void> FileInMaking::commit() {
    if (std::rename(temporaryPath_.c_str(), path_.c_str()) != 0)
        return systemError(path_, errno);
    committed_ = true;
    return {};
}

Result<void> writeFile(const std::string& path, std::string_view bytes) {
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
