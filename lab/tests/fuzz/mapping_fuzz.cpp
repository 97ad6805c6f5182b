// Any bytes are a mapping file or one line of error.
#include "lab/gbuffer_files/gbuffer_mapping.hpp"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto mapping = glint::scene::parseMapping(text, "fuzz.json");
    if (!mapping && mapping.error().message.find('\n') != std::string::npos)
        std::abort();
    return 0;
}
