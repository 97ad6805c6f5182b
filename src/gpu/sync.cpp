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
        // Stages and accesses are stored as two sets, so the write is made visible to every combination of both: later
        // tests of `alreadyVisible` may then trust every combination.
        state.readStages |= use.stages;
        state.readAccess |= use.access;
        return Barrier{state.writeStages, state.writeAccess, state.readStages,
                       state.readAccess,  use.layout,        use.layout};
    }

    std::optional<Barrier> barrier;
    if (changesLayout || state.writeStages != 0 || state.readStages != 0) {
        // Readers need only an execution dependency, no availability operation: their access bits are not in srcAccess.
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
        // The layout transition was the write. It is already available; later readers only have to be ordered after it.
        state.writeAccess = 0;
        state.readStages = use.stages;
        state.readAccess = use.access;
    }
    return barrier;
}

} // namespace glint::gpu
