#include "lab/scene/gltf/textures.hpp"

#include "lab/scene/gltf/uri_loading.hpp"
#include "lab/scene/images/image_decode.hpp"

#include <optional>

namespace glint::scene::gltf {
namespace {

// OpenGL's numbers, which glTF uses.
constexpr uint64_t kNearest = 9728;
constexpr uint64_t kLinear = 9729;
constexpr uint64_t kNearestMipmapNearest = 9984;
constexpr uint64_t kLinearMipmapNearest = 9985;
constexpr uint64_t kNearestMipmapLinear = 9986;
constexpr uint64_t kLinearMipmapLinear = 9987;
constexpr uint64_t kClampToEdge = 33071;
constexpr uint64_t kMirroredRepeat = 33648;
constexpr uint64_t kRepeat = 10497;

Wrap readWrap(const JsonObject& sampler, const char* key) {
    switch (const uint64_t number = sampler.count(key).value_or(kRepeat)) {
    case kRepeat: return Wrap::Repeat;
    case kMirroredRepeat: return Wrap::MirroredRepeat;
    case kClampToEdge: return Wrap::ClampToEdge;
    default: sampler.diagnostics().fail("{} is {}, which is no wrapping mode of glTF", sampler.pathOf(key), number);
    }
    return Wrap::Repeat;
}

void readMinFilter(const JsonObject& object, Sampler& sampler) {
    const auto set = [&](Filter filter, MipFilter mipFilter) {
        sampler.minFilter = filter;
        sampler.mipFilter = mipFilter;
    };
    switch (const uint64_t number = object.count("minFilter").value_or(kLinearMipmapLinear)) {
    case kNearest: return set(Filter::Nearest, MipFilter::None);
    case kLinear: return set(Filter::Linear, MipFilter::None);
    case kNearestMipmapNearest: return set(Filter::Nearest, MipFilter::Nearest);
    case kLinearMipmapNearest: return set(Filter::Linear, MipFilter::Nearest);
    case kNearestMipmapLinear: return set(Filter::Nearest, MipFilter::Linear);
    case kLinearMipmapLinear: return set(Filter::Linear, MipFilter::Linear);
    default: object.diagnostics().fail("{} is {}, which is no filter of glTF", object.pathOf("minFilter"), number);
    }
}

Sampler readSampler(const JsonObject& object) {
    Sampler sampler;
    const uint64_t magFilter = object.count("magFilter").value_or(kLinear);
    if (magFilter != kNearest && magFilter != kLinear)
        object.diagnostics().fail("{} is {}, which is no filter of glTF", object.pathOf("magFilter"), magFilter);
    sampler.magFilter = magFilter == kNearest ? Filter::Nearest : Filter::Linear;
    readMinFilter(object, sampler);
    sampler.wrapU = readWrap(object, "wrapS");
    sampler.wrapV = readWrap(object, "wrapT");
    return sampler;
}

/// "Box.gltf: images[0] (Box.png)": names a damaged image's file in messages.
std::string imageLabel(const Document& document, const JsonObject& object) {
    const std::string uri = object.string("uri");
    const std::string name = uri.empty() || uri.starts_with("data:") ? object.string("name") : uri;
    return fmt::format("{}: {}{}", document.diagnostics.file(), object.path(), name.empty() ? "" : " (" + name + ")");
}

/// Empty after an error, and for KTX2, which is not an error.
std::optional<Image> readImage(Document& document, const JsonObject& object) {
    std::vector<uint8_t> loaded;
    std::span<const uint8_t> bytes;
    if (object.has("uri")) {
        loaded = loadUri(document, object, object.string("uri"));
        bytes = loaded;
    } else {
        const int view = object.requiredIndex("bufferView", document.views.size(), "bufferViews");
        if (view >= 0)
            bytes = document.views[size_t(view)].bytes;
    }
    if (document.failed())
        return std::nullopt;
    auto image = decodeImage(bytes, imageLabel(document, object), document.limits.imagePixels);
    if (!image && image.error().code == ErrorCode::Unsupported)
        return std::nullopt;
    if (!image) {
        document.diagnostics.fail(std::move(image).error());
        return std::nullopt;
    }
    if (!document.reserve(image->rgba.size(), object.path()))
        return std::nullopt;
    image->name = object.has("name") ? object.string("name") : object.string("uri").substr(0, 200);
    return std::move(image).value();
}

/// Returns the index of a texture's image: WebP if present, otherwise the core source; -1: none that can be read.
int readSource(const JsonObject& texture, size_t imageCount) {
    const int webp = texture.extension("EXT_texture_webp").index("source", imageCount, "images");
    return webp >= 0 ? webp : texture.index("source", imageCount, "images");
}

/// The images of a file, each decoded on first use.
class Images {
public:
    explicit Images(std::vector<JsonObject> objects) : objects_(std::move(objects)), loaded_(objects_.size()) {}

    size_t size() const { return objects_.size(); }

    /// Returns the index in Scene::images of the file's image `source`; -1 for KTX2 or after an error.
    int load(Document& document, int source, Scene& scene) {
        std::optional<int>& index = loaded_[size_t(source)];
        if (!index) {
            std::optional<Image> image = readImage(document, objects_[size_t(source)]);
            index = image ? static_cast<int>(scene.images.size()) : -1;
            if (image)
                scene.images.push_back(std::move(*image));
        }
        return *index;
    }

private:
    std::vector<JsonObject> objects_;
    std::vector<std::optional<int>> loaded_;
};

} // namespace

void readTextures(Document& document, Scene& scene) {
    const JsonObject root = document.root();
    std::vector<Sampler> samplers;
    for (const JsonObject& object : root.objects("samplers"))
        samplers.push_back(readSampler(object));

    Images images(root.objects("images"));
    bool anyWhite = false;
    for (const JsonObject& object : root.objects("textures")) {
        Texture texture;
        if (const int sampler = object.index("sampler", samplers.size(), "samplers"); sampler >= 0)
            texture.sampler = samplers[size_t(sampler)];
        const int source = readSource(object, images.size());
        if (document.failed())
            return;
        if (source >= 0)
            texture.image = images.load(document, source, scene);
        anyWhite |= texture.image < 0;
        scene.textures.push_back(texture);
    }
    if (anyWhite && !document.failed())
        document.diagnostics.warn(
            "some textures have no image that Glint reads (it does not read KTX2); they are white");
}

} // namespace glint::scene::gltf
