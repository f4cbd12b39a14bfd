// Any bytes in a file that the kiosk keeps for its next start are refused in one line or are read, and what
// is read is written back so that it reads the same. The first byte chooses the file.
#include <stdlib.h>  // NOLINT: mkdtemp is POSIX

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "game/app/kiosk/gallery/jar_keeping.h"
#include "game/app/kiosk/gallery/wall_of_the_day.h"
#include "game/app/kiosk/health/kiosk_statistics.h"
#include "game/app/kiosk/health/kiosk_status.h"
#include "game/app/system/picture_note.h"
#include "game/app/system/start_log.h"
#include "game/sharing/kept_note.h"
#include "tests/fuzz/fuzz_expect.h"

namespace {

namespace fs = std::filesystem;
using namespace onggi;  // NOLINT: one small program

constexpr const char* kDay = "2026-11-25";

void expect_one_line(const std::string& message) {
    fuzz::expect(!message.empty() && message.find('\n') == std::string::npos);
}

const fs::path& folder() {
    static const fs::path made = [] {
        std::string name = (fs::temp_directory_path() / "onggi-fuzz-XXXXXX").string();
        fuzz::expect(::mkdtemp(name.data()) != nullptr);
        std::atexit([] { fs::remove_all(folder()); });
        return fs::path(name);
    }();
    return made;
}

fs::path put(const char* name, std::string_view content) {
    const fs::path file = folder() / name;
    std::ofstream(file, std::ios::binary) << content;
    return file;
}

void read_wall(std::string_view text) {
    app::WallOfTheDay wall(put("wall.json", text));
    if (const auto opened = wall.open(kDay); !opened) return expect_one_line(opened.error().message);
    const std::size_t pots = wall.pots().size();
    fuzz::expect(pots <= app::WallOfTheDay::kMostPots);
    for (const app::WallPot& pot : wall.pots())
        fuzz::expect(pot.shape.outside.size() > 1);
    static_cast<void>(wall.put({.gallery_name = "2026-11-25/pot-001"}, kDay));
}

void read_jar(std::string_view text) {
    static const haptic::HapticState lump{clay::StudioClay({.mass_g = 100.0, .rings = clay::kFewestRings})};
    static const haptic::HapticParameters parameters;
    put("jar.json", text);
    app::JarKeeping jar(folder(), lump, parameters);
    std::vector<std::string> remarks;
    fuzz::expect(static_cast<bool>(jar.look(remarks)));
    for (const std::string& line : remarks)
        expect_one_line(line);
    fuzz::expect(remarks.empty() == (jar.stage() != app::JarStage::kNone));
    // There is no bowl.
    if (const auto restored = jar.restore(1); !restored) expect_one_line(restored.error().message);
    fuzz::expect(!jar.has_bowl());
    jar.forget();
}

void read_starts(std::string_view text) {
    const auto log = app::read_start_log(text, "starts");
    if (!log) return expect_one_line(log.error().message);
    const auto again = app::read_start_log(app::text_of(*log), "again");
    fuzz::expect(again && *again == *log);
    app::StartLog next = *log;
    fuzz::expect(app::begin(next, 1'795'608'000).falls >= 0);
}

void read_status(std::string_view text) {
    const auto status = app::read_status_note(text, "status");
    if (!status) return expect_one_line(status.error().message);
    const auto again = app::read_status_note(app::text_of(*status), "again");
    fuzz::expect(again && again->at_s == status->at_s && again->version == status->version);
}

void read_statistics(std::string_view text) {
    for (const char* name : {"visits.csv", "attract_breaks.csv", "starts.csv"})
        put(name, text);
    const app::UseOfHour all = app::use_of(folder(), kDay).total();
    fuzz::expect(all.visits >= all.thrown && all.thrown >= 0 && all.kept >= 0 && all.dwell_s >= 0);
    // A later visit is counted, whatever precedes it.
    fuzz::expect(static_cast<bool>(app::note_visit(folder(), {.thrown = true, .kept = 1}, 1'795'608'000)));
    fuzz::expect(app::use_of(folder(), kDay).total().visits >= all.visits);
}

void read_picture(std::string_view text) {
    put("picture", text);
    const std::string read = app::PictureNote(folder()).read();
    fuzz::expect(read.find('\n') == std::string::npos);
    fuzz::expect(static_cast<bool>(app::PictureNote(folder()).keep(read)));
    fuzz::expect(app::PictureNote(folder()).read() == read);
}

void read_shared_pot(std::string_view text) {
    const auto note = sharing::read_note(text);
    if (!note) return;
    const auto again = sharing::read_note(sharing::written(*note));
    fuzz::expect(again && again->made_s == note->made_s && again->expires_s == note->expires_s);
    constexpr std::int64_t kNowS = 1'795'608'000;
    if (const auto later = sharing::redated(*note, kNowS))
        fuzz::expect(later->made_s == kNowS && !sharing::is_over(*later, kNowS));
    static_cast<void>(sharing::is_over(*note, kNowS));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::array kReaders{read_statistics, read_wall,       read_jar,   read_starts,
                                  read_picture,    read_shared_pot, read_status};
    if (size == 0) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
    kReaders[data[0] % kReaders.size()](text);
    return 0;
}
