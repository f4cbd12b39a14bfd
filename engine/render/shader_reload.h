// Shaders as they are edited, while the picture runs: watches the source folder and compiles what has
// changed. Only in development builds (ONGGI_SHADER_RELOAD); a release has the shaders it was built with and
// no compiler. Main thread; blocks while it compiles.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/pipeline.h"

namespace onggi::render {

class ShaderReload {
  public:
    // The folder of the shaders' sources. What lies there now counts as what was built.
    explicit ShaderReload(std::filesystem::path folder);
    ~ShaderReload();
    ShaderReload(const ShaderReload&) = delete;
    ShaderReload& operator=(const ShaderReload&) = delete;

    // True if some shader is now another than at the last call. Bad input: one that does not compile, in one
    // line with file and line; the others are as they were.
    Result<bool> poll();

    // What stands in for which of the shaders that were built in.
    [[nodiscard]] const vk::SpirvReplacements& replacements() const { return replacements_; }

  private:
    struct Watched;
    std::filesystem::path folder_;
    std::filesystem::file_time_type newest_{};
    std::vector<Watched> watched_;
    vk::SpirvReplacements replacements_;
};

}  // namespace onggi::render
