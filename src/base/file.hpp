// Reads and writes whole files. A file written by this library is either complete or absent.
#pragma once

#include "base/result.hpp"

#include <string>
#include <string_view>

namespace glint {

/// Returns the bytes of a file of at most `longest` bytes. Errors: NotFound if there is no such file; Io if it cannot
/// be read; InvalidInput if it is longer.
Result<std::string> readFile(const std::string& path, size_t longest);

/// Returns true if what is written to `path` goes to something that is there already and is no file: "-", which is
/// standard output, a device, a pipe, or a descriptor of this process such as /dev/stdout.
bool namesStream(const std::string& path);

/// Returns a text that two paths share if they mean one file: through links, through hard links, and also if there is
/// no such file yet.
std::string fileIdentity(const std::string& path);

/// A file written under a temporary name in the folder of its final name; `commit` renames it. Without a commit the
/// temporary file is removed, and an existing file under the final name does not change. A link is followed, and a file
/// that is replaced keeps its permissions. For a stream (namesStream) the temporary file is in the system's folder for
/// such, and `commit` copies it there.
class FileInMaking {
public:
    explicit FileInMaking(std::string path);
    ~FileInMaking();
    FileInMaking(const FileInMaking&) = delete;
    FileInMaking& operator=(const FileInMaking&) = delete;

    const std::string& temporaryPath() const { return temporaryPath_; }
    Result<void> commit();

private:
    std::string path_;   ///< as the caller said it
    std::string target_; ///< the file that its links lead to
    std::string temporaryPath_;
    bool committed_ = false;
};

/// As a FileInMaking, or straight into a stream. Errors: Io, with the path and the system's reason.
Result<void> writeFile(const std::string& path, std::string_view bytes);

} // namespace glint
