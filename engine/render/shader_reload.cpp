// The only user of libglslang.
#include "engine/render/shader_reload.h"

#include <fmt/format.h>
#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/resource_limits_c.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "engine/core/list_folder.h"
#include "shaders/shaders.h"

namespace onggi::render {
namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// Returns the source with each #include "..." replaced by its file, once per file as with include guards;
// #line directives keep error positions. Empty if a file is missing, which happens briefly while an editor
// saves it.
std::string expanded(const std::filesystem::path& folder, const std::string& name,
                     std::vector<std::string>& seen) {
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) return {};
    seen.push_back(name);
    std::istringstream source(text_of(folder / name));
    std::string result;
    std::string line;
    for (int number = 1; std::getline(source, line); ++number) {
        const std::size_t quote = line.rfind("#include \"", 0) == 0 ? 10 : std::string::npos;
        if (quote == std::string::npos) {
            result += line + "\n";
            continue;
        }
        result += fmt::format("#line 1\n{}#line {}\n",
                              expanded(folder, line.substr(quote, line.find('"', quote) - quote), seen),
                              number + 1);
    }
    return result;
}

std::string expanded(const std::filesystem::path& folder, const shaders::Source& source) {
    std::vector<std::string> seen;
    std::string text = expanded(folder, source.file, seen);
    std::string definitions;
    std::istringstream words(source.definitions);
    for (std::string word; words >> word;)
        definitions += "#define " + word + "\n";
    // Only comments may precede #version.
    const std::size_t end_of_version = text.find('\n', text.find("#version"));
    if (end_of_version == std::string::npos) return text;
    return text.insert(end_of_version + 1, definitions + "#line 2\n");
}

// Returns the first error of glslang's log, in one line.
std::string first_error(const char* log) {
    std::istringstream lines(log == nullptr ? "" : log);
    std::string line;
    while (std::getline(lines, line)) {
        if (line.find("ERROR") != std::string::npos) return line;
    }
    return "no reason given";
}

Result<std::vector<std::uint32_t>> compile(const std::string& file, const std::string& text) {
    const bool is_vertex = file.ends_with(".vert");
    glslang_input_t input{};
    input.language = GLSLANG_SOURCE_GLSL;
    input.stage = is_vertex ? GLSLANG_STAGE_VERTEX : GLSLANG_STAGE_FRAGMENT;
    input.client = GLSLANG_CLIENT_VULKAN;
    input.client_version = GLSLANG_TARGET_VULKAN_1_3;
    input.target_language = GLSLANG_TARGET_SPV;
    input.target_language_version = GLSLANG_TARGET_SPV_1_6;
    input.code = text.c_str();
    constexpr int kVersion = 460;
    input.default_version = kVersion;
    input.default_profile = GLSLANG_NO_PROFILE;
    input.messages =
        static_cast<glslang_messages_t>(GLSLANG_MSG_SPV_RULES_BIT | GLSLANG_MSG_VULKAN_RULES_BIT);
    input.resource = glslang_default_resource();

    glslang_shader_t* shader = glslang_shader_create(&input);
    glslang_program_t* program = glslang_program_create();
    std::vector<std::uint32_t> words;
    std::string problem;
    if (glslang_shader_preprocess(shader, &input) == 0 || glslang_shader_parse(shader, &input) == 0) {
        problem = first_error(glslang_shader_get_info_log(shader));
    } else {
        glslang_program_add_shader(program, shader);
        if (glslang_program_link(program, input.messages) == 0) {
            problem = first_error(glslang_program_get_info_log(program));
        } else {
            glslang_program_SPIRV_generate(program, input.stage);
            words.resize(glslang_program_SPIRV_get_size(program));
            glslang_program_SPIRV_get(program, words.data());
        }
    }
    glslang_program_delete(program);
    glslang_shader_delete(shader);
    if (words.empty())
        return bad_input(fmt::format("shaders/{}: expected GLSL that compiles, found {}", file, problem));
    return words;
}

std::filesystem::file_time_type newest_in(const std::filesystem::path& folder) {
    auto newest = std::filesystem::file_time_type::min();  // the epoch of this clock is in 2174
    std::error_code ignored;                               // the error case returns the minimum time
    for (const std::filesystem::path& file : list_folder(folder).entries)
        newest = std::max(newest, std::filesystem::last_write_time(file, ignored));
    return newest;
}

}  // namespace

struct ShaderReload::Watched {
    shaders::Source source;
    std::string text;  // expanded, as last compiled
};

ShaderReload::ShaderReload(std::filesystem::path folder) : folder_(std::move(folder)) {
    glslang_initialize_process();
    newest_ = newest_in(folder_);
    for (const shaders::Source& source : shaders::sources())
        watched_.push_back({source, expanded(folder_, source)});
}

ShaderReload::~ShaderReload() {
    glslang_finalize_process();
}

Result<bool> ShaderReload::poll() {
    const auto newest = newest_in(folder_);
    if (newest == newest_) return false;
    newest_ = newest;
    bool changed = false;
    Result<bool> outcome = true;
    for (Watched& watched : watched_) {
        std::string text = expanded(folder_, watched.source);
        if (text == watched.text || text.empty()) continue;
        watched.text = std::move(text);
        auto words = compile(watched.source.file, watched.text);
        if (!words) {
            outcome = words.error();
            continue;
        }
        replacements_[watched.source.spirv.data()] = std::move(*words);
        changed = true;
    }
    if (outcome) outcome = changed;
    return outcome;
}

}  // namespace onggi::render
