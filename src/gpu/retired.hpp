// Holds replaced objects that frames in flight may still use, until the host's frame number shows that those frames are
// done.
#pragma once

#include "gpu/pipeline.hpp"
#include "gpu/resources.hpp"

#include <variant>
#include <vector>

namespace glint::gpu {

class Retired {
public:
    using Object = std::variant<Image, Buffer, Pipeline>;

    /// Retires an object that frames up to the newest begun frame may still use. An empty object is released at once.
    template <class T>
    void keep(T object) {
        if (object)
            objects_.push_back({frame_, Object(std::move(object))});
    }
    /// Begins a frame and releases what only frames before `frame - framesInFlight` used: those frames are done.
    void begin(uint64_t frame, uint32_t framesInFlight) {
        frame_ = std::max(frame_, frame);
        std::erase_if(objects_, [&](const Entry& entry) { return entry.frame + framesInFlight <= frame_; });
    }
    size_t count() const { return objects_.size(); }

private:
    struct Entry {
        uint64_t frame; ///< the newest frame that may use it
        Object object;
    };

    uint64_t frame_ = 0;
    std::vector<Entry> objects_;
};

} // namespace glint::gpu
