#include "lab/view/shader_reload.hpp"

#include "base/file.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>

namespace glint::view {
namespace shader_reload_test {

using testing::HasSubstr;

class ShaderReloadTest : public testing::Test {
protected:
    ShaderReloadTest() : sources_(folder_.path()) {
        for (const std::string folder : {"/shaders", "/lab/shaders"}) {
            std::filesystem::create_directories(sources_ + folder);
            std::filesystem::copy(GLINT_SOURCE_DIR + folder, sources_ + folder,
                                  std::filesystem::copy_options::recursive);
        }
    }
    void append(const std::string& file, const std::string& text) {
        const auto before = readFile(sources_ + "/" + file, 1 << 20);
        ASSERT_TRUE(before);
        ASSERT_TRUE(writeFile(sources_ + "/" + file, *before + text));
    }
    test::TempFolder folder_;
    std::string sources_;
};

TEST_F(ShaderReloadTest, CompilesWhatIncludesTheChange) {
    auto reload = ShaderReload::create(sources_);
    ASSERT_TRUE(reload) << reload.error().message;
    EXPECT_FALSE(reload->look());
    EXPECT_EQ(reload->compile()->count, 0u);

    append("lab/shaders/lib/tonemap.glsl", "\n// seen\n");
    EXPECT_TRUE(reload->look());
    EXPECT_FALSE(reload->look()); // once
    const auto compiled = reload->compile();
    ASSERT_TRUE(compiled) << compiled.error().message;
    EXPECT_TRUE(compiled->shaders.contains("display/tonemap"));
    EXPECT_FALSE(compiled->shaders.contains("trace/hiz"));
    EXPECT_EQ(compiled->shaders.at("display/tonemap")->name, "display/tonemap");
    EXPECT_GT(compiled->shaders.at("display/tonemap")->pushConstantSize, 0u);
    EXPECT_EQ(reload->compile()->count, compiled->count); // nobody took them
    reload->take(*compiled);
    EXPECT_EQ(reload->compile()->count, 0u);
    EXPECT_TRUE(reload->compile()->shaders.contains("display/tonemap")); // still in force
}

TEST_F(ShaderReloadTest, VariantsAreCompiledWithTheirMacros) {
    auto reload = ShaderReload::create(sources_);
    ASSERT_TRUE(reload) << reload.error().message;
    append("shaders/rays/hits_main.glsl", "\n// seen\n");
    EXPECT_TRUE(reload->look());
    const auto compiled = reload->compile();
    ASSERT_TRUE(compiled) << compiled.error().message;
    EXPECT_EQ(compiled->count, 2u);
    EXPECT_FALSE(compiled->shaders.at("rays/hits_bvh")->usesRayQuery());
    EXPECT_TRUE(compiled->shaders.at("rays/hits_query")->usesRayQuery());
}

TEST_F(ShaderReloadTest, AMistakeInTheTableOfVariantsIsSaid) {
    auto reload = ShaderReload::create(sources_);
    ASSERT_TRUE(reload) << reload.error().message;
    append("shaders/variants.txt", "mistake\n");
    EXPECT_TRUE(reload->look());
    EXPECT_FALSE(reload->look());
    const auto compiled = reload->compile();
    ASSERT_FALSE(compiled);
    EXPECT_THAT(compiled.error().message, HasSubstr("variants.txt:"));
    EXPECT_FALSE(ShaderReload::create(sources_));
}

TEST_F(ShaderReloadTest, AMistakeIsSaidInItsFirstLinesUntilItIsMended) {
    auto reload = ShaderReload::create(sources_);
    ASSERT_TRUE(reload) << reload.error().message;
    append("lab/shaders/view/gui.frag", "mistake\n");
    EXPECT_TRUE(reload->look());
    for (int twice = 0; twice < 2; ++twice) {
        const auto compiled = reload->compile();
        ASSERT_FALSE(compiled);
        EXPECT_THAT(compiled.error().message, HasSubstr("view/gui.frag:"));
        EXPECT_THAT(compiled.error().message, testing::Not(HasSubstr(folder_.path())));
    }
}

} // namespace shader_reload_test
} // namespace glint::view
