// Stands in for RenderDoc's library in a test: says on standard output what it was asked for.
#include <cstdint>
#include <cstdio>

namespace {

void never() {
    std::puts("a function that nobody should call");
}
void start(void*, void*) {
    std::puts("start");
    std::fflush(stdout);
}
uint32_t end(void*, void*) {
    std::puts("end");
    std::fflush(stdout);
    return 1;
}

/// As in render_doc.cpp, by number: 19 starts a capture, 21 ends it.
struct Functions {
    void (*before[19])();
    void (*start)(void*, void*);
    void (*between)();
    uint32_t (*end)(void*, void*);
};

} // namespace

extern "C" __attribute__((visibility("default"))) int RENDERDOC_GetAPI(int version, void** out) {
    static Functions functions;
    for (auto& function : functions.before)
        function = never;
    functions.start = start;
    functions.between = never;
    functions.end = end;
    *out = &functions;
    return version == 10000 ? 1 : 0;
}
