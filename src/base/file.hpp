// Reads and writes whole files. A file written by this library is either complete or absent.
#pragma once

#include "base/result.hpp"

#include <string>
#include <string_view>

namespace glint {

/// Returns the bytes of a file of at most `longest` bytes. Errors: NotFound if there is no such file; Io if it cannot
/// be read; InvalidInput if it is longer.
Result<std::string> readFile(const std::string& path, size_t longest);

/// A file written under a temporary name in the folder of its final name; `commit` renames it. Without a commit the
/// temporary file is removed, and an existing file under the final name does not change.
class FileInMaking {
public:
    explicit FileInMaking(std::string path);
    ~FileInMaking();
    FileInMaking(const FileInMaking&) = delete;
    FileInMaking& operator=(const FileInMaking&) = delete;

    const std::string& temporaryPath() const { return temporaryPath_; }
    Result<void> commit();

private:
    std::string path_;
    std::string temporaryPath_;
    bool committed_ = false;
};

/// Errors: Io, with the path and the system's reason.
Result<void> writeFile(const std::string& path, std::string_view bytes);

} // namespace glint
