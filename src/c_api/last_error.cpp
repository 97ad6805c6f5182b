#include "c_api/last_error.hpp"

#include <algorithm>
#include <cstring>

namespace glint::c_api {
namespace {

/// A plain array: threads that never fail cost nothing, and a thread may end after the library is unloaded.
thread_local char lastError[2048] = "";

/// One number for each error in both languages.
constexpr GlintResult codeOf(ErrorCode code) {
    switch (code) {
    case ErrorCode::InvalidArgument: return GLINT_ERROR_INVALID_ARGUMENT;
    case ErrorCode::InvalidInput: return GLINT_ERROR_INVALID_INPUT;
    case ErrorCode::NotFound: return GLINT_ERROR_NOT_FOUND;
    case ErrorCode::Unsupported: return GLINT_ERROR_UNSUPPORTED;
    case ErrorCode::DeviceLost: return GLINT_ERROR_DEVICE_LOST;
    case ErrorCode::OutOfMemory: return GLINT_ERROR_OUT_OF_MEMORY;
    case ErrorCode::Io: return GLINT_ERROR_IO;
    }
    return GLINT_ERROR_INVALID_ARGUMENT;
}

} // namespace

GlintResult fail(const Error& error) {
    const size_t length = std::min(error.message.size(), sizeof lastError - 1); // longer texts are cut
    std::memcpy(lastError, error.message.data(), length);
    lastError[length] = '\0';
    return codeOf(error.code);
}

GlintResult failNull(const char* function, const char* pointer) {
    return fail({ErrorCode::InvalidArgument, std::string(function) + ": " + pointer + " is null"});
}

} // namespace glint::c_api

const char* glint_last_error(void) {
    return glint::c_api::lastError;
}
