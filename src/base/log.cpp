#include "base/log.hpp"

#include <cstdio>
#include <mutex>
#include <set>
#include <string>

namespace glint::log {
namespace {

void printLine(std::string_view line, void*) {
    std::fprintf(stderr, "%.*s\n", static_cast<int>(line.size()), line.data());
}

struct State {
    std::mutex mutex;
    Sink sink = printLine;
    void* user = nullptr;
    std::set<std::string, std::less<>> seen;
};

State& state() {
    static State instance;
    return instance;
}

} // namespace

void setSink(Sink sink, void* user) {
    std::lock_guard lock(state().mutex);
    state().sink = sink ? sink : printLine;
    state().user = user;
    state().seen.clear();
}

void warningText(std::string_view text) {
    std::lock_guard lock(state().mutex);
    if (!state().seen.emplace(text).second)
        return;
    state().sink(std::string("glint: warning: ").append(text), state().user);
}

} // namespace glint::log
