// `trace/picture`: smaller copies of the picture, from which cones of rough surfaces take a hit's mean radiance
// (rough.cones).
#pragma once

#include "reflect/stage_list.hpp"

namespace glint::reflect {

class ConePicture {
public:
    /// True if hits are blurred by the width of the surface's lobe: where rays take mirror directions, and nothing else
    /// blurs them.
    static bool wanted(const Settings& settings);
    static constexpr std::string_view kName = "trace/picture";
    static constexpr Moment kMoment = Moment::BeforeMarch;

    static Result<std::unique_ptr<ConePicture>> create(StageContext& stages);

    /// Compiles the pass and creates the image when settings first need them. Errors: OutOfMemory, Unsupported.
    Result<void> make(const Settings& settings);
    /// Initializes the image, which an inspection may read before a frame with rays wrote it.
    void clear(gpu::Frame& frame);
    /// Builds the copies if rays start on rough surfaces: of the previous frame if hits take its colours, else of this
    /// one.
    void record(gpu::Frame& frame, const StageInputs& stage);

    /// RGBA16F; level n shows 2^(n+1) pixels a side. Absent until made.
    gpu::Image& image() { return image_; }

private:
    explicit ConePicture(StageContext& stages) : stages_(stages) {}

    StageContext& stages_;
    gpu::Pipeline pass_;
    gpu::Image image_;
    gpu::Standing blank_; ///< image_ is initialized
};

} // namespace glint::reflect
