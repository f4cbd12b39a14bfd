// The pots that phones may fetch, on the disk: a folder a pot, named by its code, with a page in each
// language and all its files, there whole or not at all and gone when its time is over. Another process, or a
// house's own web server, serves the folder. Any one thread at a time but the haptic one; blocks. No error is
// thrown, no clock is read.
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
    std::size_t most_pots = 200;               // the oldest leave first
    std::uint64_t most_bytes = 1'000'000'000;  // of all pots together; the oldest leave first
    // In the order of the page's links; at least one.
    std::shared_ptr<const std::vector<kiosk::Language>> languages{};
    bool own_digits = true;    // Arabic-Indic ones in Arabic
    std::string public_url{};  // "https://museum.org/pots", below which the folder is served; may be empty
};

// Seconds since 1970, UTC; the clock's offset from it there and then.
struct ShareTime {
    std::int64_t now_s = 0;
    std::int64_t expires_s = 0;
    std::int64_t utc_offset_s = 0;  // of local time, for what the page says
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
    // Makes the folder where it is missing, takes away what a killed writer left, and lays down what stands
    // at its door: the page that asks for a code, the one that says that there is no pot, robots.txt. System
    // lacks: it may not be written. Bad input: something that is no folder.
    [[nodiscard]] static Result<Outbox> open(OutboxOptions options);

    // When it returns, the pot is on the disk and stays over a power cut. Those whose time is over leave
    // first, and the oldest for which the newcomer leaves no room. Bad input: a file that cannot be read, a
    // picture that is none, a pot that is larger than everything may be, a time that is over. System lacks:
    // no room, no permission. Then nothing is there.
    [[nodiscard]] Result<ShareCode> put(const SharedPot& pot, const ShareTime& time);
    // Each file of the pot that has this code once more, in the place of the one before, its pages last: with
    // what it lacked then. False: it is gone, and stays so. Errors as put(); what was there is there.
    [[nodiscard]] Result<bool> renew(const ShareCode& code, const SharedPot& pot, const ShareTime& time);
    // True if there was such a pot. It is gone when this returns.
    [[nodiscard]] Result<bool> withdraw(const ShareCode& code);
    // The same of the pot that the gallery calls so: true if it was shared.
    [[nodiscard]] Result<bool> withdraw_named(const std::string& gallery_name);
    // Takes away those whose time is over, and folders of codes that have no note; gives how many there were.
    [[nodiscard]] Result<int> expire(std::int64_t now_s);
    // Oldest first.
    [[nodiscard]] Result<std::vector<OutboxEntry>> list() const;

    [[nodiscard]] const OutboxOptions& options() const { return options_; }

  private:
    explicit Outbox(OutboxOptions options) : options_(std::move(options)) {}
    Result<void> make_room(const ShareCode& newcomer);
    [[nodiscard]] std::filesystem::path place_of(const ShareCode& code) const {
        return options_.folder / code.text();
    }

    OutboxOptions options_;
};

}  // namespace onggi::sharing
