// Captures a frame with RenderDoc, if this program was started under it.
#pragma once

#include <optional>

namespace glint::view {

class RenderDoc {
public:
    /// Returns no value if RenderDoc's library is not loaded in this process, or is too old.
    static std::optional<RenderDoc> find();

    /// All device work between start and end becomes one capture.
    void start() const;
    bool end() const; ///< false: no capture was made

private:
    struct Functions;
    explicit RenderDoc(const Functions& functions) : functions_(&functions) {}
    const Functions* functions_; ///< owned by RenderDoc
};

} // namespace glint::view
