// Whole files in and out. A file that this library writes is complete or not there.
#pragma once

#include "base/result.hpp"

#include <string>
#include <string_view>

namespace glint {

/// The bytes of a file of at most `longest` bytes.
/// Errors: NotFound if there is none; Io if it cannot be read; InvalidInput if it is longer.
Result<std::string> readFile(const std::string& path, size_t longest);

/// A file being written under a temporary name in the folder of its final one, which it takes in `commit`.
/// Without a commit the temporary file is removed, and what was there before stays.
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
