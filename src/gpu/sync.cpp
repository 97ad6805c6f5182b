#include "gpu/sync.hpp"

namespace glint::gpu {

std::optional<Barrier> transition(ResourceState& state, const Use& use) {
    const bool changesLayout = use.layout != state.layout;
    if (!use.writes && !changesLayout) {
        const bool alreadyVisible = (use.stages & ~state.readStages) == 0 && (use.access & ~state.readAccess) == 0;
        const bool everWritten = state.writeStages != 0;
        if (!everWritten || alreadyVisible) {
            state.readStages |= use.stages;
            state.readAccess |= use.access;
            return std::nullopt;
        }
        // Stages and access are each a set, so a new reader is made visible to the whole product of both: the next
        // test of `alreadyVisible` may then trust every combination.
        state.readStages |= use.stages;
        state.readAccess |= use.access;
        return Barrier{state.writeStages, state.writeAccess, state.readStages,
                       state.readAccess,  use.layout,        use.layout};
    }

    std::optional<Barrier> barrier;
    if (changesLayout || state.writeStages != 0 || state.readStages != 0) {
        // Readers need no availability operation, only to be waited for: their access bits stay out of srcAccess.
        barrier = Barrier{state.writeStages | state.readStages,
                          state.writeAccess,
                          use.stages,
                          use.access,
                          use.discards ? VK_IMAGE_LAYOUT_UNDEFINED : state.layout,
                          use.layout};
    }
    state.layout = use.layout;
    state.writeStages = use.stages;
    if (use.writes) {
        state.writeAccess = use.access;
        state.readStages = 0;
        state.readAccess = 0;
    } else {
        // The transition was the write; it is available already, later readers only have to be ordered behind it.
        state.writeAccess = 0;
        state.readStages = use.stages;
        state.readAccess = use.access;
    }
    return barrier;
}

} // namespace glint::gpu
