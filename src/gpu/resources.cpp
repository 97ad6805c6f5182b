#include "gpu/resources.hpp"

#include "gpu/memory.hpp"

namespace glint::gpu {
namespace {

VkImageViewType viewType(ImageShape shape) {
    switch (shape) {
    case ImageShape::Flat: return VK_IMAGE_VIEW_TYPE_2D;
    case ImageShape::Array: return VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    case ImageShape::Cube: return VK_IMAGE_VIEW_TYPE_CUBE;
    }
    return VK_IMAGE_VIEW_TYPE_2D;
}

bool hasStencil(VkFormat format) {
    return format == VK_FORMAT_D32_SFLOAT_S8_UINT || format == VK_FORMAT_D24_UNORM_S8_UINT ||
           format == VK_FORMAT_D16_UNORM_S8_UINT;
}

} // namespace

bool isDepth(VkFormat format) {
    return format == VK_FORMAT_D32_SFLOAT || format == VK_FORMAT_D16_UNORM || format == VK_FORMAT_X8_D24_UNORM_PACK32 ||
           hasStencil(format);
}

VkImageAspectFlags Image::aspect() const {
    return isDepth(desc_.format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

VkImageAspectFlags Image::barrierAspect() const {
    return aspect() | (hasStencil(desc_.format) ? VK_IMAGE_ASPECT_STENCIL_BIT : 0);
}

Result<Image> Image::create(Context& context, const ImageDesc& desc) {
    Image image;
    image.context_ = &context;
    image.desc_ = desc;
    image.states_.resize(desc.mips);
    if (context.adopted())
        image.rest_ = (desc.usage & VK_IMAGE_USAGE_SAMPLED_BIT) != 0 ? VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL
                                                                     : VK_IMAGE_LAYOUT_GENERAL;

    VkImageCreateInfo info = {VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.flags = desc.shape == ImageShape::Cube ? VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT : 0;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = desc.format;
    info.extent = {desc.width, desc.height, 1};
    info.mipLevels = desc.mips;
    info.arrayLayers = desc.layers;
    info.samples = static_cast<VkSampleCountFlagBits>(desc.samples);
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = desc.usage;
    if (const VkResult result = createImage(context.allocator(), info, image.image_, image.allocation_);
        result != VK_SUCCESS)
        return makeError(ErrorCode::OutOfMemory, "image '{}' ({}x{}, {} mips) cannot be created: VkResult {}",
                         desc.name, desc.width, desc.height, desc.mips, static_cast<int>(result));
    context.memoryUses()[image.allocation_] = {desc.name, bytesOf(context.allocator(), image.allocation_)};
    context.nameObject(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(image.image_), desc.name.c_str());

    const auto makeView = [&](VkImageViewType type, uint32_t baseMip, uint32_t mips, VkImageView& view) {
        VkImageViewCreateInfo viewInfo = {VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
        viewInfo.image = image.image_;
        viewInfo.viewType = type;
        viewInfo.format = desc.format;
        viewInfo.subresourceRange = {image.aspect(), baseMip, mips, 0, desc.layers};
        const VkResult result = context.api().CreateImageView(context.device(), &viewInfo, context.callbacks(), &view);
        if (result == VK_SUCCESS)
            context.nameObject(VK_OBJECT_TYPE_IMAGE_VIEW, reinterpret_cast<uint64_t>(view), desc.name.c_str());
        return result == VK_SUCCESS;
    };
    bool made = makeView(viewType(desc.shape), 0, desc.mips, image.view_);
    // Views for storage images and attachments have one mip; storage views of a cube are arrays of its six faces.
    const bool single = desc.mips == 1 && desc.shape != ImageShape::Cube;
    if (!single) {
        image.mipViews_.resize(desc.mips, VK_NULL_HANDLE);
        for (uint32_t mip = 0; mip < desc.mips; ++mip)
            made = made && makeView(desc.layers > 1 ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D, mip, 1,
                                    image.mipViews_[mip]);
    }
    if (!made)
        return makeError(ErrorCode::OutOfMemory, "image '{}': its view cannot be created", desc.name);
    return image;
}

Image Image::borrow(VkImage handle, VkImageView view, const ImageDesc& desc, const ResourceState& state) {
    Image image;
    image.desc_ = desc;
    image.image_ = handle;
    image.view_ = view;
    image.states_.assign(desc.mips, state);
    return image;
}

VkImageView Image::mipView(uint32_t mip) const {
    return mipViews_.empty() ? view_ : mipViews_[mip];
}

void Image::destroy() {
    if (!context_ || !image_)
        return;
    const Api& api = context_->api();
    for (VkImageView view : mipViews_)
        api.DestroyImageView(context_->device(), view, context_->callbacks());
    api.DestroyImageView(context_->device(), view_, context_->callbacks());
    context_->memoryUses().erase(allocation_);
    destroyImage(context_->allocator(), image_, allocation_);
    image_ = VK_NULL_HANDLE;
}

void Image::swap(Image& other) {
    std::swap(context_, other.context_);
    std::swap(desc_, other.desc_);
    std::swap(image_, other.image_);
    std::swap(allocation_, other.allocation_);
    std::swap(view_, other.view_);
    std::swap(mipViews_, other.mipViews_);
    std::swap(states_, other.states_);
    std::swap(rest_, other.rest_);
    std::swap(recording_, other.recording_);
}

Result<Buffer> Buffer::create(Context& context, const BufferDesc& desc) {
    Buffer buffer;
    buffer.context_ = &context;
    buffer.desc_ = desc;
    VkBufferCreateInfo info = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = desc.size;
    info.usage = desc.usage;
    if (const VkResult result =
            createBuffer(context.allocator(), info, desc.home, buffer.buffer_, buffer.allocation_, buffer.mapped_);
        result != VK_SUCCESS)
        return makeError(ErrorCode::OutOfMemory, "buffer '{}' ({} bytes) cannot be created: VkResult {}", desc.name,
                         desc.size, static_cast<int>(result));
    context.memoryUses()[buffer.allocation_] = {desc.name, bytesOf(context.allocator(), buffer.allocation_)};
    context.nameObject(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<uint64_t>(buffer.buffer_), desc.name.c_str());
    return buffer;
}

VkDeviceAddress Buffer::address() const {
    const VkBufferDeviceAddressInfo info = {VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO, nullptr, buffer_};
    return context_->api().GetBufferDeviceAddress(context_->device(), &info);
}

void Buffer::destroy() {
    if (context_ && buffer_) {
        context_->memoryUses().erase(allocation_);
        destroyBuffer(context_->allocator(), buffer_, allocation_);
    }
    buffer_ = VK_NULL_HANDLE;
}

void Buffer::swap(Buffer& other) {
    std::swap(context_, other.context_);
    std::swap(desc_, other.desc_);
    std::swap(buffer_, other.buffer_);
    std::swap(allocation_, other.allocation_);
    std::swap(mapped_, other.mapped_);
    std::swap(state_, other.state_);
    std::swap(recording_, other.recording_);
}

} // namespace glint::gpu
