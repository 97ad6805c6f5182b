#include "lab/scene/gltf/uri_loading.hpp"

#include "lab/scene/gltf/uri.hpp"

namespace glint::scene::gltf {

std::vector<uint8_t> loadUri(Document& document, const JsonObject& owner, const std::string& uri) {
    Diagnostics& diagnostics = document.diagnostics;
    const auto fail = [&](const Error& error) {
        diagnostics.fail(Error{error.code, fmt::format("{}: {}: {}", diagnostics.file(), owner.path(), error.message)});
        return std::vector<uint8_t>();
    };
    if (isDataUri(uri)) {
        auto bytes = decodeDataUri(uri);
        return bytes ? std::move(bytes).value() : fail(bytes.error());
    }
    const auto path = decodeRelativeUri(uri);
    if (!path)
        return fail(path.error());
    if (!document.resolve)
        return fail(invalidInput("names the file \"{}\", but this model was not read from a folder", *path));
    auto bytes = document.resolve(*path);
    return bytes ? std::move(bytes).value() : fail(bytes.error());
}

} // namespace glint::scene::gltf
