// Lets the OpenEXR library read from memory, so that a file is opened once and tests need no files.
#pragma once

#include <Iex.h>
#include <ImfIO.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace glint::scene {

/// Throws the library's own exceptions, the only ones after which it cleans up. `bytes` must outlive the stream.
class ExrStream : public Imf::IStream {
public:
    ExrStream(std::string_view bytes, const std::string& name) : Imf::IStream(name.c_str()), bytes_(bytes) {}
    bool read(char* out, int count) override {
        if (count < 0 || size_t(count) > bytes_.size() - at_)
            throw Iex::InputExc("the file is truncated");
        std::memcpy(out, bytes_.data() + at_, size_t(count));
        at_ += size_t(count);
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t position) override {
        if (position > bytes_.size())
            throw Iex::InputExc("the file is truncated");
        at_ = position;
    }

private:
    std::string_view bytes_;
    size_t at_ = 0;
};

} // namespace glint::scene
