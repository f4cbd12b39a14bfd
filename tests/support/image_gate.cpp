// See image_gate.h. Main thread.
#include "tests/support/image_gate.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tests/support/image_compare.h"
#include "tests/support/places.h"

namespace onggi::support {
namespace {

using asset::Image;
using std::filesystem::path;
using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

struct Golden {
    Image image;
    RenderInfo info;
    Tolerances tolerances;
};

std::string environment(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

Result<std::string> read_text(const path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in || !text) return bad_input(fmt::format("{}: cannot be read", file.string()));
    return text.str();
}

Result<void> write_text(const path& file, std::string_view text) {
    std::error_code ignored;  // the open below fails and says so
    std::filesystem::create_directories(file.parent_path(), ignored);
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    out.close();
    if (!out) return failed(fmt::format("{}: cannot be written", file.string()));
    return {};
}

Result<void> write_image(const path& file, const Image& image) {
    const Result<std::vector<std::byte>> png = asset::encode_png(image);
    if (!png) return png.error();
    std::string text;
    text.reserve(png->size());
    for (const std::byte byte : *png)
        text += static_cast<char>(byte);
    return write_text(file, text);
}

Result<Image> read_image(const path& file) {
    const Result<std::string> text = read_text(file);
    if (!text) return text.error();
    return asset::decode_png(std::as_bytes(std::span(*text)), file.string());
}

std::string sidecar_text(const RenderInfo& info) {
    const nlohmann::ordered_json json{{"driver", info.driver},
                                      {"version", info.version},
                                      {"driver_info", info.driver_info},
                                      {"state_hash", info.state_hash},
                                      {"tolerances",
                                       {{"delta_limit", kSameDriver.delta_limit},
                                        {"bad_share", kSameDriver.bad_fraction},
                                        {"mean_delta", kSameDriver.mean_delta}}}};
    return json.dump(2) + "\n";
}

Result<void> read_sidecar(const path& file, Golden& golden) {
    const Result<std::string> text = read_text(file);
    if (!text) return text.error();
    try {
        const nlohmann::json json = nlohmann::json::parse(*text);
        golden.info = {json.at("driver"), json.at("version"), json.at("driver_info"), json.at("state_hash")};
        const nlohmann::json& limits = json.at("tolerances");
        golden.tolerances = {limits.at("delta_limit"), limits.at("bad_share"), limits.at("mean_delta")};
    } catch (const nlohmann::json::exception& problem) {
        return bad_input(fmt::format("{}: {}", file.string(), problem.what()));
    }
    // A scene may be held to less than the house's limits, never to more.
    const Tolerances& found = golden.tolerances;
    if (found.delta_limit > kSameDriver.delta_limit || !(found.bad_fraction <= kSameDriver.bad_fraction) ||
        !(found.mean_delta <= kSameDriver.mean_delta)) {
        return bad_input(fmt::format("{}: expected tolerances of at most {}/255, {} and {}", file.string(),
                                     kSameDriver.delta_limit, kSameDriver.bad_fraction,
                                     kSameDriver.mean_delta));
    }
    return {};
}

bool is_scene_name(const std::string& name) {
    return !name.empty() &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") == std::string::npos;
}

path png_of(const GateOptions& options, const std::string& name) {
    return options.golden_folder / (name + ".png");
}
path sidecar_of(const GateOptions& options, const std::string& name) {
    return options.golden_folder / (name + ".json");
}

// The folder of the pictures that this release of Mesa draws otherwise; empty for other drivers.
path folder_of_release(const GateOptions& options, const RenderInfo& info) {
    std::smatch release;
    if (!std::regex_search(info.version, release, std::regex("^Mesa ([0-9]+\\.[0-9]+)"))) return {};
    return options.golden_folder.parent_path() / ("lavapipe-" + release[1].str());
}

std::string describe(const ImageDifference& difference, const Tolerances& limits) {
    return fmt::format(
        "{:.4f} % of pixels differ by more than {}/255 (limit {:.4f} %), mean {:.5f} (limit {})",
        100.0 * difference.bad_fraction, limits.delta_limit, 100.0 * limits.bad_fraction,
        difference.mean_delta, limits.mean_delta);
}

bool within(const ImageDifference& difference, const Tolerances& limits) {
    return difference.bad_fraction <= limits.bad_fraction && difference.mean_delta <= limits.mean_delta;
}

std::string describe_worst(const ImageDifference& difference) {
    std::string text;
    const auto colour = [](const std::array<std::uint8_t, 4>& c) {
        return fmt::format("{} {} {} {}", c[0], c[1], c[2], c[3]);
    };
    for (const DifferingPixel& pixel : difference.worst) {
        text += fmt::format("  pixel {},{}: off by {}, expected {}, found {}\n", pixel.x, pixel.y,
                            pixel.delta, colour(pixel.expected), colour(pixel.actual));
    }
    return text;
}

// Saves a picture for inspection and returns its path; a failure to save is reported and hides no other
// error.
std::string save(const GateOptions& options, const std::string& name, const char* what, const Image& image) {
    const path file = options.output_folder / fmt::format("{}.{}.png", name, what);
    const Result<void> written = write_image(file, image);
    return written ? fmt::format("  {}: {}\n", what, file.string())
                   : fmt::format("  {}: {}\n", what, written.error().message);
}

std::string how_to_bless(const std::string& name) {
    return fmt::format(
        "look at it, and if it is right: ONGGI_BLESS={} cmake --build BUILD --target golden-bless\n", name);
}

// The full report of a picture that differs.
std::string report(const std::string& name, const Golden& golden, const Image& image, const RenderInfo& info,
                   const GateOptions& options, const ImageDifference& difference) {
    std::string text = save(options, name, "actual", image);
    text += save(options, name, "expected", golden.image);
    text += save(options, name, "diff", difference_image(golden.image, image));
    text += describe_worst(difference);
    text += difference_map(golden.image, image);
    if (golden.info.state_hash != info.state_hash) {
        text += fmt::format(
            "the state shown has the hash {}, the golden's {}: look at the clay before the renderer\n",
            info.state_hash, golden.info.state_hash);
    }
    if (golden.info.driver_info != info.driver_info) {
        text += fmt::format("drawn by {}, the golden by {}\n", info.driver_info, golden.info.driver_info);
    }
    return text + how_to_bless(name);
}

AssertionResult store(const std::string& name, const Image& image, const RenderInfo& info,
                      const GateOptions& options) {
    if (options.in_ci) return AssertionFailure() << name << ": goldens are not stored in CI";
    const Result<std::string> dirty = options.dirty_paths();
    if (!dirty) return AssertionFailure() << name << ": not stored: " << dirty.error().message;
    if (!dirty->empty()) {
        return AssertionFailure() << name
                                  << ": not stored, because the tree differs from its last commit in\n"
                                  << *dirty << "a golden shows what a commit draws: commit first\n";
    }
    const path png = png_of(options, name);
    const Result<Image> before = read_image(png);
    std::string numbers = "there was none before";
    std::string old_copy;
    if (before && before->width == image.width && before->height == image.height) {
        numbers = describe(compare_images(*before, image, kSameDriver.delta_limit), kSameDriver);
    } else if (before) {
        numbers = fmt::format("it was {} x {}, it is {} x {}", before->width, before->height, image.width,
                              image.height);
    }
    if (before) old_copy = save(options, name, "expected", *before);
    for (const Result<void>& written :
         {write_image(png, image), write_text(sidecar_of(options, name), sidecar_text(info))}) {
        if (!written) return AssertionFailure() << name << ": not stored: " << written.error().message;
    }
    // The line that the bless target parses.
    fmt::print("blessed: {}\n  new: {}\n{}  {}\n", name, png.string(), old_copy, numbers);
    return AssertionSuccess();
}

AssertionResult compare(const std::string& name, const Golden& golden, const Image& image,
                        const RenderInfo& info, const GateOptions& options) {
    const bool same_driver = golden.info.driver == info.driver && golden.info.version == info.version;
    const Tolerances& limits = same_driver ? golden.tolerances : kOtherDriver;
    const ImageDifference difference = compare_images(golden.image, image, limits.delta_limit);
    const std::string numbers = describe(difference, limits);
    if (!same_driver) {
        fmt::print(
            "{}: drawn by {} {}, the golden by {} {}: wider limits; bless again when the project moves to "
            "it\n",
            name, info.driver, info.version, golden.info.driver, golden.info.version);
    }
    if (within(difference, limits)) {
        fmt::print("{}: {}\n", name, numbers);
        return AssertionSuccess();
    }
    const std::string story = report(name, golden, image, info, options, difference);
    if (same_driver || options.strict) return AssertionFailure() << name << ": " << numbers << "\n" << story;
    fmt::print("{}: {}\n{}", name, numbers, story);
    return AssertionSuccess();
}

}  // namespace

GateOptions gate_options_from_environment() {
    GateOptions options;
    options.golden_folder = test::in_checkout("tests/golden/images/lavapipe-22.3");
    options.output_folder = test::in_build("golden");
    options.strict = environment("ONGGI_GOLDEN_STRICT") == "1";
    options.in_ci = environment("CI") == "true";
    std::istringstream names(environment("ONGGI_BLESS"));
    for (std::string name; std::getline(names, name, ',');) {
        if (!name.empty()) options.bless.insert(name);
    }
    options.dirty_paths = [] { return dirty_paths_outside_goldens(test::in_checkout()); };
    return options;
}

Result<std::string> dirty_paths_outside_goldens(const path& repository) {
    const std::string command =
        fmt::format("git -C '{}' status --porcelain -- . ':(exclude)tests/golden' 2>&1", repository.string());
    std::FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return failed("git could not be started");
    std::string output;
    std::array<char, 256> part{};
    while (std::fgets(part.data(), part.size(), pipe) != nullptr)
        output += part.data();
    if (pclose(pipe) != 0) return failed(fmt::format("git could not tell the tree's state: {}", output));
    return output;
}

AssertionResult matches_golden(const std::string& name, const Image& image, const RenderInfo& info,
                               const GateOptions& common) {
    if (!is_scene_name(name)) return AssertionFailure() << '"' << name << "\" is no name for a scene";
    if (image.width < 1 || image.height < 1) return AssertionFailure() << name << ": the picture is empty";
    GateOptions options = common;
    const path of_release = folder_of_release(common, info);
    if (!of_release.empty() &&
        (common.bless.contains(name) || std::filesystem::exists(of_release / (name + ".png"))))
        options.golden_folder = of_release;
    if (options.bless.contains(name)) return store(name, image, info, options);

    if (!std::filesystem::exists(png_of(options, name))) {
        return AssertionFailure() << name << ": there is no golden " << png_of(options, name).string() << "\n"
                                  << save(options, name, "actual", image) << how_to_bless(name);
    }
    Golden golden;
    const Result<Image> stored = read_image(png_of(options, name));
    if (!stored) return AssertionFailure() << name << ": " << stored.error().message;
    golden.image = *stored;
    if (const Result<void> read = read_sidecar(sidecar_of(options, name), golden); !read) {
        return AssertionFailure() << name << ": " << read.error().message;
    }
    if (golden.image.width != image.width || golden.image.height != image.height) {
        return AssertionFailure() << fmt::format("{}: expected {} x {} pixels, found {} x {}\n", name,
                                                 golden.image.width, golden.image.height, image.width,
                                                 image.height)
                                  << save(options, name, "actual", image) << how_to_bless(name);
    }
    return compare(name, golden, image, info, options);
}

AssertionResult matches_golden(const std::string& name, const Image& image, const RenderInfo& info) {
    return matches_golden(name, image, info, gate_options_from_environment());
}

}  // namespace onggi::support
