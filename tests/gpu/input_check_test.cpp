// The check of a host's declarations: each wrong one is named from the host's own images on the GPU, and right ones are
// left alone.
#include "gpu/support/library_test.hpp"
#include "gpu/support/samples.hpp"

#include <gmock/gmock.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace glint::test {
namespace input_check_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr uint32_t kWidth = 128;
constexpr uint32_t kHeight = 72;

/// A sphere on a floor before two walls that meet at an angle: normals of many directions.
std::optional<SyntheticSurface> room(const glm::dvec3& origin, const glm::dvec3& direction) {
    SyntheticSurface hit;
    hit.distance = 1e8;
    hit.f0 = glm::vec3(0.5f);
    const auto plane = [&](const glm::dvec3& point, const glm::dvec3& normal) {
        const double t = glm::dot(point - origin, normal) / glm::dot(direction, normal);
        if (glm::dot(direction, normal) < 0 && t > 1e-6 && t < hit.distance) {
            hit.distance = t;
            hit.normalWS = normal;
        }
    };
    plane({0, 0, 0}, {0, 1, 0});
    plane({0, 0, -3}, glm::normalize(glm::dvec3(0.4, 0, 1)));
    plane({2, 0, 0}, glm::normalize(glm::dvec3(-1, 0.1, 0.3)));
    const glm::dvec3 center(-0.4, 0.6, -0.5), toCenter = center - origin;
    const double along = glm::dot(toCenter, direction);
    const double apart2 = glm::dot(toCenter, toCenter) - along * along;
    if (const double t = along - std::sqrt(std::max(0.36 - apart2, 0.0)); apart2 < 0.36 && t < hit.distance) {
        hit.distance = t;
        hit.normalWS = glm::normalize(origin + direction * t - center);
    }
    return hit.distance < 30 ? std::optional(hit) : std::nullopt;
}

/// How a host stores the frame. A host's truth is one of these, its declaration another.
struct Host {
    Conventions conventions;
    bool reversed = true;
    bool orthographic = false;
    bool inward = false;
    float roughness = 0.3f;
    bool manySamples = false; ///< kSamples a pixel, all on the same surface
    SyntheticCamera camera = {.position = {0.8, 1.4, 3}, .target = {0.1, 0.3, -0.5}};

    double zSign() const { return conventions.handedness == Handedness::Left ? 1 : -1; }

    View view() const {
        // NDC depth = (a * viewZ + b) / w, with w = viewZ or, orthographic, 1.
        const double low = conventions.depthMinusOneToOne ? -1 : 0, near = 0.1, far = 40;
        const double atNear = reversed ? 1 : low, atFar = reversed ? low : 1;
        glm::dmat4 toClip = camera.viewToClip(kWidth, kHeight);
        if (orthographic) {
            const double slope = (atFar - atNear) / (far - near);
            toClip[2].z = zSign() * slope;
            toClip[3].z = atNear - slope * near;
        } else {
            const double b = (atNear - atFar) / (1 / near - 1 / far);
            toClip[2].z = zSign() * (atFar - b / far);
            toClip[2].w = zSign();
            toClip[3].z = b;
        }
        glm::dmat4 toView = camera.worldToView();
        for (int column = 0; column < 4; ++column) {
            toClip[column].y *= conventions.clipYDown ? -1 : 1;
            toView[column].z *= -zSign();
        }
        View view;
        view.worldToView = toMatrix4(toView);
        view.viewToClip = toMatrix4(toClip);
        return view;
    }
};

glm::dmat4 matrix(const Matrix4& m) {
    return glm::dmat4(glm::make_mat4(m.data()));
}

struct Images {
    gpu::Image depth, normal, material, litRadiance, motion;
    GBuffer gbuffer;
};

/// `previous`: with motion from its camera.
Images draw(gpu::Context& context, const Host& host, const Host* previous = nullptr) {
    const Conventions& c = host.conventions;
    const View view = host.view();
    const glm::dmat4 toView = matrix(view.worldToView), toClip = matrix(view.viewToClip);
    std::vector<float> depth;
    std::vector<glm::vec4> normal, material;
    std::vector<glm::vec4> motion;
    const auto uvOf = [](const View& of, const Conventions& conventions, const glm::dvec3& positionWS) {
        const glm::dvec4 clip = matrix(of.viewToClip) * matrix(of.worldToView) * glm::dvec4(positionWS, 1);
        const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
        return glm::dvec2(0.5 + 0.5 * ndc.x, 0.5 + (conventions.clipYDown ? 0.5 : -0.5) * ndc.y);
    };
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
        const glm::dvec3 origin = host.camera.originThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const glm::dvec3 ray = host.camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
        const auto surface = room(origin, ray);
        const glm::dvec3 positionWS = origin + ray * (surface ? surface->distance : 1);
        const glm::dvec4 positionVS = toView * glm::dvec4(positionWS, 1), clip = toClip * positionVS;
        double stored = clip.z / clip.w;
        if (c.depthMinusOneToOne)
            stored = stored * 0.5 + 0.5;
        if (c.depth == DepthKind::LinearViewZ)
            stored = positionVS.z * host.zSign() / double(c.linearDepthScale);
        else if (!surface)
            stored = host.reversed ? 0 : 1;
        depth.push_back(static_cast<float>(surface || c.depth == DepthKind::Device ? stored : 0));
        glm::dvec3 n = surface ? surface->normalWS : glm::dvec3(0, 1, 0);
        if (c.normalSpace == NormalSpace::View)
            n = glm::dmat3(toView) * n;
        n *= host.inward ? -1 : 1;
        const bool octahedral =
            c.normalEncoding == NormalEncoding::Octahedral || c.normalEncoding == NormalEncoding::OctahedralUnorm;
        glm::vec4 encoded = octahedral ? glm::vec4(encodeOctahedral(n), 9, 9) : glm::vec4(glm::vec3(n), 9);
        if (c.normalEncoding == NormalEncoding::Unorm || c.normalEncoding == NormalEncoding::OctahedralUnorm)
            encoded = encoded * 0.5f + 0.5f;
        normal.push_back(encoded);
        material.emplace_back(0.5f, 0.5f, 0.5f, host.roughness);
        const glm::dvec2 moved =
            previous ? uvOf(previous->view(), c, positionWS) - uvOf(view, c, positionWS) : glm::dvec2(0);
        const double nearer = previous ? previous->camera.viewZ(positionWS) - host.camera.viewZ(positionWS) : 0;
        motion.emplace_back(moved / glm::dvec2(c.motionScale[0], c.motionScale[1]),
                            c.motionDepthScale != 0 ? nearer / double(c.motionDepthScale) : 0, 0);
    }
    constexpr VkFormat kWide = VK_FORMAT_R32G32B32A32_SFLOAT;
    Images out;
    const auto upload = [&](const char* name, VkFormat format, const auto& texels) {
        if (!host.manySamples)
            return uploadTestImage(context, name, format, kWidth, kHeight, bytesOf(texels));
        return makeSamples(context, name, format, kWidth, kHeight,
                           [&](uint32_t x, uint32_t y, uint32_t) { return glm::vec4(texels[y * kWidth + x]); });
    };
    out.depth = upload("test/depth", VK_FORMAT_R32_SFLOAT, depth);
    out.normal = upload("test/normal", kWide, normal);
    out.material = upload("test/material", kWide, material);
    out.litRadiance = uploadTestImage(context, "test/lit", kWide, kWidth, kHeight, bytesOf(material));
    out.motion = uploadTestImage(context, "test/motion", kWide, kWidth, kHeight, bytesOf(motion));
    out.gbuffer.depth = asHostImage(out.depth);
    out.gbuffer.normal = asHostImage(out.normal);
    out.gbuffer.material = asHostImage(out.material);
    out.gbuffer.litRadiance = asHostImage(out.litRadiance);
    if (previous)
        out.gbuffer.motion = asHostImage(out.motion);
    out.gbuffer.conventions = c;
    return out;
}

/// What a host declares about a frame.
struct Declaration {
    GBuffer gbuffer;
    View view;
};

class InputCheckTest : public LibraryTest {
protected:
    static Reflections checked(uint32_t framesInFlight = 1) {
        ReflectionsDesc desc = {kWidth, kHeight, plainSettings()};
        desc.inputCheck = true;
        desc.framesInFlight = framesInFlight;
        return must(Reflections::create(library(), desc));
    }
    static void record(Reflections& reflections, const View& view) {
        run([&](VkCommandBuffer commands) { reflections.record(commands, view); });
    }
    static InputCheck check(Reflections& reflections, const Declaration& declared, const KnownPlane* plane = nullptr) {
        must(reflections.setInputs(declared.gbuffer));
        record(reflections, declared.view);
        run([&](VkCommandBuffer commands) { must(reflections.recordInputCheck(commands, plane)); });
        return reflections.inputCheck();
    }
    static InputCheck check(Reflections& reflections, const Host& host) {
        const Images images = draw(gpu(), host);
        return check(reflections, {images.gbuffer, host.view()});
    }
};

std::vector<std::pair<std::string, Host>> rightHosts() {
    std::vector<std::pair<std::string, Host>> hosts;
    for (int bits = 0; bits < 32; ++bits) {
        Host host;
        host.reversed = (bits & 1) != 0;
        host.conventions.depthMinusOneToOne = (bits & 2) != 0;
        host.conventions.clipYDown = (bits & 4) != 0;
        host.conventions.handedness = bits & 8 ? Handedness::Left : Handedness::Right;
        host.conventions.normalSpace = bits & 16 ? NormalSpace::View : NormalSpace::World;
        host.conventions.normalEncoding = static_cast<NormalEncoding>(bits % 4);
        hosts.emplace_back("bits " + std::to_string(bits), host);
    }
    for (const float scale : {1.0f, -1.0f, 0.01f}) {
        Host linear;
        linear.conventions.depth = DepthKind::LinearViewZ;
        linear.conventions.linearDepthScale = scale;
        hosts.emplace_back("linear " + std::to_string(scale), linear);
    }
    Host orthographic;
    orthographic.orthographic = true;
    orthographic.camera.orthoHeight = 3;
    orthographic.camera.far = 40;
    hosts.emplace_back("orthographic", orthographic);
    return hosts;
}

TEST_F(InputCheckTest, RightDeclarationsAreLeftAlone) {
    Reflections reflections = checked();
    for (const auto& [name, host] : rightHosts()) {
        const InputCheck result = check(reflections, host);
        EXPECT_THAT(result.findings, IsEmpty()) << name;
        EXPECT_GT(result.normalsAgree, 0.9) << name;
        EXPECT_GT(result.tested, 1000u) << name;
    }
}

struct Mistake {
    const char* name;
    void (*truth)(Host& host); ///< how the host draws
    void (*lie)(Declaration& declared);
    const char* finding;
};

const Mistake kMistakes[] = {
    {"view normals as world", [](Host& h) { h.conventions.normalSpace = NormalSpace::View; },
     [](Declaration& d) { d.gbuffer.conventions.normalSpace = NormalSpace::World; },
     "NormalSpace::View, not World as declared"},
    {"world normals as view", [](Host&) {},
     [](Declaration& d) { d.gbuffer.conventions.normalSpace = NormalSpace::View; },
     "NormalSpace::World, not View as declared"},
    {"unorm as signed", [](Host& h) { h.conventions.normalEncoding = NormalEncoding::Unorm; },
     [](Declaration& d) { d.gbuffer.conventions.normalEncoding = NormalEncoding::Signed; },
     "NormalEncoding::Unorm, not Signed as declared"},
    {"octahedral as unorm octahedral", [](Host&) {},
     [](Declaration& d) { d.gbuffer.conventions.normalEncoding = NormalEncoding::OctahedralUnorm; },
     "NormalEncoding::Octahedral, not OctahedralUnorm as declared"},
    {"signed as octahedral", [](Host& h) { h.conventions.normalEncoding = NormalEncoding::Signed; },
     [](Declaration& d) { d.gbuffer.conventions.normalEncoding = NormalEncoding::Octahedral; },
     "NormalEncoding::Signed, not Octahedral as declared"},
    {"inward normals", [](Host& h) { h.inward = true; }, [](Declaration&) {}, "normals that point into the surfaces"},
    {"device depth as linear", [](Host&) {},
     [](Declaration& d) { d.gbuffer.conventions.depth = DepthKind::LinearViewZ; },
     "DepthKind::Device, not LinearViewZ as declared"},
    {"linear depth as device", [](Host& h) { h.conventions.depth = DepthKind::LinearViewZ; },
     [](Declaration& d) { d.gbuffer.conventions.depth = DepthKind::Device; },
     "DepthKind::LinearViewZ and a positive linearDepthScale, not Device as declared"},
    {"negative z as positive",
     [](Host& h) {
         h.conventions.depth = DepthKind::LinearViewZ;
         h.conventions.linearDepthScale = -1;
     },
     [](Declaration& d) { d.gbuffer.conventions.linearDepthScale = 1; }, "a negative linearDepthScale, not a positive"},
    {"depth in [0, 1] as [-1, 1]", [](Host& h) { h.reversed = false; },
     [](Declaration& d) { d.gbuffer.conventions.depthMinusOneToOne = true; },
     "depthMinusOneToOne false, not true as declared"},
    {"OpenGL's depth as [0, 1]",
     [](Host& h) {
         h.reversed = false;
         h.conventions.depthMinusOneToOne = true;
     },
     [](Declaration& d) { d.gbuffer.conventions.depthMinusOneToOne = false; },
     "depthMinusOneToOne true, not false as declared"},
    {"reversed depth with another matrix", [](Host&) {},
     [](Declaration& d) {
         Host other;
         other.reversed = false;
         d.view = other.view();
     },
     "depth that is reversed although View::viewToClip is not"},
    {"a matrix of reversed depth", [](Host& h) { h.reversed = false; }, [](Declaration& d) { d.view = Host().view(); },
     "depth that is not reversed although View::viewToClip is"},
    {"Y direction", [](Host& h) { h.conventions.clipYDown = true; },
     [](Declaration& d) { d.gbuffer.conventions.clipYDown = false; }, "clipYDown true, not false as declared"},
    {"left-handed as right-handed", [](Host& h) { h.conventions.handedness = Handedness::Left; },
     [](Declaration& d) { d.gbuffer.conventions.handedness = Handedness::Right; },
     "Handedness::Left, not Right as declared"},
    {"right-handed as left-handed", [](Host&) {},
     [](Declaration& d) { d.gbuffer.conventions.handedness = Handedness::Left; },
     "Handedness::Right, not Left as declared"},
    {"view to world", [](Host&) {},
     [](Declaration& d) { d.view.worldToView = toMatrix4(glm::inverse(matrix(d.view.worldToView))); },
     "the inverse of View::worldToView"},
    {"row-major projection", [](Host&) {},
     [](Declaration& d) { d.view.viewToClip = toMatrix4(glm::transpose(matrix(d.view.viewToClip))); },
     "the transpose of View::viewToClip"},
    {"another camera", [](Host&) {},
     [](Declaration& d) {
         const glm::dmat4 turn = glm::rotate(glm::dmat4(1), 0.6, glm::normalize(glm::dvec3(0.3, 1, 0.2)));
         d.view.worldToView = toMatrix4(matrix(d.view.worldToView) * turn);
     },
     "a camera that is turned by 34 degrees"},
    {"roughness of 0 to 255", [](Host& h) { h.roughness = 80; }, [](Declaration&) {},
     "the roughness of 100 % of pixels is not from 0 to 1"},
    {"depth in centimetres",
     [](Host& h) {
         h.conventions.depth = DepthKind::LinearViewZ;
         h.conventions.linearDepthScale = 0.01f;
     },
     [](Declaration& d) { d.gbuffer.conventions.linearDepthScale = 1; },
     "outside the near and far planes of the camera (0.1 and 40 m): correct Conventions::linearDepthScale"},
};

TEST_F(InputCheckTest, EveryWrongDeclarationIsNamed) {
    Reflections reflections = checked();
    for (const Mistake& mistake : kMistakes) {
        Host host;
        mistake.truth(host);
        const Images images = draw(gpu(), host);
        Declaration declared = {images.gbuffer, host.view()};
        mistake.lie(declared);
        const InputCheck result = check(reflections, declared);
        ASSERT_FALSE(result.findings.empty()) << mistake.name;
        EXPECT_THAT(result.findings.front(), HasSubstr(mistake.finding)) << mistake.name;
        // One mistake is one difference: nothing that is declared right is blamed.
        EXPECT_THAT(result.findings.front(), Not(HasSubstr(" and Normal"))) << mistake.name;
        EXPECT_THAT(result.findings.front(), Not(HasSubstr("as declared and"))) << mistake.name;
    }
}

/// An engine of another kind that leaves Glint's defaults: four declarations are missing.
TEST_F(InputCheckTest, SeveralWrongDeclarationsAreNamedTogether) {
    Host host;
    host.conventions.clipYDown = true;
    host.conventions.handedness = Handedness::Left;
    host.conventions.normalSpace = NormalSpace::View;
    host.conventions.normalEncoding = NormalEncoding::Unorm;
    const Images images = draw(gpu(), host);
    Declaration declared = {images.gbuffer, host.view()};
    declared.gbuffer.conventions = {};
    Reflections reflections = checked();
    const InputCheck result = check(reflections, declared);
    ASSERT_FALSE(result.findings.empty());
    for (const char* part : {"clipYDown true", "Handedness::Left", "NormalSpace::View", "NormalEncoding::Unorm"})
        EXPECT_THAT(result.findings.front(), HasSubstr(part));
}

/// Frames of a camera that moves; motion is compared with the matrices of both.
TEST_F(InputCheckTest, WrongMotionIsNamed) {
    Host before, now;
    now.camera.position += glm::dvec3(0.25, 0.1, 0);
    struct Case {
        glm::vec2 truth, declared;
        const char* finding; ///< null: none
    };
    const glm::vec2 pixels = 1.0f / glm::vec2(kWidth, kHeight);
    const Case cases[] = {{{1, 1}, {1, 1}, nullptr},
                          {{-1, -1}, {-1, -1}, nullptr},
                          {pixels, pixels, nullptr},
                          {{-1, -1}, {1, 1}, "motionScale {-1, -1}, not motionScale {1, 1} as declared"},
                          {{0.5f, -0.5f}, {1, 1}, "motionScale {0.5, -0.5}"},
                          {pixels, {1, 1}, "motionScale {1 / 128, 1 / 72}"}};
    Reflections reflections = checked();
    for (const Case& one : cases) {
        now.conventions.motionScale[0] = one.truth.x;
        now.conventions.motionScale[1] = one.truth.y;
        const Images images = draw(gpu(), now, &before);
        GBuffer gbuffer = images.gbuffer;
        gbuffer.conventions.motionScale[0] = one.declared.x;
        gbuffer.conventions.motionScale[1] = one.declared.y;
        must(reflections.setInputs(gbuffer));
        record(reflections, before.view());
        View jittered = now.view(); // the projection's jitter is not motion
        jittered.viewToClip[8] += 0.9f / kWidth;
        const InputCheck result = check(reflections, {gbuffer, jittered});
        EXPECT_TRUE(result.motionCompared);
        if (one.finding)
            EXPECT_THAT(result.findings, ElementsAre(HasSubstr(one.finding)));
        else
            EXPECT_THAT(result.findings, IsEmpty());
        // A camera that stands still says nothing about motion.
        EXPECT_FALSE(check(reflections, {gbuffer, jittered}).motionCompared);
    }
}

TEST_F(InputCheckTest, WrongMotionInDepthIsNamed) {
    Host before, now;
    now.camera.position += glm::normalize(now.camera.target - now.camera.position) * 0.3;
    struct Case {
        float truth, declared;
        const char* finding; ///< null: none
    };
    const Case cases[] = {{1, 1, nullptr},
                          {-1, -1, nullptr},
                          {0.01f, 0.01f, nullptr},
                          {0, 0, nullptr},
                          {-1, 1, "motionDepthScale -1, not 1 as declared"},
                          {0.01f, 1, "motionDepthScale 0.01, not 1 as declared"},
                          {0, 1, "state motionDepthScale 0"}};
    Reflections reflections = checked();
    for (const Case& one : cases) {
        now.conventions.motionDepthScale = one.truth;
        const Images images = draw(gpu(), now, &before);
        GBuffer gbuffer = images.gbuffer;
        gbuffer.conventions.motionDepthScale = one.declared;
        must(reflections.setInputs(gbuffer));
        record(reflections, before.view());
        const InputCheck result = check(reflections, {gbuffer, now.view()});
        EXPECT_TRUE(result.motionCompared);
        if (one.finding)
            EXPECT_THAT(result.findings, ElementsAre(HasSubstr(one.finding)));
        else
            EXPECT_THAT(result.findings, IsEmpty());
    }
}

/// A camera that trucks shows motion on screen alone, so the check goes on until one moves in depth, too.
TEST_F(InputCheckTest, MotionIsComparedOnScreenAndInDepth) {
    Host before, now;
    const glm::dvec3 forward = before.camera.target - before.camera.position;
    const glm::dvec3 right = 0.25 * glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    now.camera.position += right;
    now.camera.target += right;
    Reflections reflections = checked();
    for (const float depthScale : {0.0f, 1.0f}) {
        now.conventions.motionDepthScale = depthScale;
        const Images images = draw(gpu(), now, &before);
        must(reflections.setInputs(images.gbuffer));
        record(reflections, before.view());
        const InputCheck result = check(reflections, {images.gbuffer, now.view()});
        EXPECT_THAT(result.findings, IsEmpty());
        EXPECT_EQ(result.motionCompared, depthScale == 0);
    }
}

TEST_F(InputCheckTest, AKnownPlaneShowsWrongDistances) {
    Reflections reflections = checked();
    Host host;
    host.conventions.depth = DepthKind::LinearViewZ;
    const KnownPlane floor;
    const Images images = draw(gpu(), host);
    Declaration declared = {images.gbuffer, host.view()};
    EXPECT_THAT(check(reflections, declared, &floor).findings, IsEmpty());
    declared.gbuffer.conventions.linearDepthScale = 0.5f; // directions are the same
    EXPECT_THAT(check(reflections, declared).findings, IsEmpty());
    EXPECT_THAT(check(reflections, declared, &floor).findings,
                ElementsAre(HasSubstr("linearDepthScale 1, not 0.5 as declared")));
    declared.gbuffer.conventions.linearDepthScale = 1;
    declared.view.worldToView[13] -= 1; // a metre down
    EXPECT_THAT(check(reflections, declared, &floor).findings, ElementsAre(HasSubstr("known plane")));
    const KnownPlane nowhere = {{0, 7, 0}, {0, 1, 0}};
    EXPECT_THAT(check(reflections, {images.gbuffer, host.view()}, &nowhere).findings,
                ElementsAre(HasSubstr("known plane")));
    const KnownPlane flat = {{0, 0, 0}, {0, 2, 0}};
    run([&](VkCommandBuffer commands) {
        EXPECT_THAT(reflections.recordInputCheck(commands, &flat).error().message, HasSubstr("unit length"));
    });
}

TEST_F(InputCheckTest, ImagesWithSeveralSamplesAPixelAreChecked) {
    Reflections reflections = checked();
    Host host;
    host.manySamples = true;
    const Images images = draw(gpu(), host);
    Declaration declared = {images.gbuffer, host.view()};
    const InputCheck right = check(reflections, declared);
    EXPECT_THAT(right.findings, IsEmpty());
    EXPECT_GT(right.normalsAgree, 0.9);
    declared.gbuffer.conventions.clipYDown = true;
    EXPECT_THAT(check(reflections, declared).findings, ElementsAre(HasSubstr("clipYDown false, not true")));
}

/// Without being asked: the first frames, until one shows surfaces. Notes say what was found, once, and go when the
/// declaration is corrected.
TEST_F(InputCheckTest, FirstFramesAreCheckedAndFindingsAreNotes) {
    Reflections reflections = checked(3);
    Host host;
    host.conventions.normalSpace = NormalSpace::View;
    Host sky = host;
    sky.camera.position = {0, 100, 3}; // above the room, turned away from its walls
    sky.camera.target = {-10, 100, 30};
    const Images nothing = draw(gpu(), sky), images = draw(gpu(), host);
    GBuffer wrong = nothing.gbuffer;
    wrong.conventions.normalSpace = NormalSpace::World;
    must(reflections.setInputs(wrong));
    record(reflections, sky.view());
    EXPECT_LT(reflections.inputCheck().tested, 50u);
    EXPECT_THAT(reflections.notes(), Not(Contains(HasSubstr("NormalSpace"))));
    wrong = images.gbuffer;
    wrong.conventions.normalSpace = NormalSpace::World;
    must(reflections.setInputs(wrong));
    for (int frame = 0; frame < 4; ++frame)
        record(reflections, host.view());
    EXPECT_THAT(reflections.notes(), Contains(HasSubstr("NormalSpace::View, not World as declared")).Times(1));
    EXPECT_GT(reflections.inputCheck().tested, 1000u);
    must(reflections.setInputs(wrong)); // another image, the same declaration
    EXPECT_THAT(reflections.notes(), Contains(HasSubstr("NormalSpace::View, not World as declared")).Times(1));
    must(reflections.setInputs(images.gbuffer));
    EXPECT_THAT(reflections.notes(), Not(Contains(HasSubstr("NormalSpace"))));
    for (int frame = 0; frame < 4; ++frame)
        record(reflections, host.view());
    EXPECT_THAT(reflections.inputCheck().findings, IsEmpty());
    EXPECT_GT(reflections.inputCheck().tested, 1000u);
}

TEST_F(InputCheckTest, TheCheckChangesNoPicture) {
    const Host host;
    const Images images = draw(gpu(), host);
    const auto composite = [&](bool check) {
        ReflectionsDesc desc = {kWidth, kHeight, plainSettings()};
        desc.inputCheck = check;
        Reflections reflections = must(Reflections::create(library(), desc));
        must(reflections.setInputs(images.gbuffer));
        HostImage image;
        run([&](VkCommandBuffer commands) { image = reflections.record(commands, host.view()); });
        return download(gpu(), image);
    };
    EXPECT_EQ(composite(false), composite(true));
}

TEST_F(InputCheckTest, WithoutItTheCallIsAnError) {
    Reflections reflections = must(Reflections::create(library(), {kWidth, kHeight, plainSettings()}));
    run([&](VkCommandBuffer commands) {
        EXPECT_THAT(reflections.recordInputCheck(commands).error().message, HasSubstr("ReflectionsDesc::inputCheck"));
    });
    EXPECT_EQ(reflections.inputCheck().tested, 0u);
    Reflections other = checked();
    run([&](VkCommandBuffer commands) {
        EXPECT_THAT(other.recordInputCheck(commands).error().message, HasSubstr("record a frame"));
    });
}

} // namespace input_check_test
} // namespace glint::test
