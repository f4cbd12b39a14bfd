// The pots that phones may fetch, on disk: one folder a pot, named by its code, with a page in each language
// and all its files. A folder appears atomically and is removed on expiry. Another process, or the museum's
// own web server, serves the outbox. Any one thread at a time but the haptic one; blocks. Throws no error,
// reads no clock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/kiosk/strings.h"
#include "game/sharing/share_code.h"
#include "game/sharing/shared_pot.h"

namespace onggi::sharing {

struct OutboxOptions {
    std::filesystem::path folder;
    std::size_t most_pots = 200;               // the oldest are removed first
    std::uint64_t most_bytes = 1'000'000'000;  // of all pots; the oldest are removed first
    // In the order of the page's links; at least one.
    std::shared_ptr<const std::vector<kiosk::Language>> languages{};
    bool own_digits = true;    // Arabic-Indic digits in Arabic
    std::string public_url{};  // "https://museum.org/pots", the URL of the served outbox; may be empty
};

// Seconds since 1970, UTC, and the local offset from UTC.
struct ShareTime {
    std::int64_t now_s = 0;
    std::int64_t expires_s = 0;
    std::int64_t utc_offset_s = 0;  // of local time, for the page's text
};

struct OutboxEntry {
    ShareCode code;
    std::int64_t made_s = 0;
    std::int64_t expires_s = 0;
    std::string gallery_name;
    std::uint64_t bytes = 0;
};

class Outbox {
  public:
    // Creates the folder if missing, removes the leftovers of a killed writer, and writes the outbox's own
    // files: the page that asks for a code, the page for a missing pot, robots.txt. System lacks: the folder
    // is not writable. Bad input: the path is not a folder.
    [[nodiscard]] static Result<Outbox> open(OutboxOptions options);

    // When it returns, the pot is on disk and survives a power cut. Expired pots are removed first where they
    // can be, then the oldest until the new one fits. Bad input: a file that cannot be read, a picture in an
    // unknown format, a pot larger than the outbox, an expiry time in the past. System lacks: no space, no
    // permission. After an error the pot's folder does not exist.
    [[nodiscard]] Result<ShareCode> put(const SharedPot& pot, const ShareTime& time);
    // Rewrites each file of the pot with this code, pages last, to add files that were missing. Returns false
    // if the pot is gone; it stays gone. Errors as put(); existing files stay.
    [[nodiscard]] Result<bool> renew(const ShareCode& code, const SharedPot& pot, const ShareTime& time);
    // Removes the pot before it returns. Returns true if the pot existed.
    [[nodiscard]] Result<bool> withdraw(const ShareCode& code);
    // Removes the shared pot with that gallery name. Returns true if it was shared.
    [[nodiscard]] Result<bool> withdraw_named(const std::string& gallery_name);
    // Removes expired pots, and code folders without a note. Returns how many. Corrects the dates of pots
    // that were shared before the clock was set. If one cannot be removed, removes the others and returns the
    // error (system lacks).
    [[nodiscard]] Result<int> expire(std::int64_t now_s);
    // Oldest first.
    [[nodiscard]] Result<std::vector<OutboxEntry>> list() const;

    [[nodiscard]] const OutboxOptions& options() const { return options_; }

  private:
    explicit Outbox(OutboxOptions options) : options_(std::move(options)) {}
    Result<void> make_room(const ShareCode& newcomer, std::int64_t now_s);
    [[nodiscard]] std::filesystem::path place_of(const ShareCode& code) const {
        return options_.folder / code.text();
    }

    OutboxOptions options_;
};

}  // namespace onggi::sharing
