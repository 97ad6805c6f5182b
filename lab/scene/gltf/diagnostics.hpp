// The first error found in a file, and its warnings. After an error, reading continues with defaults until the caller
// checks, which avoids forty `if (!ok) return` in each function. Code that uses sizes or indices must check first.
#pragma once

#include "base/log.hpp"
#include "base/result.hpp"

#include <optional>
#include <string>

namespace glint::scene::gltf {

class Diagnostics {
public:
    explicit Diagnostics(std::string fileName) : file_(std::move(fileName)) {}

    /// Records the error if it is the first; later ones are usually consequences of it.
    template <class... Args>
    void fail(fmt::format_string<Args...> format, Args&&... args) {
        if (!error_)
            error_ = invalidInput("{}: {}", file_, fmt::format(format, std::forward<Args>(args)...));
    }
    void fail(Error error) {
        if (!error_)
            error_ = std::move(error);
    }

    template <class... Args>
    void warn(fmt::format_string<Args...> format, Args&&... args) {
        log::warning("{}: {}", file_, fmt::format(format, std::forward<Args>(args)...));
    }

    bool failed() const { return error_.has_value(); }
    const Error& error() const { return *error_; }
    const std::string& file() const { return file_; }

private:
    std::string file_;
    std::optional<Error> error_;
};

} // namespace glint::scene::gltf
