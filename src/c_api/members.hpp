// Which member of a C struct is which member of the C++ struct. One list for both directions: a C struct is read by it
// (struct_reading.hpp), and its defaults are those of the C++ struct.
#pragma once

#include "glint/glint.h"
#include "glint/glint.hpp"

namespace glint::c_api {

/// The C struct of a C++ struct.
template <class Cpp>
struct CStruct;

#define GLINT_C_STRUCT(Cpp, C)                                                                                         \
    template <>                                                                                                        \
    struct CStruct<Cpp> {                                                                                              \
        using Type = C;                                                                                                \
        static constexpr const char* kName = #C;                                                                       \
    };

GLINT_C_STRUCT(HostDevice, GlintContextDesc)
GLINT_C_STRUCT(HostImage, GlintImage)
GLINT_C_STRUCT(MaterialChannel, GlintMaterialChannel)
GLINT_C_STRUCT(Conventions, GlintConventions)
GLINT_C_STRUCT(GBuffer, GlintGBuffer)
GLINT_C_STRUCT(EnvironmentMap, GlintEnvironmentMap)
GLINT_C_STRUCT(Outputs, GlintOutputs)
GLINT_C_STRUCT(TransparentLayer, GlintTransparentLayer)
GLINT_C_STRUCT(View, GlintView)
GLINT_C_STRUCT(RayMesh, GlintRayMesh)
GLINT_C_STRUCT(RayInstance, GlintRayInstance)
GLINT_C_STRUCT(RaySceneDesc, GlintRaySceneDesc)
GLINT_C_STRUCT(HostAccelerationStructure, GlintHostAccelerationStructure)
GLINT_C_STRUCT(RaySceneTimes, GlintRaySceneTimes)
GLINT_C_STRUCT(SurfaceMaterial, GlintSurfaceMaterial)
GLINT_C_STRUCT(SurfaceMesh, GlintSurfaceMesh)
GLINT_C_STRUCT(SurfaceInstance, GlintSurfaceInstance)
GLINT_C_STRUCT(SurfaceLight, GlintSurfaceLight)
GLINT_C_STRUCT(SurfaceTableDesc, GlintSurfaceTableDesc)
GLINT_C_STRUCT(PlanarMirror, GlintPlanarMirror)
GLINT_C_STRUCT(PlanarPicture, GlintPlanarPicture)
GLINT_C_STRUCT(PlanarMirrorsDesc, GlintPlanarMirrorsDesc)
GLINT_C_STRUCT(Probe, GlintProbe)
GLINT_C_STRUCT(ProbesDesc, GlintProbesDesc)
GLINT_C_STRUCT(ReflectionsDesc, GlintReflectionsDesc)
GLINT_C_STRUCT(SettingInfo, GlintSettingInfo)
GLINT_C_STRUCT(Statistics, GlintStatistics)
GLINT_C_STRUCT(MemoryReport, GlintMemoryReport)
GLINT_C_STRUCT(InputCheck, GlintInputCheck)
GLINT_C_STRUCT(KnownPlane, GlintKnownPlane)
GLINT_C_STRUCT(RayInspection, GlintRayInspection)
#undef GLINT_C_STRUCT

/// The last value of each enum that C may pass; greater numbers are errors. Both languages count from 0.
constexpr DeviceDemands lastOf(DeviceDemands) {
    return DeviceDemands::Sources;
}
constexpr DepthKind lastOf(DepthKind) {
    return DepthKind::LinearViewZ;
}
constexpr Handedness lastOf(Handedness) {
    return Handedness::Left;
}
constexpr NormalSpace lastOf(NormalSpace) {
    return NormalSpace::View;
}
constexpr NormalEncoding lastOf(NormalEncoding) {
    return NormalEncoding::OctahedralUnorm;
}
constexpr MaterialKind lastOf(MaterialKind) {
    return MaterialKind::Standard;
}
constexpr RoughnessKind lastOf(RoughnessKind) {
    return RoughnessKind::Smoothness;
}
constexpr RayBackend lastOf(RayBackend) {
    return RayBackend::Bvh;
}
constexpr InstanceNumbering lastOf(InstanceNumbering) {
    return InstanceNumbering::CustomIndex;
}
constexpr SurfaceAlpha lastOf(SurfaceAlpha) {
    return SurfaceAlpha::Blend;
}
constexpr SurfaceLightKind lastOf(SurfaceLightKind) {
    return SurfaceLightKind::Spot;
}
constexpr ProbeShape lastOf(ProbeShape) {
    return ProbeShape::Sphere;
}
constexpr ProbeProxy lastOf(ProbeProxy) {
    return ProbeProxy::Sphere;
}

/// members(visitor, c, cpp) calls visitor.pair(name, c.member, cpp.member) for each member that both structs have.
#define GLINT_PAIR(member) visitor.pair(#member, c.member, cpp.member);

template <class Visitor>
void members(Visitor& visitor, GlintContextDesc& c, HostDevice& cpp) {
    GLINT_PAIR(instance)
    GLINT_PAIR(physicalDevice)
    GLINT_PAIR(device)
    GLINT_PAIR(queueFamily)
    GLINT_PAIR(getInstanceProcAddr)
    GLINT_PAIR(rayQuery)
    GLINT_PAIR(demands)
    GLINT_PAIR(pipelineCache)
    GLINT_PAIR(allocationCallbacks)
    GLINT_PAIR(message)
    GLINT_PAIR(messageUser)
}

template <class Visitor>
void members(Visitor& visitor, GlintImage& c, HostImage& cpp) {
    GLINT_PAIR(image)
    GLINT_PAIR(view)
    GLINT_PAIR(format)
    GLINT_PAIR(width)
    GLINT_PAIR(height)
    GLINT_PAIR(layout)
    GLINT_PAIR(stages)
    GLINT_PAIR(access)
    GLINT_PAIR(samples)
    GLINT_PAIR(usage)
    GLINT_PAIR(mips)
    GLINT_PAIR(viewType)
}

template <class Visitor>
void members(Visitor& visitor, GlintMaterialChannel& c, MaterialChannel& cpp) {
    GLINT_PAIR(image)
    GLINT_PAIR(channel)
    GLINT_PAIR(scale)
    GLINT_PAIR(bias)
}

template <class Visitor>
void members(Visitor& visitor, GlintConventions& c, Conventions& cpp) {
    GLINT_PAIR(depth)
    GLINT_PAIR(depthMinusOneToOne)
    GLINT_PAIR(clipYDown)
    GLINT_PAIR(handedness)
    GLINT_PAIR(normalSpace)
    GLINT_PAIR(normalEncoding)
    GLINT_PAIR(material)
    GLINT_PAIR(roughness)
    GLINT_PAIR(linearDepthScale)
    GLINT_PAIR(motionScale)
    GLINT_PAIR(highlightsInAlpha)
    GLINT_PAIR(motionDepthScale)
}

template <class Visitor>
void members(Visitor& visitor, GlintGBuffer& c, GBuffer& cpp) {
    GLINT_PAIR(depth)
    GLINT_PAIR(normal)
    GLINT_PAIR(material)
    GLINT_PAIR(baseColor)
    GLINT_PAIR(roughness)
    GLINT_PAIR(metallic)
    GLINT_PAIR(specular)
    GLINT_PAIR(f90)
    GLINT_PAIR(coat)
    GLINT_PAIR(coatRoughness)
    GLINT_PAIR(coatNormal)
    GLINT_PAIR(occlusion)
    GLINT_PAIR(litRadiance)
    GLINT_PAIR(fallbackSpecular)
    GLINT_PAIR(motion)
    GLINT_PAIR(backDepth)
    GLINT_PAIR(transparentDepth)
    GLINT_PAIR(conventions)
}

template <class Visitor>
void members(Visitor& visitor, GlintEnvironmentMap& c, EnvironmentMap& cpp) {
    GLINT_PAIR(cube)
    GLINT_PAIR(mips)
    GLINT_PAIR(strength)
    GLINT_PAIR(rotation)
    GLINT_PAIR(flipY)
    GLINT_PAIR(diffuse)
}

template <class Visitor>
void members(Visitor& visitor, GlintOutputs& c, Outputs& cpp) {
    GLINT_PAIR(composite)
    GLINT_PAIR(reflection)
}

template <class Visitor>
void members(Visitor& visitor, GlintTransparentLayer& c, TransparentLayer& cpp) {
    GLINT_PAIR(depth)
    GLINT_PAIR(normal)
    GLINT_PAIR(material)
    GLINT_PAIR(radiance)
    GLINT_PAIR(fallbackSpecular)
    GLINT_PAIR(transmittance)
    GLINT_PAIR(absorption)
    GLINT_PAIR(body)
    GLINT_PAIR(objectCenter)
    GLINT_PAIR(coverage)
}

template <class Visitor>
void members(Visitor& visitor, GlintView& c, View& cpp) {
    GLINT_PAIR(worldToView)
    GLINT_PAIR(viewToClip)
    GLINT_PAIR(frameIndex)
    GLINT_PAIR(seed)
    GLINT_PAIR(seconds)
    GLINT_PAIR(cut)
    GLINT_PAIR(frameNumber)
    GLINT_PAIR(width)
    GLINT_PAIR(height)
}

template <class Visitor>
void members(Visitor& visitor, GlintRayMesh& c, RayMesh& cpp) { // and indices, with their count (rays.cpp)
    GLINT_PAIR(positions)
    GLINT_PAIR(vertexCount)
    GLINT_PAIR(vertexStride)
    GLINT_PAIR(deforms)
}

template <class Visitor>
void members(Visitor& visitor, GlintRayInstance& c, RayInstance& cpp) {
    GLINT_PAIR(mesh)
    GLINT_PAIR(localToWorld)
    GLINT_PAIR(mask)
    GLINT_PAIR(opaque)
    GLINT_PAIR(doubleSided)
}

template <class Visitor>
void members(Visitor& visitor, GlintRaySceneDesc& c, RaySceneDesc& cpp) { // and the lists (rays.cpp)
    GLINT_PAIR(maxInstances)
    GLINT_PAIR(backend)
}

template <class Visitor>
void members(Visitor& visitor, GlintHostAccelerationStructure& c,
             HostAccelerationStructure& cpp) { // and triangleCounts (rays.cpp)
    GLINT_PAIR(topLevel)
    GLINT_PAIR(instanceCount)
    GLINT_PAIR(numbering)
    GLINT_PAIR(transparentLowWS)
    GLINT_PAIR(transparentHighWS)
}

template <class Visitor>
void members(Visitor& visitor, GlintRaySceneTimes& c, RaySceneTimes& cpp) {
    GLINT_PAIR(cpuBuildMs)
    GLINT_PAIR(cpuUpdateMs)
    GLINT_PAIR(gpuBuildMs)
    GLINT_PAIR(gpuUpdateMs)
}

template <class Visitor>
void members(Visitor& visitor, GlintSurfaceTextureRef& c, SurfaceTextureRef& cpp) {
    GLINT_PAIR(index)
    GLINT_PAIR(texCoord)
    GLINT_PAIR(uvTransform)
}

template <class Visitor>
void members(Visitor& visitor, GlintSurfaceMaterial& c, SurfaceMaterial& cpp) {
    GLINT_PAIR(alpha)
    GLINT_PAIR(alphaCutoff)
    GLINT_PAIR(unlit)
    GLINT_PAIR(baseColorFactor)
    GLINT_PAIR(baseColorTexture)
    GLINT_PAIR(metallicFactor)
    GLINT_PAIR(roughnessFactor)
    GLINT_PAIR(metallicRoughnessTexture)
    GLINT_PAIR(normalTexture)
    GLINT_PAIR(normalScale)
    GLINT_PAIR(occlusionTexture)
    GLINT_PAIR(occlusionStrength)
    GLINT_PAIR(emissiveFactor)
    GLINT_PAIR(emissiveTexture)
    GLINT_PAIR(specularFactor)
    GLINT_PAIR(specularTexture)
    GLINT_PAIR(specularColorFactor)
    GLINT_PAIR(specularColorTexture)
    GLINT_PAIR(ior)
    GLINT_PAIR(transmissionFactor)
    GLINT_PAIR(transmissionTexture)
    GLINT_PAIR(thicknessFactor)
    GLINT_PAIR(thicknessTexture)
    GLINT_PAIR(attenuationColor)
    GLINT_PAIR(attenuationDistance)
    GLINT_PAIR(clearcoatFactor)
    GLINT_PAIR(clearcoatRoughnessFactor)
    GLINT_PAIR(clearcoatTexture)
    GLINT_PAIR(clearcoatRoughnessTexture)
    GLINT_PAIR(clearcoatNormalTexture)
    GLINT_PAIR(clearcoatNormalScale)
    GLINT_PAIR(specularGlossiness)
    GLINT_PAIR(specularGlossinessFactor)
    GLINT_PAIR(glossinessFactor)
    GLINT_PAIR(specularGlossinessTexture)
}

template <class Visitor>
void members(Visitor& visitor, GlintVertexStream& c, VertexStream& cpp) {
    GLINT_PAIR(address)
    GLINT_PAIR(stride)
}

template <class Visitor>
void members(Visitor& visitor, GlintSurfaceMesh& c, SurfaceMesh& cpp) {
    GLINT_PAIR(positions)
    GLINT_PAIR(normals)
    GLINT_PAIR(tangents)
    GLINT_PAIR(uv0)
    GLINT_PAIR(uv1)
    GLINT_PAIR(colors)
    GLINT_PAIR(indices)
    GLINT_PAIR(previousPositions)
}

template <class Visitor>
void members(Visitor& visitor, GlintSurfaceInstance& c, SurfaceInstance& cpp) {
    GLINT_PAIR(mesh)
    GLINT_PAIR(material)
    GLINT_PAIR(localToWorld)
}

template <class Visitor>
void members(Visitor& visitor, GlintSurfaceLight& c, SurfaceLight& cpp) {
    GLINT_PAIR(kind)
    GLINT_PAIR(color)
    GLINT_PAIR(positionWS)
    GLINT_PAIR(directionWS)
    GLINT_PAIR(range)
    GLINT_PAIR(innerConeAngle)
    GLINT_PAIR(outerConeAngle)
    GLINT_PAIR(castsShadow)
}

template <class Visitor>
void members(Visitor& visitor, GlintSurfaceTableDesc& c, SurfaceTableDesc& cpp) { // and the lists (surfaces.cpp)
    GLINT_PAIR(maxInstances)
    GLINT_PAIR(maxLights)
}

template <class Visitor>
void members(Visitor& visitor, GlintPlanarMirror& c, PlanarMirror& cpp) {
    GLINT_PAIR(centerWS)
    GLINT_PAIR(normalWS)
    GLINT_PAIR(tangentWS)
    GLINT_PAIR(halfExtents)
    GLINT_PAIR(tolerance)
}

template <class Visitor>
void members(Visitor& visitor, GlintPlanarPicture& c, PlanarPicture& cpp) {
    GLINT_PAIR(radiance)
    GLINT_PAIR(depth)
    GLINT_PAIR(view)
}

template <class Visitor>
void members(Visitor& visitor, GlintPlanarMirrorsDesc& c, PlanarMirrorsDesc& cpp) { // and the mirrors (planar.cpp)
    GLINT_PAIR(width)
    GLINT_PAIR(height)
    GLINT_PAIR(conventions)
}

template <class Visitor>
void members(Visitor& visitor, GlintProbeVolume& c, ProbeVolume& cpp) {
    GLINT_PAIR(centerWS)
    GLINT_PAIR(rotation)
    GLINT_PAIR(halfExtents)
}

template <class Visitor>
void members(Visitor& visitor, GlintProbe& c, Probe& cpp) {
    GLINT_PAIR(cube)
    GLINT_PAIR(mips)
    GLINT_PAIR(prefiltered)
    GLINT_PAIR(alphaIsInverseDistance)
    GLINT_PAIR(capturePositionWS)
    GLINT_PAIR(strength)
    GLINT_PAIR(weight)
    GLINT_PAIR(shape)
    GLINT_PAIR(influence)
    GLINT_PAIR(blendDistance)
    GLINT_PAIR(blendNormalDistance)
    GLINT_PAIR(faceFade)
    GLINT_PAIR(proxy)
    GLINT_PAIR(proxyVolume)
}

template <class Visitor>
void members(Visitor& visitor, GlintProbesDesc& c, ProbesDesc& cpp) { // and the probes (probes.cpp)
    GLINT_PAIR(faceSize)
}

template <class Visitor>
void members(Visitor& visitor, GlintReflectionsDesc& c, ReflectionsDesc& cpp) { // and the settings (reflections.cpp)
    GLINT_PAIR(width)
    GLINT_PAIR(height)
    GLINT_PAIR(framesInFlight)
    GLINT_PAIR(statistics)
    GLINT_PAIR(views)
    GLINT_PAIR(transparentLayers)
    GLINT_PAIR(timers)
    GLINT_PAIR(inspection)
    GLINT_PAIR(inputCheck)
}

template <class Visitor>
void members(Visitor& visitor, GlintSettingInfo& c, SettingInfo& cpp) { // and texts and range (settings.cpp)
    GLINT_PAIR(defaultValue)
}

template <class Visitor>
void members(Visitor& visitor, GlintStatistics& c, Statistics& cpp) { // and outcomes and scene rays (reflections.cpp)
    GLINT_PAIR(rays)
    GLINT_PAIR(lookupsMean)
    GLINT_PAIR(lookups95)
}

template <class Visitor>
void members(Visitor& visitor, GlintMemoryReport& c, MemoryReport& cpp) { // and the uses (context.cpp)
    GLINT_PAIR(bytes)
    GLINT_PAIR(taken)
}

template <class Visitor>
void members(Visitor& visitor, GlintInputCheck& c, InputCheck& cpp) { // and the findings (inspection.cpp)
    GLINT_PAIR(tested)
    GLINT_PAIR(normalsAgree)
    GLINT_PAIR(motionCompared)
}

template <class Visitor>
void members(Visitor& visitor, GlintKnownPlane& c, KnownPlane& cpp) {
    GLINT_PAIR(pointWS)
    GLINT_PAIR(normalWS)
}

template <class Visitor>
void members(Visitor& visitor, GlintRayPoint& c, RayInspection::Point& cpp) {
    GLINT_PAIR(px)
    GLINT_PAIR(positionVS)
    GLINT_PAIR(positionWS)
    GLINT_PAIR(depth)
}

template <class Visitor>
void members(Visitor& visitor, GlintRayInspection& c, RayInspection& cpp) { // lists, texts, optionals: inspection.cpp
    GLINT_PAIR(pixel)
    GLINT_PAIR(rayPixel)
    GLINT_PAIR(background)
    GLINT_PAIR(depth)
    GLINT_PAIR(positionWS)
    GLINT_PAIR(normalWS)
    GLINT_PAIR(f0)
    GLINT_PAIR(perceptualRoughness)
    GLINT_PAIR(traced)
    GLINT_PAIR(start)
    GLINT_PAIR(end)
    GLINT_PAIR(directionVS)
    GLINT_PAIR(directionWS)
    GLINT_PAIR(maxLength)
    GLINT_PAIR(length)
    GLINT_PAIR(hit)
    GLINT_PAIR(answered)
    GLINT_PAIR(hitDepth)
    GLINT_PAIR(radiance)
    GLINT_PAIR(weight)
    GLINT_PAIR(lookups)
    GLINT_PAIR(iterations)
    GLINT_PAIR(truncated)
    GLINT_PAIR(sameAsFrame)
    GLINT_PAIR(totalWeight)
    GLINT_PAIR(reflected)
    GLINT_PAIR(composite)
}

#undef GLINT_PAIR

} // namespace glint::c_api
