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

// The lines in which two arguments of one call draw random numbers. The compiler chooses the order of
// arguments, so that the same seed gives other numbers with another compiler; inside braces the order is that
// of the text.
std::vector<int> unordered_draws(const std::string& text) {
    static const std::regex draw(R"(\(\s*(random|chance|dice)\s*\)|\b(random|chance)\(\)|\bdice\.\w+\()");
    struct Open {
        char bracket;
        std::size_t argument_at;
        int drawing = 0;
    };
    std::vector<Open> open;
    std::vector<int> found;
    const auto end_argument = [&](std::size_t at) {
        const auto begin = text.begin() + static_cast<std::ptrdiff_t>(open.back().argument_at);
        if (std::regex_search(begin, text.begin() + static_cast<std::ptrdiff_t>(at), draw))
            ++open.back().drawing;
        open.back().argument_at = at + 1;
    };
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char letter = text[at];
        if (letter == '(' || letter == '{') open.push_back({letter, at + 1});
        if (open.empty() || (letter != ',' && letter != ')' && letter != '}')) continue;
        if (open.back().bracket == '(' && letter != '}') end_argument(at);
        if (letter == ',') continue;
        if (open.back().drawing > 1)
            found.push_back(1 + static_cast<int>(std::count(
                                    text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')));
        open.pop_back();
    }
    return found;
}

TEST(House, NoCallDrawsTwoRandomNumbersAmongItsArguments) {
    for (const auto& [path, text] : sources()) {
        if (path.ends_with("include_rules_test.cpp")) continue;  // the examples below
        for (const int line : unordered_draws(text))
            ADD_FAILURE() << path << ":" << line << ": expected a statement for each random number";
    }
}

TEST(UnorderedDraws, AreThoseAmongACallsArguments) {
    EXPECT_EQ(unordered_draws("at(1,\n across(random), up(random));"), std::vector<int>{2});
    EXPECT_EQ(unordered_draws("at(dice.between(0, 1), r, dice.next());"), std::vector<int>{1});
    EXPECT_EQ(unordered_draws("go({chance() % 3, 1}, {chance(), 2});"), std::vector<int>{1});
    EXPECT_TRUE(unordered_draws("vec2{across(random), up(random)}; at(up(random), 1);").empty());
    EXPECT_TRUE(unordered_draws("go({across(random), up(random)}, 1); random(); f(a, b);").empty());
}

TEST(House, EveryHeaderHasADocstringAndAGuard) {
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

// The length in lines of each block that ends in a line of `}` alone, by its first line's number. That
// includes every function body: in formatted code it ends at the indentation of its first line. The other
// such blocks are inside functions.
std::map<int, int> block_lengths(const std::string& text) {
    std::map<int, int> found;
    std::map<std::size_t, int> last_at;  // the last line at each indentation
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const std::size_t indentation = line.find_first_not_of(' ');
        if (indentation == std::string::npos || line[indentation] == '#') continue;
        if (std::string_view(line).substr(indentation) == "}")
            found[last_at[indentation]] = number - last_at[indentation] + 1;
        last_at[indentation] = number;
    }
    return found;
}

TEST(House, NoFunctionHasMoreThanEightyLines) {
    for (const auto& [path, text] : sources()) {
        for (const auto& [line, length] : block_lengths(text))
            EXPECT_LE(length, 80) << path << ":" << line << ": which parts has it?";
    }
}

TEST(BlockLengths, AreThoseOfFunctions) {
    const std::string code = R"(
namespace a {
constexpr int kTable[] = {
    1,
};

struct B {
    int c() const {
        if (d) {
            return 1;
        } else {
            return 2;
        }
#if E

#endif
    }

  private:
    int d = 0;
};

B::B(int wide,
     int wrapped)
    : d(wide) {
    for (;;) {
    }
}

int inline_one() { return 1; }
}  // namespace a
)";
    EXPECT_EQ(block_lengths(code), (std::map<int, int>{{8, 10}, {11, 3}, {23, 6}, {26, 2}}));
}

TEST(House, EveryRoomHasAReadme) {
    const fs::path root = test::in_checkout();
    for (const char* wing : {"engine", "game"}) {
        for (const auto& room : fs::directory_iterator(root / wing)) {
            if (!room.is_directory()) continue;
            EXPECT_TRUE(fs::exists(room.path() / "README.md")) << room.path();
        }
    }
    for (const char* folder : {"engine", "game", "shaders", "assets", "tests", "docs"}) {
        EXPECT_TRUE(fs::exists(root / folder / "README.md")) << folder;
        for (const auto& file : fs::recursive_directory_iterator(root / folder)) {
            if (file.path().extension() != ".md") continue;
            if (file.path().string().find("node_modules") != std::string::npos) continue;
            EXPECT_TRUE(read_text(file.path()).starts_with("# "))
                << file.path() << ": what formats code was here";
        }
    }
}

// Every file in the repository, by its path from the root.
std::set<std::string> kept_files() {
    std::set<std::string> found;
    const fs::path root = test::in_checkout();
    for (const char* wing : {".", ".ci", ".cmake", "engine", "game", "shaders", "assets", "tests", "docs",
                             "findings", "LICENSES"}) {
        const bool is_root = wing == std::string_view(".");
        for (fs::recursive_directory_iterator at(root / wing), end; at != end; ++at) {
            if (!at->is_directory()) {
                found.insert(fs::relative(at->path(), root).string());
            } else if (is_root || at->path().filename() == "node_modules") {
                at.disable_recursion_pending();
            }
        }
    }
    return found;
}

// The prose of a line: the whole line in a document, the comment in code.
std::string_view prose_of(std::string_view file, std::string_view line) {
    if (file.ends_with(".md")) return line;
    const fs::path extension = fs::path(file).extension();
    const bool slashes = extension == ".h" || extension == ".cpp" || extension == ".glsl" ||
                         extension == ".vert" || extension == ".frag" || extension == ".mjs";
    const std::size_t comment = line.find(slashes ? "//" : "#");
    return comment == std::string_view::npos ? std::string_view() : line.substr(comment);
}

// The paths in a text that have a folder, without leading dots: `room/file.h`, `../room/file.h`. A path after
// `<` is a system header; after other signs it is a part of an address, a pattern or a variable.
std::vector<std::string> named_paths(std::string_view text) {
    static const std::regex path(
        R"([\w.-]+(/[\w.-]+)*/[\w.-]*\w\.(h|cpp|glsl|vert|frag|md|sh|py|mjs|txt|cmake|toml|csv|tsv)\b(?!/))");
    std::vector<std::string> found;
    const std::string line(text);
    for (std::sregex_iterator at(line.begin(), line.end(), path), end; at != end; ++at) {
        const std::string before = at->prefix();
        if (!before.empty() && std::string_view("</@$}*:~%").find(before.back()) != std::string_view::npos)
            continue;
        std::string name = at->str();
        while (name.starts_with("./") || name.starts_with("../"))
            name.erase(0, name.find('/') + 1);
        if (name.find('/') != std::string::npos) found.push_back(std::move(name));
    }
    return found;
}

// All suffixes of a path that begin at one of its folders: `a/b/c.h` is also `b/c.h`.
std::set<std::string> suffixes(const std::set<std::string>& files) {
    std::set<std::string> found;
    for (const std::string& file : files) {
        found.insert(file);
        for (std::size_t at = file.find('/'); at != std::string::npos; at = file.find('/', at + 1))
            found.insert(file.substr(at + 1));
    }
    return found;
}

// Comments and documents that name a file must be updated when it is moved or renamed.
TEST(House, EveryFileThatIsNamedExists) {
    // Files that a command, an installation or a kiosk writes, and a placeholder name.
    const std::set<std::string_view> no_files = {"assets/languages/CODE.tsv", "out/throwing.csv",
                                                 "share/onggi/kiosk-settings.toml", "statistics/staff.toml",
                                                 "statistics/visits.csv"};
    const std::set<std::string> files = kept_files();
    const std::set<std::string> known = suffixes(files);
    const std::regex path(
        R"(\b(engine|game|shaders|assets|tests|docs)/[\w./-]*\w\.(h|cpp|glsl|vert|frag|md|sh|py|mjs|txt))");
    const std::regex name(R"(`([\w-]+\.(h|cpp|glsl|vert|frag|sh|py|mjs))`)");
    const std::regex written(
        R"((.*\.(h|cpp|glsl|vert|frag|md|sh|py|mjs|txt|cmake|toml|in|awk|rules))|check|run)");
    for (const std::string& file : files) {
        // The house's tests name files that do not exist; samples and seeds are kept as they were.
        if (file.starts_with("tests/house/") || file.starts_with("tests/formats/samples/") ||
            file.starts_with("tests/fuzz/corpus/") || !std::regex_match(file, written))
            continue;
        const std::string text = read_text(test::in_checkout(file));
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            for (const std::string& named : named_paths(prose_of(file, line)))
                EXPECT_TRUE(known.contains(named) || no_files.contains(named))
                    << file << ": expected " << named << ", found none";
        }
        if (!file.ends_with(".md") && !file.ends_with(".h") && !file.ends_with(".cpp")) continue;
        for (std::sregex_iterator at(text.begin(), text.end(), path), end; at != end; ++at)
            EXPECT_TRUE(files.contains(fs::path(at->str()).lexically_normal()))
                << file << ": expected " << at->str() << ", found none";
        for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at)
            EXPECT_TRUE(known.contains((*at)[1])) << file << ": expected " << (*at)[1] << ", found none";
    }
}

// The words of a text, as C++ has them.
std::set<std::string> words_of(std::string_view text) {
    const auto is_of_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    std::set<std::string> found;
    for (auto at = text.begin(); at != text.end();) {
        const auto begin = std::find_if(at, text.end(), is_of_word);
        at = std::find_if_not(begin, text.end(), is_of_word);
        if (begin != at) found.emplace(begin, at);
    }
    return found;
}

// The names in a document's back quotes that are a word of code: `SafetyLimits`, `HandSigns::force_fraction`,
// `rearm()`.
std::vector<std::string> quoted_names(const std::string& text) {
    static const std::regex name(R"(`((\w+::)*[A-Za-z]\w*)(\(\))?`)");
    std::vector<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at)
        found.push_back((*at)[1]);
    return found;
}

// A document that quotes a name has to follow when it is renamed.
TEST(House, EveryNameThatADocumentQuotesStandsInAFile) {
    std::set<std::string> known;
    const auto files = kept_files();
    const std::regex written(
        R"((.*\.(h|cpp|glsl|vert|frag|comp|py|sh|cmake|txt|toml|csv|tsv|in))|check|run)");
    for (const std::string& file : files)
        if (std::regex_match(file, written)) known.merge(words_of(read_text(test::in_checkout(file))));
    for (const std::string& file : files) {
        const bool is_of_a_room =
            file.starts_with("engine/") || file.starts_with("game/") || file.starts_with("shaders/");
        if (!is_of_a_room || !file.ends_with(".md")) continue;
        for (const std::string& named : quoted_names(read_text(test::in_checkout(file))))
            for (const std::string& word : words_of(named))
                EXPECT_TRUE(known.contains(word)) << file << ": expected " << named << ", found none";
    }
}

TEST(QuotedNames, AreThoseOfCode) {
    EXPECT_EQ(quoted_names("`SafetyLimits` of `a::b::c_d`, `rearm()`, not `a/b.h`, `x + y` or plain"),
              (std::vector<std::string>{"SafetyLimits", "a::b::c_d", "rearm"}));
    EXPECT_EQ(words_of("a::b_1(c)"), (std::set<std::string>{"a", "b_1", "c"}));
}

TEST(House, EveryLinkOfADocumentLeadsToAFile) {
    const std::regex link(R"(\]\(([^()\s#]+)(#[^()\s]*)?\))");
    for (const std::string& file : kept_files()) {
        if (!file.ends_with(".md")) continue;
        const std::string text = read_text(test::in_checkout(file));
        for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
            const std::string target = (*at)[1];
            EXPECT_TRUE(target.starts_with("http") ||
                        fs::exists(fs::path(test::in_checkout(file)).parent_path() / target))
                << file << ": expected " << target << ", found none";
        }
    }
}

TEST(NamedPaths, AreFoundInCommentsAndDocumentsInEveryForm) {
    const std::vector<std::string> two = {"share/pot_solid.h", "look/README.md"};
    EXPECT_EQ(named_paths("// (share/pot_solid.h says how), ../look/README.md."), two);
    EXPECT_EQ(named_paths("`./.ci/setup.sh`"), std::vector<std::string>{".ci/setup.sh"});
    for (const char* other : {"README.md", "<vulkan/vulkan.h>", "https://a.org/b.md", "$folder/a.txt",
                              "*/a.cpp", "a/b.html", "a/b.h/c", "../README.md"})
        EXPECT_TRUE(named_paths(other).empty()) << other;
    EXPECT_EQ(prose_of("a/b.cpp", "int a;  // b/c.h"), "// b/c.h");
    EXPECT_EQ(prose_of("a/CMakeLists.txt", "add(a) # b/c.h"), "# b/c.h");
    EXPECT_EQ(prose_of("a/b.cpp", "#include \"b/c.h\""), "");
    EXPECT_EQ(suffixes({"a/b/c.h"}), (std::set<std::string>{"a/b/c.h", "b/c.h", "c.h"}));
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

TEST(IncludeRules, CatchForbiddenIncludes) {
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
    EXPECT_EQ(count("engine/haptics/hand_sample.h", "double sponge_water = 0.0;  // of the kiln\n"), 3U);
    EXPECT_EQ(count("engine/haptics/hand_sample.h", "double assist_gap_mm = 0.0;  // at the rim\n"), 2U);
    EXPECT_EQ(count("engine/jobs/mailbox.h", "#include \"game/tool/tool.h\"\n"), 1U);
    EXPECT_EQ(count("engine/render/scene.h", "// The colour of stoneware.\n"), 1U);
    EXPECT_EQ(count("engine/haptics/hand_sample.h", "enum class ClayModel { kPaper };\n"), 1U);
    EXPECT_EQ(count("attic/old.cpp", "#include \"engine/core/result.h\"\n"), 1U);

    EXPECT_EQ(count("game/clay/paper_clay.cpp", "#include \"engine/core/hash.h\"\n#include <vector>\n"), 0U);
    EXPECT_EQ(count("engine/vk/vulkan.h", "#include <vulkan/vulkan.h>\n"), 0U);
    EXPECT_EQ(count("game/app/main.cpp", "#include \"engine/files/atomic_file.h\"\n"), 0U);
    EXPECT_EQ(count("game/tool/tool.h", "// A sponge of the clay.\n"), 0U);
}

TEST(IncludeRules, RejectATableLineTheyDoNotUnderstand) {
    EXPECT_FALSE(parse_include_rules("rooom engine/core:\n"));
    EXPECT_FALSE(parse_include_rules("room engine/core\n"));
}

}  // namespace
}  // namespace onggi::house
