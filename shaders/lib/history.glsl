// The previous frame's colour, as the source of hits' colour.
#ifndef GLINT_LIB_HISTORY_GLSL
#define GLINT_LIB_HISTORY_GLSL

#include "shared/frame_constants.h"

/// Also false where the previous frame was recorded but never executed: its images then hold an older frame.
bool hasHistory(FrameConstants frame) {
    return (frame.flags & kInputHistory) != 0u && frame.historyTag == frame.historyExpected;
}

/// True if the previous frame's picture is there for whoever asks; hits on the screen take it with hasHistory alone.
bool hasPrevious(FrameConstants frame) {
    return (frame.flags & kInputPrevious) != 0u && frame.historyTag == frame.historyExpected;
}

#endif
