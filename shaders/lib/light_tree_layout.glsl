// Where the groups of a tree of lights lie (shared/light_tree.h).
#ifndef GLINT_LIB_LIGHT_TREE_LAYOUT_GLSL
#define GLINT_LIB_LIGHT_TREE_LAYOUT_GLSL

#include "shared/light_tree.h"

/// Number of groups before those of this depth.
uint lightGroupsAbove(uint depth) {
    return ((1u << (2u * depth)) - 1u) / 3u;
}

#endif
