#include "engine/asset/about.h"

#include <gtest/gtest.h>

#include "engine/asset/gltf.h"
#include "engine/asset/image.h"
#include "engine/asset/webp_film.h"
#include "tests/support/mesh_check.h"
#include "tests/support/webp_frames.h"
#include "tests/unit/asset/sample_mesh.h"

namespace onggi::asset {
namespace {

About museum() {
    return {.title = {{"en", "Moon jar, celadon"}, {"ko", "달항아리, 청자"}},
            .description = {{"en", "Thrown & <fired>"}},
            .rights = {{"en", "CC BY 4.0"}},
            .publisher = {{"en", "House of Clay"}, {"ko", "House of Clay"}, {"ar", "بيت الطين"}},
            .date = "2026-11-28",
            .identifier = "onggi-session:0123",
            .relation = "Moon jar",
            .tool = "Onggi 1"};
}

Image squares() {
    Image image{.width = 2, .height = 2, .rgba = {}};
    for (int i = 0; i < 4; ++i)
        image.rgba.insert(image.rgba.end(), {static_cast<std::uint8_t>(60 * i), 20, 30, 255});
    return image;
}

std::string text_of(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST(About, SaysEachTermOnceAndEscaped) {
    const std::string xmp = xmp_packet(museum());
    EXPECT_NE(xmp.find("<dc:title><rdf:Alt><rdf:li xml:lang=\"x-default\">Moon jar, celadon</rdf:li>"
                       "<rdf:li xml:lang=\"en\">Moon jar, celadon</rdf:li>"
                       "<rdf:li xml:lang=\"ko\">달항아리, 청자</rdf:li></rdf:Alt></dc:title>"),
              std::string::npos)
        << xmp;
    EXPECT_NE(xmp.find(">Thrown &amp; &lt;fired&gt;<"), std::string::npos);
    EXPECT_NE(xmp.find("<dc:publisher><rdf:Bag><rdf:li>House of Clay</rdf:li><rdf:li>بيت الطين</rdf:li>"),
              std::string::npos);
    EXPECT_EQ(museum().copyright(), "House of Clay. CC BY 4.0");
}

TEST(About, LeavesOutWhatIsNotSaid) {
    const std::string xmp = xmp_packet({.title = {{"en", "Pot"}}});
    for (const char* term : {"description", "rights", "publisher", "date", "identifier", "relation", "Tool"})
        EXPECT_EQ(xmp.find(term), std::string::npos) << term;
}

TEST(About, LeavesThePixelsOfPicturesAsTheyAre) {
    const auto png = encode_png(squares());
    ASSERT_TRUE(png);
    const auto told = picture_about(*png, museum());
    ASSERT_TRUE(told) << told.error().message;
    EXPECT_NE(text_of(*told).find(xmp_packet(museum())), std::string::npos);
    const auto read = decode_png(*told, "told");  // checks every checksum
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, squares());

    auto film = WebpFilm::create({.width = 2, .height = 2, .quality = 100.0});
    ASSERT_TRUE(film);
    Image other = squares();
    other.rgba[0] = 200;
    ASSERT_TRUE(film->add(squares(), 80));
    ASSERT_TRUE(film->add(other, 90));
    const auto webp = film->finish();
    ASSERT_TRUE(webp);
    const auto told_film = picture_about(*webp, museum());
    ASSERT_TRUE(told_film) << told_film.error().message;
    EXPECT_NE(text_of(*told_film).find("CC BY 4.0"), std::string::npos);
    const test::WebpFrames frames = test::webp_frames(*told_film);
    ASSERT_EQ(frames.images.size(), 2U);
    EXPECT_EQ(frames.images[0], squares());
    EXPECT_EQ(frames.images[1], other);
    EXPECT_EQ(frames.ends_ms, (std::vector<int>{80, 170}));
    EXPECT_EQ(frames.plays, 1);
}

TEST(About, RejectsOtherFiles) {
    const std::vector<std::byte> wrong(40, std::byte{0x89});
    EXPECT_FALSE(picture_about(wrong, museum()));
    EXPECT_FALSE(picture_about(std::vector<std::byte>(40), museum()));
    EXPECT_FALSE(picture_about({}, museum()));
    auto png = encode_png(squares());
    ASSERT_TRUE(png);
    png->resize(30);
    EXPECT_FALSE(picture_about(*png, museum()));
}

nlohmann::json glb_of(const About& about) {
    const auto bytes = encode_glb({.name = "Moon jar",
                                   .generator = "test",
                                   .mesh = tetrahedron(),
                                   .material = {"clay", dvec3(0.5), 0.75, 0.0},
                                   .extras = {{"glaze", std::string("celadon")}},
                                   .about = about});
    EXPECT_TRUE(bytes) << bytes.error().message;
    const auto file = support::read_glb(*bytes);
    EXPECT_TRUE(file) << file.error().message;
    return file ? file->json : nlohmann::json();
}

TEST(About, IsDublinCoreInGltf) {
    const nlohmann::json json = glb_of(museum());
    EXPECT_EQ(json.at("asset").at("copyright"), "House of Clay. CC BY 4.0");
    EXPECT_EQ(json["extensionsUsed"], nlohmann::json({"KHR_xmp_json_ld"}));
    EXPECT_EQ(json["asset"].at("extensions").at("KHR_xmp_json_ld").at("packet"), 0);
    const nlohmann::json& packet = json.at("extensions").at("KHR_xmp_json_ld").at("packets").at(0);
    EXPECT_EQ(packet.at("dc:title").at("@type"), "rdf:Alt");
    EXPECT_EQ(packet["dc:title"].at("rdf:_2"),
              nlohmann::json({{"@language", "ko"}, {"@value", "달항아리, 청자"}}));
    EXPECT_EQ(packet.at("dc:publisher").at("@set"), nlohmann::json({"House of Clay", "بيت الطين"}));
    EXPECT_EQ(packet.at("dc:date").at("@list"), nlohmann::json({"2026-11-28"}));
    EXPECT_EQ(packet.at("dc:identifier"), "onggi-session:0123");
}

// Khronos's validator says of the extension that it does not know it.
TEST(About, NeedsNoExtensionWithoutRights) {
    About plain = museum();
    plain.rights.clear();
    plain.publisher.clear();
    const nlohmann::json json = glb_of(plain);
    EXPECT_FALSE(json.contains("extensionsUsed")) << json;
    EXPECT_FALSE(json.at("asset").contains("copyright"));
}

TEST(About, StandsOnAssetNodeAndScene) {
    const nlohmann::json json = glb_of({});
    EXPECT_EQ(json.at("asset").at("extras"), json.at("nodes").at(0).at("extras"));
    EXPECT_EQ(json["nodes"][0].at("name"), "Moon jar");
    EXPECT_EQ(json.at("scenes").at(0).at("name"), "Moon jar");
}

}  // namespace
}  // namespace onggi::asset
