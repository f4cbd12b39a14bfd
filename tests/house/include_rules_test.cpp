// The house's rules, read from the files themselves.
#include "tests/house/include_rules.h"
#include "tests/support/places.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

namespace onggi::house {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// Every C++ file of the house, by its path from the root.
std::map<std::string, std::string> sources() {
    std::map<std::string, std::string> found;
    const fs::path root = test::in_checkout();
    for (const char* wing : {"engine", "game", "shaders", "tests"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / wing)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".h" && extension != ".cpp") continue;
            if (entry.path().string().find("node_modules") != std::string::npos) continue;
            found[fs::relative(entry.path(), root).string()] = read_text(entry.path());
        }
    }
    return found;
}

IncludeRules house_rules() {
    auto rules = parse_include_rules(read_text(test::in_checkout("tests/house/allowed_includes.txt")));
    EXPECT_TRUE(rules) << (rules ? "" : rules.error().message);
    return rules ? std::move(rules).value() : IncludeRules{};
}

TEST(House, EveryIncludeIsAllowed) {
    const IncludeRules rules = house_rules();
    const auto files = sources();
    ASSERT_GT(files.size(), 20U) << "the house was not found";
    for (const auto& [path, text] : files) {
        for (const std::string& violation : violations(rules, path, text))
            ADD_FAILURE() << violation;
    }
}

TEST(House, EveryHeaderSaysWhatItIsAndIsIncludedOnce) {
    for (const auto& [path, text] : sources()) {
        if (!path.ends_with(".h")) continue;
        EXPECT_TRUE(text.starts_with("//")) << path << ": expected a comment that says what this file is";
        // Where GLSL reads the header too, the guard is of the older kind.
        const bool guarded =
            text.find("#pragma once") != std::string::npos || text.find("#ifndef ") < text.find("#define ");
        EXPECT_TRUE(guarded) << path;
    }
}

TEST(House, NoFileHasMoreThanAThousandLines) {
    for (const auto& [path, text] : sources()) {
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 1000)
            << path << ": is there a second concept inside?";
    }
}

TEST(House, EveryRoomHasAReadme) {
    const fs::path root = test::in_checkout();
    for (const char* wing : {"engine", "game"}) {
        for (const auto& room : fs::directory_iterator(root / wing)) {
            if (!room.is_directory()) continue;
            EXPECT_TRUE(fs::exists(room.path() / "README.md")) << room.path();
        }
    }
    for (const char* folder : {"engine", "game", "shaders", "assets", "tests"}) {
        EXPECT_TRUE(fs::exists(root / folder / "README.md")) << folder;
        for (const auto& file : fs::recursive_directory_iterator(root / folder)) {
            if (file.path().extension() != ".md") continue;
            if (file.path().string().find("node_modules") != std::string::npos) continue;
            EXPECT_TRUE(read_text(file.path()).starts_with("# "))
                << file.path() << ": what formats code was here";
        }
    }
}

// A file that was renamed lives on in what is written of it.
TEST(House, EveryFileThatIsNamedExists) {
    const fs::path root = test::in_checkout();
    std::map<std::string, std::string> texts = sources();
    std::set<std::string> names;
    for (const char* wing : {".", "engine", "game", "shaders", "assets", "tests"}) {
        const bool is_root = wing == std::string_view(".");
        for (fs::recursive_directory_iterator at(root / wing), end; at != end; ++at) {
            const std::string name = at->path().filename().string();
            if (at->is_directory() && (is_root || name == "node_modules")) at.disable_recursion_pending();
            names.insert(name);
            if (name.ends_with(".md")) texts[fs::relative(at->path(), root).string()] = read_text(at->path());
        }
    }
    const std::regex path(
        R"(\b(engine|game|shaders|assets|tests)/[\w./-]*\w\.(h|cpp|glsl|vert|frag|md|sh|py|mjs|txt))");
    const std::regex name(R"(`([\w-]+\.(h|cpp|glsl|vert|frag|sh|py|mjs))`)");
    for (const auto& [file, text] : texts) {
        if (file.starts_with("tests/house/")) continue;  // which names some that there are not
        for (std::sregex_iterator at(text.begin(), text.end(), path), end; at != end; ++at)
            EXPECT_TRUE(fs::exists(root / at->str())) << file << ": expected " << at->str() << ", found none";
        for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at)
            EXPECT_TRUE(names.contains((*at)[1])) << file << ": expected " << (*at)[1] << ", found none";
    }
}

TEST(House, TheClayCitesEveryEquationOfThePaper) {
    std::string clay;
    for (const auto& [path, text] : sources()) {
        if (path.starts_with("game/clay/")) clay += text;
    }
    for (int equation = 1; equation <= 7; ++equation) {
        EXPECT_NE(clay.find(fmt::format("Eq. ({})", equation)), std::string::npos)
            << "Eq. (" << equation << ")";
    }
}

TEST(IncludeRules, CatchWhatTheyForbid) {
    const IncludeRules rules = house_rules();
    const auto count = [&](std::string_view path, std::string_view text) {
        return violations(rules, path, text).size();
    };

    EXPECT_EQ(count("engine/ecs/registry.cpp", "#include \"game/kiosk/state.h\"\n"), 1U);
    EXPECT_EQ(count("game/clay/paper_clay.cpp", "#include \"engine/jobs/spsc_ring.h\"\n"), 1U);
    EXPECT_EQ(count("game/clay/paper_clay.cpp", "  # include <thread>\n#include <mutex>\n"), 2U);
    EXPECT_EQ(count("game/wheel/scene.cpp", "#include <glm/glm.hpp>\n"), 1U);
    EXPECT_EQ(count("engine/render/renderer.cpp", "#include <vulkan/vulkan.h>\n"), 1U);
    EXPECT_EQ(count("game/haptic/tick.cpp", "const double y = std::sin(x);\n"), 1U);
    EXPECT_EQ(count("engine/haptics/tool_state.h", "double sponge_water = 0.0;  // of the kiln\n"), 2U);
    EXPECT_EQ(count("engine/record/layout.h", "enum class ClayModel { kPaper };\n"), 1U);
    EXPECT_EQ(count("attic/old.cpp", "#include \"engine/core/result.h\"\n"), 1U);

    EXPECT_EQ(count("game/clay/paper_clay.cpp", "#include \"engine/core/hash.h\"\n#include <vector>\n"), 0U);
    EXPECT_EQ(count("engine/vk/vulkan.h", "#include <vulkan/vulkan.h>\n"), 0U);
    EXPECT_EQ(count("game/app/main.cpp", "#include \"engine/files/atomic_file.h\"\n"), 0U);
    EXPECT_EQ(count("game/haptic/tools.h", "// A sponge of the clay.\n"), 0U);
}

TEST(IncludeRules, RejectATableLineTheyDoNotUnderstand) {
    EXPECT_FALSE(parse_include_rules("rooom engine/core:\n"));
    EXPECT_FALSE(parse_include_rules("room engine/core\n"));
}

}  // namespace
}  // namespace onggi::house
