// The layers of a G-buffer file that a mapping names, with their values as stored.
#pragma once

#include "lab/gbuffer_files/gbuffer_mapping.hpp"
#include "lab/scene/images/exr_channels.hpp"

#include <glm/glm.hpp>

#include <vector>

namespace glint::scene {

/// Planes of width * height pixels in the file's order of rows; a plane is empty if the mapping or the file lacks it.
struct GBufferLayers {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> depth;
    std::vector<glm::vec3> position;
    std::vector<float> coverage;
    std::vector<glm::vec3> normal;
    std::vector<float> roughness;
    std::vector<float> metallic;
    std::vector<float> ior;
    std::vector<glm::vec3> f0;
    std::vector<glm::vec3> baseColor;
    std::vector<glm::vec2> motion;
    std::vector<glm::vec3> color;
    std::vector<glm::vec3> fallbackSpecular;
    std::vector<glm::vec3> reference;
    std::vector<std::string> notes; ///< optional layers that are missing

    size_t pixels() const { return size_t{width} * height; }
};

/// `colors`  file of color, may be `surfaces` itself. A file without layers, whose channels are R, G and B alone, is
/// the
///           lit picture whatever the mapping calls it. fallbackSpecular and reference are in `colors`, or else in
///           `surfaces`
/// Errors: InvalidInput names the file, the key and the layer: missing, ambiguous, with other channels than its key
/// needs, or of another size than the rest.
Result<GBufferLayers> readLayers(const ExrChannels& surfaces, const ExrChannels& colors, const GBufferMapping& mapping);

/// Looks for the layers that readLayers reads, without reading them. Errors: those of readLayers for layers that are
/// missing or ambiguous, or have other channels.
Result<void> findLayers(const ExrChannels& surfaces, const ExrChannels& colors, const GBufferMapping& mapping);

} // namespace glint::scene
