// The next mip of an image, as a linear blit makes it: the mean of four texels where the size is even. A dispatch
// instead of a blit, because compute-only queues have no blits.
#version 460

#ifdef GLINT_LAYERS // of each layer of an image: a cube's six faces
#define COLOR_IMAGE image2DArray
#define TEXEL(xy, layer) ivec3(xy, layer)
#define SIZE(image) imageSize(image).xy
#else
#define COLOR_IMAGE image2D
#define TEXEL(xy, layer) ivec2(xy)
#define SIZE(image) imageSize(image)
#endif

layout(local_size_x = 8, local_size_y = 8) in;

layout(set = 0, binding = 0, rgba16f) uniform COLOR_IMAGE finer; // only read
layout(set = 0, binding = 1, rgba16f) uniform writeonly COLOR_IMAGE coarser;

void main() {
    uvec3 id = gl_GlobalInvocationID;
    ivec2 size = SIZE(coarser);
    if (any(greaterThanEqual(ivec2(id.xy), size)))
        return;
    ivec2 last = SIZE(finer) - 1;
    vec2 place = (vec2(id.xy) + 0.5) * vec2(last + 1) / vec2(size) - 0.5;
    ivec2 low = ivec2(floor(place));
    vec2 share = place - vec2(low);
    ivec2 a = clamp(low, ivec2(0), last);
    ivec2 b = clamp(low + 1, ivec2(0), last);
    vec4 top = mix(imageLoad(finer, TEXEL(a, id.z)), imageLoad(finer, TEXEL(ivec2(b.x, a.y), id.z)), share.x);
    vec4 bottom = mix(imageLoad(finer, TEXEL(ivec2(a.x, b.y), id.z)), imageLoad(finer, TEXEL(b, id.z)), share.x);
    imageStore(coarser, TEXEL(id.xy, id.z), mix(top, bottom, share.y));
}
