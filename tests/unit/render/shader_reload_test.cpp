// In development builds only.
#include "engine/render/shader_reload.h"

#include <gtest/gtest.h>

#include "shaders/shaders.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi::render {
namespace {

class EditedShaders : public testing::Test {
  protected:
    void SetUp() override {
        for (const auto& entry : std::filesystem::directory_iterator(test::in_checkout("shaders")))
            std::filesystem::copy(entry.path(), folder_.path() / entry.path().filename());
        age(std::chrono::hours(1));
        reload_ = std::make_unique<ShaderReload>(folder_.path());
    }
    // So that an edit is newer, even with a coarse file system clock.
    void age(std::chrono::hours by) {
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
            std::filesystem::last_write_time(entry, entry.last_write_time() - by);
    }
    void edit(const std::string& file, const std::string& from, const std::string& to) {
        std::string text = test::content_of(folder_ / file);
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << file << " has no " << from;
        text.replace(at, from.size(), to);
        test::put_file(folder_ / file, text);
    }

    test::TemporaryFolder folder_;
    std::unique_ptr<ShaderReload> reload_;
};

TEST_F(EditedShaders, AreNotCompiledWithoutAnEdit) {
    const auto polled = reload_->poll();
    ASSERT_TRUE(polled);
    EXPECT_FALSE(*polled);
    EXPECT_TRUE(reload_->replacements().empty());
}

TEST_F(EditedShaders, AreCompiledAgainWhenChanged) {
    edit("prop.frag", "vec4(encode(light), 1.0)", "vec4(encode(light * 2.0), 1.0)");
    const auto polled = reload_->poll();
    ASSERT_TRUE(polled) << polled.error().message;
    EXPECT_TRUE(*polled);
    ASSERT_EQ(reload_->replacements().size(), 1U);
    const auto& [original, words] = *reload_->replacements().begin();
    EXPECT_EQ(original, shaders::kPropFrag.data());
    constexpr std::uint32_t kSpirvMagic = 0x07230203;
    EXPECT_EQ(words.at(0), kSpirvMagic);
}

TEST_F(EditedShaders, FollowTheirIncludes) {
    edit("curve.h", "kCurveFoot = 0.35F", "kCurveFoot = 0.36F");
    const auto polled = reload_->poll();
    ASSERT_TRUE(polled) << polled.error().message;
    EXPECT_TRUE(*polled);
    EXPECT_GT(reload_->replacements().size(), 3U) << "all that encode colours";
}

TEST_F(EditedShaders, RejectAFaultyShaderWithItsLine) {
    edit("prop.frag", "void main() {", "void main() { this is no GLSL;");
    const auto polled = reload_->poll();
    ASSERT_FALSE(polled);
    EXPECT_NE(polled.error().message.find("prop.frag"), std::string::npos) << polled.error().message;
    EXPECT_EQ(polled.error().message.find('\n'), std::string::npos);
    EXPECT_TRUE(reload_->replacements().empty());
}

}  // namespace
}  // namespace onggi::render
