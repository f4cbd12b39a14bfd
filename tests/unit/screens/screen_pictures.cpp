// Paints every screen into a folder, to be looked at: screen_pictures FOLDER [LANGUAGE [WIDTH HEIGHT [TEXT
// [NAME [WAYS [SECONDS]]]]]]; with a NAME only those that begin so; WAYS: r low controls, l left hand, s one
// switch, or -; SECONDS: after the screen has come, else at the end of its motion.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/asset/image.h"
#include "engine/files/atomic_file.h"
#include "game/visit/steps.h"
#include "tests/unit/screens/flatten.h"
#include "tests/unit/screens/sample_views.h"

int main(int argc, char** argv) {
    using namespace onggi;
    const auto word = [&](int place, const char* fallback) {
        return std::string(argc > place ? argv[place] : fallback);
    };
    const std::filesystem::path folder = word(1, "out/screens");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const std::string ways = word(7, "");
    const screens::SampleRequest request{.width_px = std::atoi(word(3, "1280").c_str()),
                                         .height_px = std::atoi(word(4, "720").c_str()),
                                         .language = word(2, "en"),
                                         .text_size = std::atoi(word(5, "1").c_str()),
                                         .reach = ways.find('r') != std::string::npos,
                                         .left_hand = ways.find('l') != std::string::npos,
                                         .scans = ways.find('s') != std::string::npos};
    const std::optional<double> since_s = argc > 8 ? std::optional(std::atof(argv[8])) : std::nullopt;
    ui::Painter painter;
    screens::PaintingStore store(painter);
    for (const screens::SampleView& sample : screens::sample_views(request)) {
        if (!sample.name.starts_with(word(6, ""))) continue;
        const auto composition = visit::compose(*sample.view, painter, store);
        const auto png = asset::encode_png(screens::flatten(composition, ui::hex(0x8f7c64), true, since_s));
        if (!png) return 1;
        const auto name = folder / fmt::format("{}-{}-{}x{}-{}.png", sample.name, request.language,
                                               request.width_px, request.height_px, request.text_size);
        if (!files::write_file_atomically(name, *png)) return 1;
    }
    return 0;
}
