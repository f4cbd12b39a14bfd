// A machine with two Vulkan devices: the software driver, and beside it a copy of the same library, which the
// loader takes for another driver. Needs ONGGI_LIBRARY_FOLDER, the system's folder of this architecture's
// libraries.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/temporary_folder.h"

namespace onggi::test {

class TwoDrivers {
  public:
    TwoDrivers() {
        namespace fs = std::filesystem;
        fs::path first;
        for (const auto& entry : fs::directory_iterator("/usr/share/vulkan/icd.d")) {
            if (entry.path().filename().string().starts_with("lvp_icd.")) first = entry.path();
        }
        if (first.empty()) {
            ADD_FAILURE() << "expected Mesa's software driver, found none";
            return;
        }
        std::ifstream manifest_file(first);
        auto manifest = nlohmann::json::parse(manifest_file);
        fs::path library = manifest.at("ICD").at("library_path").get<std::string>();
        // A bare name is a library in the system's library folder.
        if (library.is_relative()) library = fs::path("/usr/lib") / ONGGI_LIBRARY_FOLDER / library;
        // Under a name that the list of foreign leaks contains.
        const fs::path copy = folder_ / "other_libvulkan_lvp.so";
        fs::copy_file(library, copy);
        manifest["ICD"]["library_path"] = copy.string();
        std::ofstream(folder_ / "other.json") << manifest.dump();
        manifests_ = first.string() + ":" + (folder_ / "other.json").string();
    }

    // The value for VK_DRIVER_FILES and VK_ICD_FILENAMES, its older name.
    [[nodiscard]] const std::string& manifests() const { return manifests_; }

  private:
    TemporaryFolder folder_;
    std::string manifests_;
};

}  // namespace onggi::test
