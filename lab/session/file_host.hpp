// A host whose G-buffer was read from files: it draws nothing and has no scene. The view, and all that the G-buffer
// shows, stay as they are until the next frame of a sequence.
#pragma once

#include "lab/gbuffer_files/gbuffer_pixels.hpp"
#include "lab/renderer/display_pass.hpp"
#include "lab/renderer/environment.hpp"
#include "lab/session/host_frame.hpp"
#include "lab/sources/probe_world.hpp"

namespace glint::render {

class FileHost final : public HostFrame {
public:
    /// `inputs`   without a scene: size, camera and environment
    /// `pixels`   of the same size; hosts that are remade share them
    /// `probes`   null: none
    /// `library`  the device of `context` as adopted by the library. Both must outlive the host
    /// Errors: those of the device and the settings.
    static Result<std::unique_ptr<FileHost>> create(gpu::Context& context, Context& library,
                                                    std::shared_ptr<JobInputs> inputs,
                                                    std::shared_ptr<const scene::GBufferPixels> pixels,
                                                    std::shared_ptr<const ProbeSet> probes,
                                                    const ProgramSettings& settings);

    /// Lends another frame of a sequence from now on, of the same size: motion is relative to the frame before.
    /// Errors: OutOfMemory, DeviceLost.
    Result<void> setFrame(std::shared_ptr<JobInputs> inputs, std::shared_ptr<const scene::GBufferPixels> pixels);

    const JobInputs& inputs() const override { return *inputs_; }
    View view() const override { return view_; }

    Result<void> setSettings(const ProgramSettings& settings) override;
    Result<void> resize(uint32_t width, uint32_t height) override;
    Result<void> setCamera(const scene::Camera& camera) override;
    Result<bool> setTime(double seconds, Reflections& reflections) override;
    Result<bool> setMaterials(const scene::MaterialOverrides& overrides, Reflections& reflections) override;
    Result<std::unique_ptr<HostFrame>> remade(Context& library) override;

    Result<void> draw(gpu::Frame&, VkCommandBuffer, uint32_t) override { return {}; }
    bool drawsAlike() const override { return true; }
    GBuffer& gbuffer() override { return gbuffer_; }
    glint::GBuffer lend(gpu::Frame& frame) override;
    EnvironmentMap lendEnvironment(gpu::Frame& frame) override;
    void recordSources(VkCommandBuffer) override {}
    Result<HostImage> drawLayers(gpu::Frame&, VkCommandBuffer, Reflections&, HostImage lit) override { return lit; }
    void drawTransparent(gpu::Frame&, gpu::Image&, bool) override {}
    void display(gpu::Frame& frame, gpu::Image& radiance, gpu::Image& target) override;

    bool hasLayers() const override { return false; }
    Result<void> giveSources(Reflections& reflections) override;
    std::vector<std::pair<std::string, double>> passTimes() override { return {}; }

private:
    FileHost(gpu::Context& context, Context& library, std::shared_ptr<JobInputs> inputs,
             std::shared_ptr<const scene::GBufferPixels> pixels, std::shared_ptr<const ProbeSet> probes,
             const ProgramSettings& settings)
        : context_(context), library_(library), inputs_(std::move(inputs)), pixels_(std::move(pixels)),
          probeSet_(std::move(probes)), settings_(settings) {}
    Result<void> make();
    Result<void> upload();

    gpu::Context& context_;
    Context& library_;
    std::shared_ptr<JobInputs> inputs_;
    std::shared_ptr<const scene::GBufferPixels> pixels_;
    std::shared_ptr<const ProbeSet> probeSet_;
    ProgramSettings settings_;
    View view_;
    bool follows_ = false; ///< a frame of a sequence, not its first
    GBuffer gbuffer_;
    Environment environment_;
    DisplayPass display_;
    std::unique_ptr<ProbeWorld> probes_; ///< absent without a set
};

} // namespace glint::render
