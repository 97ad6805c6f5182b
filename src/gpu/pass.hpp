// A pass is one expression, recorded at once:
//
//   frame.pass(linear_).read("viewZ", z).write("radianceWeight", out).push(constants).dispatch(width, height);
//
// Images and buffers are matched by name with the shader's own declarations. Barriers follow from what was read and
// written (gpu/sync.hpp); the debug label, the GPU timer and the list of written images come by themselves.
// There is no graph: nothing is reordered, dropped or kept for later, and recording allocates nothing.
#pragma once

#include "gpu/acceleration_structure.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/resources.hpp"
#include "gpu/timers.hpp"

#include <array>

namespace glint::gpu {

class Frame;

/// What a raster pass records between begin and end of rendering.
class Draws {
public:
    Draws(const Api& api, VkCommandBuffer commands, const Pipeline& pipeline)
        : api_(api), commands_(commands), pipeline_(pipeline) {}

    template <class T>
    Draws& push(const T& constants) {
        return pushBytes(&constants, sizeof(T));
    }
    /// Counter-clockwise is glTF's front; `mirrored` flips it for transforms with a negative determinant.
    Draws& cull(VkCullModeFlags mode, bool mirrored = false);
    Draws& scissor(uint32_t x, uint32_t y, uint32_t width, uint32_t height);  ///< pixels; nothing outside is drawn
    Draws& viewport(uint32_t x, uint32_t y, uint32_t width, uint32_t height); ///< pixels; +Y of the clip space is up
    void draw(uint32_t vertexCount, uint32_t instanceCount = 1, uint32_t firstVertex = 0, uint32_t firstInstance = 0);
    void drawIndexed(uint32_t indexCount, uint32_t firstIndex = 0, int32_t vertexOffset = 0, uint32_t instanceCount = 1,
                     uint32_t firstInstance = 0);

private:
    Draws& pushBytes(const void* data, size_t size);

    const Api& api_;
    VkCommandBuffer commands_;
    const Pipeline& pipeline_;
};

class Pass {
public:
    /// A sampled image (all mips), through `sampler`; integer and 32-bit float images, which Vulkan need not filter,
    /// are read with nearest filtering instead of linear.
    Pass& read(std::string_view name, Image& image, SamplerKind sampler = SamplerKind::LinearClamp);
    /// A uniform buffer or a readonly storage buffer.
    Pass& read(std::string_view name, Buffer& buffer);
    /// The scene that the shader's ray queries go through, and all that it refers to.
    Pass& read(std::string_view name, AccelerationStructure& top);
    /// A writeonly storage image, one mip of it; its old content is thrown away unless `keep`.
    Pass& write(std::string_view name, Image& image, uint32_t mip = 0, bool keep = false);
    Pass& write(std::string_view name, Buffer& buffer);
    /// A storage image or buffer that the shader both reads and writes.
    Pass& readWrite(std::string_view name, Image& image, uint32_t mip = 0);
    Pass& readWrite(std::string_view name, Buffer& buffer);

    bool rehearsing() const; ///< only checked, never run

    /// A texture table (gpu/texture_table.hpp) as set 1.
    Pass& table(VkDescriptorSet set);
    /// 32-bit indices for Draws::drawIndexed, made with INDEX_BUFFER usage.
    Pass& indices(Buffer& buffer);

    template <class T>
    Pass& push(const T& constants) {
        static_assert(sizeof(T) <= sizeof(pushed_));
        return pushBytes(&constants, sizeof(T));
    }

    /// Colour attachments in the order of the shader's outputs. Without `clear` the content is kept.
    Pass& color(Image& image, const VkClearColorValue* clear = nullptr, uint32_t mip = 0);
    /// The mean of the last colour attachment's samples goes here too, at the end of the pass.
    Pass& resolve(Image& image);
    Pass& depth(Image& image, bool clear, bool writes = true); ///< cleared to 0: infinitely far
    /// Shows one layer of an array image as the depth attachment.
    Pass& depthView(Image& image, VkImageView layerView, bool clear);

    /// One thread for each of width * height * depth elements: rounded up to whole groups.
    void dispatch(uint32_t width, uint32_t height = 1, uint32_t depth = 1);
    /// As many groups as the three words at `offset` of `arguments` say when the pass runs.
    void dispatchIndirect(Buffer& arguments, size_t offset = 0);
    /// Draws what `record(Draws&)` draws over the attachments' whole area.
    template <class Record>
    void draw(Record&& record) {
        if (Draws draws = beginDraws(); ready_) {
            record(draws);
            endDraws();
        }
    }

private:
    friend class Frame;
    Pass(Frame& frame, const Pipeline& pipeline) : frame_(frame), pipeline_(pipeline) {}

    enum class ResourceKind : uint8_t { Image, Buffer, AccelerationStructure };
    static ResourceKind resourceKind(BindingKind kind);
    static const char* kindWord(ResourceKind kind);
    const ShaderBinding* find(std::string_view name, bool reads, bool writes, ResourceKind kind);
    void bindImage(const ShaderBinding& binding, VkImageView view, VkImageLayout layout, VkSampler sampler);
    void bindBuffer(const ShaderBinding& binding, Buffer& buffer, bool writes);
    Pass& pushBytes(const void* data, size_t size);
    bool begin();
    Draws beginDraws();
    void endDraws();

    struct Attachment {
        Image* image = nullptr;
        VkRenderingAttachmentInfo info = {VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    };

    Frame& frame_;
    const Pipeline& pipeline_;
    std::array<VkDescriptorImageInfo, kMaxBindings> imageInfos_;
    std::array<VkDescriptorBufferInfo, kMaxBindings> bufferInfos_;
    std::array<VkWriteDescriptorSet, kMaxBindings> writes_;
    VkWriteDescriptorSetAccelerationStructureKHR sceneWrite_ = {
        VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR};
    VkAccelerationStructureKHR scene_ = VK_NULL_HANDLE; ///< a pass has one
    uint32_t bound_ = 0;
    uint32_t boundMask_ = 0; ///< by index into pipeline_.bindings()
    std::array<std::byte, 128> pushed_;
    size_t pushedSize_ = 0;
    VkDescriptorSet table_ = VK_NULL_HANDLE;
    VkBuffer indices_ = VK_NULL_HANDLE;
    std::array<Attachment, 8> colors_;
    uint32_t colorCount_ = 0;
    Attachment depth_;
    bool ready_ = false;
};

/// An image that a pass wrote, for debug views: "trace/linear:radianceWeight".
struct WrittenImage {
    const std::string* pass = nullptr;
    std::string_view binding;
    Image* image = nullptr;
};

/// One frame's recording into one command buffer.
class Frame {
public:
    Frame(Context& context, VkCommandBuffer commands, Timers* timers = nullptr,
          std::vector<WrittenImage>* written = nullptr);
    /// More of a frame whose timers were begun before, in the same command buffer.
    static Frame more(Context& context, VkCommandBuffer commands, Timers& timers);
    /// Records nothing, but checks every name, kind and push size on the way: a library rehearses each frame that it
    /// may have to record when it is created, so that recording cannot fail. `firstError` tells.
    static Frame rehearsal(Context& context);

    Pass pass(const Pipeline& pipeline) { return Pass(*this, pipeline); }

    /// Copies `size` bytes, a multiple of 4, into the command buffer and from there to `offset` of a buffer made with
    /// TRANSFER_DST; up to 65536 a command. For what changes each frame: nothing else has to be kept until it ran.
    void update(Buffer& buffer, const void* data, size_t size, size_t offset = 0);
    /// The whole of an upload buffer to the start of one made with TRANSFER_DST.
    void upload(Buffer& staging, Buffer& target);
    /// Builds acceleration structures from their inputs, as many at once as `scratch` has room for; it has at least the
    /// largest scratchSize(). They may not refer to each other.
    void build(std::span<AccelerationStructure* const> structures, Buffer& scratch);
    /// Fits such as were made to be updated to their inputs' new content, the trees staying as they are.
    void refit(std::span<AccelerationStructure* const> structures, Buffer& scratch);
    /// A label and a GPU timer around what is not a pass.
    template <class Record>
    void scope(const std::string& name, Record&& record) {
        if (!rehearsing())
            beginScope(name);
        record();
        if (!rehearsing())
            endScope();
    }
    void fill(Buffer& buffer, uint32_t value);
    void clear(Image& image, const VkClearColorValue& value);
    /// Brings the image into a state that others expect: a host's, or the next tool's.
    void hand(Image& image, const Use& use);
    void hand(Buffer& buffer, const Use& use);
    void copyToBuffer(Image& image, uint32_t mip, uint32_t layer, Buffer& buffer);
    void copyFromBuffer(Buffer& buffer, size_t offset, Image& image, uint32_t mip, uint32_t layer);
    /// Makes the rest of the mip chain from level 0 by box filtering (linear formats and sRGB alike).
    void makeMips(Image& image);
    void copy(Image& source, Image& target);
    /// The same between formats, both of one size; colours are converted, as from RGBA to BGRA.
    void convert(Image& source, Image& target);
    /// The mean of a colour image's samples, into an image with one sample a pixel.
    void resolve(Image& source, Image& target);
    /// Into a readback buffer of the same size, visible to the CPU once the GPU is done.
    void copyBuffer(Buffer& source, Buffer& readback);

    Context& context() { return context_; }
    VkCommandBuffer commands() const { return commands_; }
    bool rehearsing() const { return commands_ == VK_NULL_HANDLE; }
    Result<void> firstError() const;

private:
    friend class Pass;

    void use(Image& image, uint32_t firstMip, uint32_t mipCount, const Use& use);
    void use(Buffer& buffer, const Use& use);
    void buildAll(std::span<AccelerationStructure* const> structures, Buffer& scratch, bool refit);
    void flushBarriers();
    void fail(std::string message);
    void beginScope(const std::string& name);
    void endScope();

    Context& context_;
    VkCommandBuffer commands_;
    Timers* timers_;
    std::vector<WrittenImage>* written_;
    std::array<VkImageMemoryBarrier2, 48> imageBarriers_;
    std::array<VkBufferMemoryBarrier2, 24> bufferBarriers_;
    uint32_t imageBarrierCount_ = 0;
    uint32_t bufferBarrierCount_ = 0;
    std::string error_;
};

} // namespace glint::gpu
