// Denoises what screen and rays answer for one sampled direction of each rough surface's lobe: joins both, reuses the
// rays of neighbours, averages frames, and filters what noise is left. docs/techniques/rough.md.
#pragma once

#include "reflect/denoise/denoises.hpp"
#include "reflect/history.hpp"
#include "reflect/stages.hpp"
#include "shared/denoise_constants.h"

#include <functional>
#include <optional>

namespace glint::reflect {

struct DenoiserInputs {
    FrameInputs frame;
    Prepared prepared;
    gpu::Image* screenAnswer; ///< null: the source takes no part
    gpu::Image& screenRecord;
    gpu::Image* raysAnswer; ///< null: the source takes no part
    gpu::Image& raysRecord;
    bool raysFirst;
    std::optional<MirroredImages> mirrored; ///< of `rays`; empty if nothing behind mirrors is to be averaged
    /// Records the pass whose sentinels are paths (denoise.antilag gradient); empty: there are none.
    std::function<void(gpu::Frame& frame, const SentinelImages& images)> followPaths;
};

/// What the last frame's denoising decided, for views.
struct DenoiserHistory {
    gpu::Image& sentRay;    ///< denoise/sent_ray.glsl
    gpu::Image& meta;       ///< of the mean: denoise/accumulate.comp
    gpu::Image& metaBefore; ///< of the previous frame's
    gpu::Image& changed;    ///< denoise/change.comp
};

/// The images that the history has room for, besides those that every denoised frame needs: all that settings so far
/// needed.
struct DenoiserKept {
    bool fastMean = false; ///< the mean over few frames
    bool places = false;   ///< sentinels of either kind
    bool paths = false;
    bool stable = false; ///< the stabilized brightness
    bool operator==(const DenoiserKept&) const = default;
};

/// Created when settings first enable it.
class Denoiser {
public:
    /// Errors: OutOfMemory.
    static Result<std::unique_ptr<Denoiser>> create(StageContext& stages);

    static bool wanted(const Settings& settings) { return denoises(settings); }
    /// Creates the images that these settings need for the first time, and starts the history again. Errors:
    /// OutOfMemory.
    Result<void> make(const Settings& settings);

    /// Begins a frame, before its constants are resolved.
    void begin(gpu::Frame& frame);
    /// The next frame starts without history.
    void forgetFrames(HistoryReset reason) { history_.reset(reason); }
    /// `seconds`: since the previous frame.
    /// `mirrored`: this frame's mirrors show what is to be averaged.
    shared::DenoiseConstants constants(double seconds, bool mirrored) const;
    /// Copies the history's tag to `offset` of the frame's constants.
    void copyTag(gpu::Frame& frame, gpu::Buffer& target, size_t offset);

    /// The previous frame's decision of how many rough pixels send a ray.
    gpu::Image& rayRates();
    /// What the previous frame's mean is of: frames, luminance, nearness (denoise/accumulate.comp).
    gpu::Image& metaBefore();
    /// Returns the joined, denoised answer.
    gpu::Image& record(gpu::Frame& frame, const DenoiserInputs& inputs);
    /// Empty if the frame denoised nothing.
    std::optional<DenoiserHistory> history();
    /// Ends the frame. One in which neither screen nor rays took part leaves no history.
    void end(gpu::Frame& frame) { history_.end(frame, recorded_ ? HistoryReset::None : HistoryReset::NotLight); }

private:
    /// What tells of changed light besides the means (shaders/denoise/sentinel.glsl).
    enum class Sentinels : uint8_t {
        None,
        Places, ///< of the host's picture
        Paths,  ///< through the host's triangles
    };

    explicit Denoiser(StageContext& stages) : stages_(stages), history_(stages, History::Kind::Turns) {}
    Result<void> makeHistory(const DenoiserKept& kept);
    bool reusesTarget(const Settings& settings) const;
    bool comparesMeans() const;
    MirroredImages mirroredOf(const DenoiserInputs& inputs);
    void gather(gpu::Frame& frame, const DenoiserInputs& inputs);
    gpu::Image& findChange(gpu::Frame& frame, const DenoiserInputs& inputs);
    gpu::Image& stabilize(gpu::Frame& frame, const DenoiserInputs& inputs, gpu::Image& filtered, gpu::Image& spare);
    void lookAtPlaces(gpu::Frame& frame, const DenoiserInputs& inputs);

    StageContext& stages_;
    gpu::Pipeline gather_;
    gpu::Pipeline reuse_;
    gpu::Pipeline sentinels_;
    gpu::Pipeline change_;
    gpu::Pipeline accumulate_;
    gpu::Pipeline filter_;
    gpu::Pipeline rate_;
    gpu::Pipeline stabilize_;      ///< these three from the first settings that stabilize
    gpu::Image takenFrom_;         ///< RG16F: denoise/taken_from.glsl
    gpu::Image stabilized_;        ///< as answer_; with views, which also show what else it could be written to
    gpu::Image noisy_;             ///< RGBA16F: weight * radiance, weight, of one ray; then the answer
    gpu::Image reused_;            ///< as noisy_, with the rays of neighbours; absent if the screen's image serves
    gpu::Image sentRay_;           ///< RG32UI: denoise/sent_ray.glsl
    gpu::Image reusedMeta_;        ///< RG16F: denoise/reuse.comp
    gpu::Image hitMotion_;         ///< R32UI: lib/packed_motion.glsl
    gpu::Image noMirroredSurface_; ///< one texel, for absent DenoiserInputs::mirrored
    gpu::Image noMirroredLight_;
    gpu::Standing blank_;               ///< those two are initialized
    gpu::Image reusedMotion_;           ///< RGBA16F: denoise/reuse.comp
    gpu::Image sentinelChange_;         ///< RGBA16F, a texel for each tile: denoise/sentinels.comp
    gpu::Image changed_;                ///< RGBA16F, a texel for each tile: denoise/change.comp
    gpu::Image answer_;                 ///< RGBA16F: radiance, weight; with views, which also show noisy_
    gpu::Image* shownChange_ = nullptr; ///< changed_, or black: what the last frame read
    History history_;
    std::optional<DenoiserKept> kept_;     ///< empty until `make`
    bool recorded_ = false;                ///< in this frame
    Sentinels followed_ = Sentinels::None; ///< in this frame
};

} // namespace glint::reflect
