// Any bytes are a set of probes or one line of error. The checksum is set right, or no mutation would get past it.
#include "base/hash.hpp"
#include "lab/sources/probe_file.hpp"

#include <cstring>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    std::string bytes(reinterpret_cast<const char*>(data), size);
    static_cast<void>(glint::render::decodeProbes(bytes, "fuzz"));
    constexpr size_t kHeader = 48;
    if (size < kHeader)
        return 0;
    const uint64_t body = size - kHeader;
    const uint64_t hash = glint::Hash().text(std::string_view(bytes).substr(kHeader)).result();
    std::memcpy(&bytes[32], &body, 8);
    std::memcpy(&bytes[40], &hash, 8);
    static_cast<void>(glint::render::decodeProbes(bytes, "fuzz"));
    return 0;
}
