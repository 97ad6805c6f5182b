// A G-buffer file's pixels in Glint's conventions (docs/conventions.md): the values of GBufferLayers, decoded as a
// mapping declares them.
#pragma once

#include "lab/gbuffer_files/gbuffer_layers.hpp"
#include "lab/scene/camera.hpp"

namespace glint::scene {

/// The camera of an image of this size: pixels to directions and back.
class PixelLens {
public:
    PixelLens(const Camera& camera, uint32_t width, uint32_t height);

    /// View-space position of pixel (x, y), from the top left, at a viewZ.
    glm::vec3 positionVS(uint32_t x, uint32_t y, float viewZ) const;
    /// Pixel coordinates (centres at .5) of a view-space position in front of the camera.
    glm::vec2 pixelOf(const glm::vec3& positionVS) const;
    /// Unit direction from a view-space position to the camera.
    glm::vec3 toCameraVS(const glm::vec3& positionVS) const;
    /// Stored depth to viewZ, in metres; not finite or not positive if there is no surface.
    float viewZ(const GBufferMeaning& meaning, float stored, uint32_t x, uint32_t y) const;
    /// Stored normal to world space, unit length. Returns (0, 0, 0) if it has no direction.
    glm::vec3 normalWS(const GBufferMeaning& meaning, const glm::vec3& stored) const;
    /// Stored motion to previous - current UV. Returns 0 where it is no number.
    glm::vec2 motionUV(const GBufferMapping& mapping, const glm::vec2& stored) const;
    /// Stored position to world space, in metres.
    static glm::vec3 positionWS(const GBufferMeaning& meaning, const glm::vec3& stored);
    const glm::mat4& worldToView() const { return worldToView_; }
    const Camera& camera() const { return camera_; }

private:
    float deviceViewZ(float nearness) const;

    Camera camera_;
    glm::mat4 worldToView_;
    glm::vec2 size_;
    glm::vec2 halfExtent_; ///< of the image in view space: at viewZ 1, or orthographic at any viewZ
};

/// Planes of width * height pixels, rows from the top.
struct GBufferPixels {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> viewZ;         ///< metres, 0: background
    std::vector<glm::vec3> normalWS;  ///< unit; 0: background
    std::vector<glm::vec4> material;  ///< F0 in rgb, perceptual roughness in a; 0: background
    std::vector<glm::vec3> baseColor; ///< [0, 1]; white if unknown
    std::vector<glm::vec2> motionUV;  ///< previous - current UV; empty: nothing moves but the camera
    std::vector<glm::vec3> litRadiance;
    std::vector<glm::vec3> fallbackSpecular; ///< empty: unknown
    std::vector<glm::vec3> reference;        ///< empty: none
    uint64_t surfaces = 0;                   ///< pixels that show a surface
    std::vector<std::string> notes;
};

/// Pixels whose depth, normal or coverage has no finite value count as background; a note tells how many.
/// `name` is used in error messages. Errors: InvalidInput if no pixel shows a surface.
Result<GBufferPixels> decodeLayers(const GBufferLayers& layers, const GBufferMapping& mapping, const Camera& camera,
                                   std::string_view name);

} // namespace glint::scene
