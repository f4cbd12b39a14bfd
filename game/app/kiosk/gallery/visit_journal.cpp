#include "game/app/kiosk/gallery/visit_journal.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <span>
#include <system_error>
#include <utility>

#include "engine/files/atomic_file.h"
#include "engine/files/read_file.h"
#include "game/app/system/whole_number.h"

namespace onggi::app {
namespace {

constexpr std::int64_t kSyncEveryNs = 1'000'000'000;
// About 5 ms of writing: an undo rewrites minutes of ticks, and other jobs of the thread may be waiting.
constexpr std::size_t kMostTicksACall = 40'000;

constexpr int kPlaceFormat = 1;
constexpr std::size_t kMostPlaceBytes = 4096;
constexpr const char* kPlaceFile = "place.json";

}  // namespace

Result<void> write_place(const std::filesystem::path& folder, const VisitPlace& place) {
    const std::string text = nlohmann::json{
        {"format", kPlaceFormat},
        {"target", place.target},
        {"glaze", place.glaze},
        {"is_cut_off",
         place.is_cut_off}}.dump();
    std::error_code ignored;  // write_file_atomically() reports the error
    std::filesystem::create_directories(folder, ignored);
    return files::write_file_atomically(folder / kPlaceFile, std::as_bytes(std::span(text)));
}

Result<VisitPlace> read_place(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kPlaceFile;
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return VisitPlace{};
    const auto text = files::read_file(file, kMostPlaceBytes);
    if (!text) return text.error();
    try {
        const nlohmann::json note = nlohmann::json::parse(*text);
        if (const int format = whole_number<int>(note.at("format")); format != kPlaceFormat) {
            return bad_input(fmt::format("{}: expected the choices of a visit in format {}, found {}",
                                         file.string(), kPlaceFormat, format));
        }
        return VisitPlace{.target = note.at("target").get<std::string>(),
                          .glaze = whole_number<int>(note.at("glaze")),
                          .is_cut_off = note.at("is_cut_off").get<bool>()};
    } catch (const nlohmann::json::exception& error) {
        return bad_input(
            fmt::format("{}: expected the choices of a visit, found: {}", file.string(), error.what()));
    }
}

void remove_place(const std::filesystem::path& folder) noexcept {
    std::error_code ignored;
    std::filesystem::remove(folder / kPlaceFile, ignored);
}

Result<void> VisitJournal::give_up(const Error& error) {
    drop();
    gave_up_ = true;
    return Error{error.kind, "journal: this visit cannot be resumed: " + error.message};
}

Result<void> VisitJournal::begin(const haptic::History& history) {
    // A fresh lump: the previous pot was discarded and must not be restored.
    if (history.ticks() <= record::kHashInterval) written_.reset();
    next_.reset();
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    number_ = 1 - number_;
    auto begun =
        history.begin_session(folder_ / fmt::format("visit-{}.onggi", number_ + 1), files::Beside::kNamed);
    if (!begun) return begun.error();
    next_ = std::move(*begun);
    lineage_ = history.lineage();
    return {};
}

Result<void> VisitJournal::follow(const haptic::History& history, std::int64_t now_ns) {
    if (gave_up_ || !history.is_whole()) return {};
    if (lineage_ != history.lineage()) {
        if (auto begun = begin(history); !begun) return give_up(begun.error());
    }
    record::SessionWriter& writer = next_ ? *next_ : *written_;
    if (auto written = history.write_on(writer, kMostTicksACall); !written) return give_up(written.error());
    const bool arrived = next_ && writer.tick_count() == history.ticks() - history.first_tick();
    if (!arrived && (next_ || now_ns - synced_ns_ < kSyncEveryNs)) return {};
    synced_ns_ = now_ns;
    if (auto synced = writer.sync(); !synced) return give_up(synced.error());
    if (!arrived) return {};
    written_ = std::move(*next_);  // which deletes the older file
    next_.reset();
    return {};
}

std::filesystem::path VisitJournal::file() const {
    // Until the newer file has caught up, the older one is longer.
    const auto& longer = written_ ? written_ : next_;
    return longer ? longer->beside() : std::filesystem::path();
}

void VisitJournal::drop() noexcept {
    written_.reset();
    next_.reset();
    lineage_.reset();
    gave_up_ = false;
}

Result<void> VisitJournal::leave() {
    // Until the newer file has caught up, the older one is longer.
    auto& longer = written_ ? written_ : next_;
    Result<void> left;
    if (longer) left = longer->leave();
    drop();
    return left;
}

}  // namespace onggi::app
