// What recorded passes read and write, for docs/passes.md (tests/gpu/pass_table_test.cpp). While a test keeps a log,
// every Frame of the process but rehearsals adds to it; else it costs a comparison a binding.
#pragma once

#include "gpu/resources.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace glint::gpu {

struct PassLog {
    /// One binding of one recorded pass.
    struct Use {
        std::string row;  ///< of the timers: the pass, or the scope around it
        std::string pass; ///< the shader
        std::string binding;
        bool reads = false;
        bool writes = false;
        std::string resource;  ///< name of the image or buffer
        ImageDesc image;       ///< of an image
        uint32_t firstMip = 0; ///< the mips that are bound, of an image
        uint32_t mips = 0;     ///< 0: a buffer, or an acceleration structure
        size_t bufferSize = 0; ///< bytes
    };

    /// The log that Frames add to; null: none.
    static PassLog*& current() {
        static PassLog* log = nullptr;
        return log;
    }

    std::vector<std::string> rows; ///< of the timers, in the order of recording
    std::vector<Use> uses;

    void open(std::string_view name) {
        if (depth_++ == 0)
            rows.emplace_back(scope_ = name);
    }
    void close() {
        if (--depth_ == 0)
            scope_.clear();
    }
    void add(Use use) {
        use.row = depth_ > 0 ? scope_ : use.pass;
        uses.push_back(std::move(use));
    }

private:
    std::string scope_; ///< the outermost that is open
    int depth_ = 0;
};

} // namespace glint::gpu
