// Reloads shaders while the program runs: watches the source folder and recompiles changed shaders.
// Development builds only (ONGGI_SHADER_RELOAD); a release has neither the compiler nor the sources. Main
// thread; blocks while it compiles.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/result.h"
#include "engine/vk/pipeline.h"

namespace onggi::render {

class ShaderReload {
  public:
    // `folder` holds the shaders' sources. Its current contents count as the built-in shaders.
    explicit ShaderReload(std::filesystem::path folder);
    ~ShaderReload();
    ShaderReload(const ShaderReload&) = delete;
    ShaderReload& operator=(const ShaderReload&) = delete;

    // Returns true if a shader has changed since the last call. Errors: a shader does not compile; one line
    // with file and line. The other shaders stay as they were.
    Result<bool> poll();

    // Replacements of built-in shaders.
    [[nodiscard]] const vk::SpirvReplacements& replacements() const { return replacements_; }

  private:
    struct Watched;
    std::filesystem::path folder_;
    std::filesystem::file_time_type newest_{};
    std::vector<Watched> watched_;
    vk::SpirvReplacements replacements_;
};

}  // namespace onggi::render
