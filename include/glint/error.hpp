// SPDX-License-Identifier: MIT
// Errors as values. The library throws no exceptions across its boundary.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace glint {

enum class ErrorCode {
    InvalidArgument, ///< the caller's request is invalid: an unknown name, a value out of range
    InvalidInput,    ///< external data is malformed: a file, an image, JSON
    NotFound,        ///< a file or a device does not exist
    Unsupported,     ///< the request is valid, but this device or this build does not support it
    DeviceLost,      ///< the GPU stopped; the message names the last pass that ran
    OutOfMemory,     ///< device memory or host memory
    Io,              ///< a read or a write failed
};

/// The message is one line for a person: what failed, where, and what to do. Example:
/// "stage1.glb: accessor 3 ends at byte 912 but bufferView 1 has 900".
struct Error {
    ErrorCode code = ErrorCode::InvalidArgument;
    std::string message;
};

/// A value or an Error. Test ok() first: value() of an error, and error() of a value, are programming errors.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return state_.index() == 0; }
    explicit operator bool() const { return ok(); }

    T& value() & { return assert(ok()), *std::get_if<0>(&state_); }
    const T& value() const& { return assert(ok()), *std::get_if<0>(&state_); }
    T&& value() && { return assert(ok()), std::move(*std::get_if<0>(&state_)); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(*this).value(); }

    const Error& error() const& { return assert(!ok()), *std::get_if<1>(&state_); }
    Error&& error() && { return assert(!ok()), std::move(*std::get_if<1>(&state_)); }

private:
    std::variant<T, Error> state_;
};

template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)), ok_(false) {}

    bool ok() const { return ok_; }
    explicit operator bool() const { return ok_; }
    const Error& error() const& { return assert(!ok_), error_; }
    Error&& error() && { return assert(!ok_), std::move(error_); }

private:
    Error error_;
    bool ok_ = true;
};

} // namespace glint
