#include "game/app/kiosk/gallery/interrupted_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "engine/core/list_folder.h"
#include "engine/files/read_file.h"
#include "game/app/kiosk/gallery/visit_journal.h"
#include "game/haptic/start_state.h"

namespace onggi::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kJournalPrefix = "visit-";
constexpr const char* kSpillFile = "left-over.onggi";
constexpr const char* kDroppedFile = "dropped.onggi";

struct Found {
    fs::path file;
    std::optional<record::Session> session;  // empty: unreadable, or not for this kiosk
    [[nodiscard]] std::uint64_t ticks() const { return session ? session->tick_count() : 0; }
};

std::vector<fs::path> journals_among(std::vector<fs::path> files) {
    std::erase_if(files, [](const fs::path& file) {
        const std::string name = file.filename().string();
        return !name.starts_with(kJournalPrefix) && name != kSpillFile;
    });
    std::sort(files.begin(), files.end());
    return files;
}

Result<record::Session> session_of(const fs::path& file, const haptic::HapticState& start,
                                   const haptic::HapticParameters& parameters,
                                   const std::vector<std::byte>& expected) {
    auto bytes = files::read_file(file, kMostSessionBytes);
    if (!bytes) return bytes.error();
    auto session = record::parse_session(std::move(*bytes), file.string(), record::Damage::kCutThere);
    if (!session) return session;
    if (session->header().rate_hz != parameters.rate_hz()) {
        return bad_input(fmt::format("{}: expected this kiosk's rate of {} Hz, found {} Hz", file.string(),
                                     parameters.rate_hz(), session->header().rate_hz));
    }
    const auto found = session->start_state();
    if (session->header() != haptic::session_header({start, parameters}) ||
        !std::equal(found.begin(), found.end(), expected.begin(), expected.end())) {
        return bad_input(
            fmt::format("{}: expected this kiosk's lump and parameters, found others: another "
                        "version of the program, or other settings of the clay",
                        file.string()));
    }
    return session;
}

}  // namespace

std::unique_ptr<InterruptedSession> InterruptedSession::find(const fs::path& folder,
                                                             const haptic::HapticState& start,
                                                             const haptic::HapticParameters& parameters,
                                                             std::vector<std::string>& remarks) {
    // There are several files if the program died while it rewrote the journal: the longest is complete.
    Found longest;
    std::vector<fs::path> dropped;
    const FolderListing listing = list_folder(folder);
    // One that was not listed or could not be read may be the longest, and is there at the next start.
    bool knows_all = listing.is_whole();
    if (!listing.is_whole()) remarks.push_back("interrupted visit: " + listing_trouble(folder, listing));
    std::vector<fs::path> others = journals_among(listing.entries);
    const std::vector<std::byte> start_bytes = haptic::start_state_bytes(start, parameters);
    std::error_code ignored;
    for (const fs::path& file : others) {
        // The program was killed before the first block, so nothing had been thrown.
        if (fs::file_size(file, ignored) < start_bytes.size()) continue;
        auto session = session_of(file, start, parameters, start_bytes);
        if (!session) {
            const bool is_damaged = session.error().kind == ErrorKind::kBadInput;
            knows_all = knows_all && is_damaged;
            if (is_damaged) dropped.push_back(file);
            remarks.push_back(std::string("interrupted visit: ") +
                              (is_damaged
                                   ? fmt::format("dropped, kept as {}: ", (folder / kDroppedFile).string())
                                   : std::string("not read: ")) +
                              session.error().message);
            continue;
        }
        if (!session->damage().empty()) {
            remarks.push_back(fmt::format("interrupted visit: intact for {:.1f} s, then damaged: {}",
                                          static_cast<double>(session->tick_count()) / parameters.rate_hz(),
                                          session->damage()));
        }
        if (session->tick_count() > longest.ticks()) longest = {file, std::move(*session)};
    }
    std::erase(others, longest.file);
    if (knows_all) {
        for (const fs::path& file : dropped)
            fs::rename(file, folder / kDroppedFile, ignored);
        for (const fs::path& file : others)
            fs::remove(file, ignored);
    }
    if (!longest.session) return nullptr;
    if (knows_all || !fs::exists(folder / kSpillFile, ignored))
        fs::rename(longest.file, folder / kSpillFile, ignored);
    return std::unique_ptr<InterruptedSession>(
        new InterruptedSession(std::move(*longest.session), start, parameters, folder));
}

Result<std::unique_ptr<InterruptedSession>> InterruptedSession::read(
    const fs::path& file, const haptic::HapticState& start, const haptic::HapticParameters& parameters,
    const fs::path& folder) {
    auto session = session_of(file, start, parameters, haptic::start_state_bytes(start, parameters));
    if (!session) return session.error();
    return std::unique_ptr<InterruptedSession>(
        new InterruptedSession(std::move(*session), start, parameters, folder));
}

std::unique_ptr<InterruptedSession> InterruptedSession::of_nothing(const haptic::HapticState& start,
                                                                   const haptic::HapticParameters& parameters,
                                                                   const fs::path& folder) {
    return std::unique_ptr<InterruptedSession>(
        new InterruptedSession(std::nullopt, start, parameters, folder));
}

Result<bool> InterruptedSession::work(int ticks) {
    if (!session_) return false;
    for (int i = 0; i < ticks && played_ < session_->tick_count(); ++i) {
        history_.add_played(cursor_->at(played_++));
        const record::Session::Block& block = session_->blocks()[(played_ - 1) / record::kHashInterval];
        const bool ends_block = played_ == block.first_tick + block.tick_count;
        if (ends_block && history_.state().hash() != block.state_hash) {
            return failed(
                fmt::format("interrupted visit: dropped, kept as {}: at tick {} expected the recorded clay, "
                            "found another, as from another version of the program",
                            (folder_ / kDroppedFile).string(), played_));
        }
    }
    if (played_ == session_->tick_count()) session_.reset();
    return session_.has_value();
}

void InterruptedSession::set_aside(const fs::path& folder) noexcept {
    std::error_code ignored;
    fs::rename(folder / kSpillFile, folder / kDroppedFile, ignored);
}

void InterruptedSession::remove(const fs::path& folder) noexcept {
    std::error_code ignored;
    fs::remove(folder / kSpillFile, ignored);
}

}  // namespace onggi::app
