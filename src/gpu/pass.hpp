// A pass is one expression, recorded at once:
//
//   frame.pass(linear_).read("viewZ", z).write("radianceWeight", out).push(constants).dispatch(width, height);
//
// Images and buffers are matched by name with the shader's declarations. Barriers follow from the reads and writes
// (gpu/sync.hpp). The debug label, the GPU timer and the list of written images are automatic. There is no graph:
// passes are not reordered, dropped or deferred, and recording allocates nothing.
#pragma once

#include "gpu/acceleration_structure.hpp"
#include "gpu/dirty_ranges.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/resources.hpp"
#include "gpu/timers.hpp"

#include <array>

namespace glint::gpu {

class Frame;

/// Records draw commands between begin and end of rendering of a raster pass.
class Draws {
public:
    Draws(const Api& api, VkCommandBuffer commands, const Pipeline& pipeline)
        : api_(api), commands_(commands), pipeline_(pipeline) {}

    template <class T>
    Draws& push(const T& constants) {
        return pushBytes(&constants, sizeof(T));
    }
    /// Counter-clockwise triangles are front faces, as in glTF; `mirrored` reverses that, for transforms with a
    /// negative determinant.
    Draws& cull(VkCullModeFlags mode, bool mirrored = false);
    Draws& scissor(uint32_t x, uint32_t y, uint32_t width, uint32_t height);  ///< pixels; nothing is drawn outside
    Draws& viewport(uint32_t x, uint32_t y, uint32_t width, uint32_t height); ///< pixels; +Y of clip space is up
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
    /// Binds a sampled image (all mips) with `sampler`. Integer and 32-bit float images, which Vulkan need not filter,
    /// use nearest filtering instead of linear.
    Pass& read(std::string_view name, Image& image, SamplerKind sampler = SamplerKind::LinearClamp);
    /// Binds an array of sampled images; the count must equal the shader's array length.
    Pass& read(std::string_view name, std::span<Image* const> images, SamplerKind sampler = SamplerKind::LinearClamp);
    /// Binds a uniform buffer or a readonly storage buffer.
    Pass& read(std::string_view name, Buffer& buffer);
    /// Makes visible what shaders read by the buffer's address.
    Pass& readByAddress(Buffer& buffer);
    /// Binds the top level that the shader's ray queries trace, and makes every structure it refers to readable.
    Pass& read(std::string_view name, AccelerationStructure& top);
    /// Binds a host's top level, whose barriers are the host's.
    Pass& read(std::string_view name, VkAccelerationStructureKHR top);
    /// Binds one mip of a writeonly storage image; its old content is discarded unless `keep`.
    Pass& write(std::string_view name, Image& image, uint32_t mip = 0, bool keep = false);
    Pass& write(std::string_view name, Buffer& buffer);
    /// Binds a storage image or buffer that the shader both reads and writes.
    Pass& readWrite(std::string_view name, Image& image, uint32_t mip = 0);
    Pass& readWrite(std::string_view name, Buffer& buffer);

    bool rehearsing() const; ///< True if the pass is only checked, never executed.

    /// Binds a texture table (gpu/texture_table.hpp) as set 1.
    Pass& table(VkDescriptorSet set);
    /// Binds 32-bit indices for Draws::drawIndexed; the buffer needs INDEX_BUFFER usage.
    Pass& indices(Buffer& buffer);

    template <class T>
    Pass& push(const T& constants) {
        static_assert(sizeof(T) <= sizeof(pushed_));
        return pushBytes(&constants, sizeof(T));
    }

    /// Adds a colour attachment, in the order of the shader's outputs. Without `clear` its content is kept.
    Pass& color(Image& image, const VkClearColorValue* clear = nullptr, uint32_t mip = 0);
    /// At the end of the pass, resolves the last colour attachment's samples to their mean in `image`.
    Pass& resolve(Image& image);
    Pass& depth(Image& image, bool clear, bool writes = true); ///< the clear value is 0: infinitely far
    /// Uses one layer of an array image as the depth attachment.
    Pass& depthView(Image& image, VkImageView layerView, bool clear);

    /// Dispatches one thread for each of width * height * depth elements, rounded up to whole workgroups.
    void dispatch(uint32_t width, uint32_t height = 1, uint32_t depth = 1);
    /// Dispatches the group counts that are stored as three words at `offset` of `arguments` when the pass executes.
    void dispatchIndirect(Buffer& arguments, size_t offset = 0);
    /// Calls `record(Draws&)` for draws over the attachments' whole area.
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
    VkDescriptorImageInfo sampled(Image& image, SamplerKind sampler);

    std::array<VkDescriptorImageInfo, kMaxBindings> imageInfos_;
    std::array<VkDescriptorImageInfo, kMaxArrayImages> arrayInfos_;
    uint32_t arrayImages_ = 0;
    std::array<VkDescriptorBufferInfo, kMaxBindings> bufferInfos_;
    std::array<VkWriteDescriptorSet, kMaxBindings> writes_;
    VkWriteDescriptorSetAccelerationStructureKHR sceneWrite_ = {
        VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR};
    VkAccelerationStructureKHR scene_ = VK_NULL_HANDLE; ///< at most one per pass
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

/// An image written by a pass, for debug views: "trace/linear:radianceWeight".
struct WrittenImage {
    const std::string* pass = nullptr;
    std::string_view binding;
    Image* image = nullptr;
};

/// Records one frame into one command buffer. A host may drop its command buffers, so on a host's device a Frame
/// assumes nothing of earlier recordings but their order on the queue: the first use of an image or buffer waits for
/// all earlier commands and expects the image in its resting layout, and the end of the Frame returns the image to that
/// layout (Image::rest).
class Frame {
public:
    /// `written` takes the images that passes write, as many as it has capacity for.
    Frame(Context& context, VkCommandBuffer commands, Timers* timers = nullptr,
          std::vector<WrittenImage>* written = nullptr);
    ~Frame();
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;
    /// Continues a frame whose timers have begun, in the same command buffer.
    static Frame more(Context& context, VkCommandBuffer commands, Timers* timers);
    /// Records nothing, but checks every name, binding kind and push size. When a library is created, it rehearses each
    /// frame that it may record later, so that recording cannot fail. `firstError` returns the first error.
    static Frame rehearsal(Context& context);

    Pass pass(const Pipeline& pipeline) { return Pass(*this, pipeline); }

    /// Copies `size` bytes, a multiple of 4, into the command buffer and from there to `offset` of a buffer with
    /// TRANSFER_DST usage; at most 65536 per command. For data that change each frame: `data` need not stay valid until
    /// execution.
    void update(Buffer& buffer, const void* data, size_t size, size_t offset = 0);
    /// As update, for parts of a buffer that `content` is all of.
    void update(Buffer& buffer, std::span<const std::byte> content, std::span<const ByteRange> parts);
    /// Copies a whole upload buffer to the start of a buffer with TRANSFER_DST usage.
    void upload(Buffer& staging, Buffer& target);
    /// Builds acceleration structures from their inputs, as many in parallel as `scratch` has room for; `scratch` must
    /// hold at least the largest scratchSize(). The structures must not refer to each other.
    void build(std::span<AccelerationStructure* const> structures, Buffer& scratch);
    /// Refits updatable structures to the new content of their inputs; the trees keep their topology.
    void refit(std::span<AccelerationStructure* const> structures, Buffer& scratch);
    /// Puts a label and a GPU timer around commands that are not a pass.
    template <class Record>
    void scope(const char* name, Record&& record) {
        if (!rehearsing())
            beginScope(name);
        record();
        if (!rehearsing())
            endScope();
    }
    /// Records passes without timers of their own. A scope around them has a timer, and timers do not nest.
    template <class Record>
    void untimed(Record&& record) {
        Timers* const timers = std::exchange(timers_, nullptr);
        record();
        timers_ = timers;
    }
    /// Records passes whose images are not noted as written, where the same passes run a second time.
    template <class Record>
    void unnoted(Record&& record) {
        std::vector<WrittenImage>* const written = std::exchange(written_, nullptr);
        record();
        written_ = written;
    }
    void fill(Buffer& buffer, uint32_t value);
    /// Copies `size` bytes, a multiple of 4, from one buffer to another.
    void copyBytes(Buffer& source, size_t sourceOffset, Buffer& target, size_t targetOffset, size_t size);
    /// Writes `value` at `offset` of a readback buffer when all commands recorded before are complete.
    void mark(Buffer& readback, uint32_t value, size_t offset);
    void clear(Image& image, const VkClearColorValue& value);
    /// Transitions the image to the state that its next user expects: a host or another tool.
    void hand(Image& image, const Use& use);
    void hand(Buffer& buffer, const Use& use);
    /// For this once, a resting image is in layout `layout`, and others may have written to it: for a host's own passes
    /// between ours.
    void find(Image& image, VkImageLayout layout);
    void copyToBuffer(Image& image, uint32_t mip, uint32_t layer, Buffer& buffer);
    void copyFromBuffer(Buffer& buffer, size_t offset, Image& image, uint32_t mip, uint32_t layer);
    /// Makes mips 1 and up from level 0 by box filtering; for linear and sRGB formats.
    void makeMips(Image& image);
    void copy(Image& source, Image& target);
    /// Copies between formats; both images have the same size. Colours are converted, for example from RGBA to BGRA.
    void convert(Image& source, Image& target);
    /// Resolves a colour image to the mean of its samples, into an image with one sample per pixel.
    void resolve(Image& source, Image& target);
    /// Copies to a readback buffer of the same size, which the CPU can read once the GPU has finished.
    void copyBuffer(Buffer& source, Buffer& readback);

    Context& context() { return context_; }
    VkCommandBuffer commands() const { return commands_; }
    bool rehearsing() const { return commands_ == VK_NULL_HANDLE; }
    Result<void> firstError() const;

private:
    friend class Pass;

    Frame(Context& context, VkCommandBuffer commands, Timers* timers, std::vector<WrittenImage>* written, bool begins);

    void noteWritten(const std::string& pass, std::string_view binding, Image& image);
    void enter(Image& image);
    void enter(Buffer& buffer);
    void settle();
    void use(Image& image, uint32_t firstMip, uint32_t mipCount, const Use& use);
    void use(Buffer& buffer, const Use& use);
    void buildAll(std::span<AccelerationStructure* const> structures, Buffer& scratch, bool refit);
    void flushBarriers();
    void copyIn(Buffer& buffer, const std::byte* data, size_t size, size_t offset);
    void fail(std::string message);
    void beginScope(const char* name);
    void endScope();

    Context& context_;
    VkCommandBuffer commands_;
    Timers* timers_;
    std::vector<WrittenImage>* written_;
    std::array<VkImageMemoryBarrier2, 48> imageBarriers_;
    std::array<VkBufferMemoryBarrier2, 24> bufferBarriers_;
    uint32_t imageBarrierCount_ = 0;
    uint32_t bufferBarrierCount_ = 0;
    uint64_t recording_;
    std::array<Image*, 256> resting_; ///< used images that have a resting layout
    uint32_t restingCount_ = 0;
    std::string error_;
};

} // namespace glint::gpu
