// RenderDoc, where this program was started under it: a frame for its replay, when asked.
#pragma once

#include <optional>

namespace glint::view {

class RenderDoc {
public:
    /// Absent where RenderDoc's library is not in this process, or is too old to be talked to.
    static std::optional<RenderDoc> find();

    /// All that the device does between the two becomes one capture.
    void start() const;
    bool end() const; ///< false: there is no capture

private:
    struct Functions;
    explicit RenderDoc(const Functions& functions) : functions_(&functions) {}
    const Functions* functions_; ///< RenderDoc's own
};

} // namespace glint::view
