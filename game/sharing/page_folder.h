// What goes into a shared pot's folder, worked out in memory and then written: pages, look, files, their
// packed twins, the note. Inside the outbox's room. Any thread but the haptic one; write() blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "game/sharing/kept_note.h"
#include "game/sharing/outbox.h"

namespace onggi::sharing {

class PageFolder {
  public:
    // Reads the pot's files. Bad input: one cannot be read, or a picture is none.
    [[nodiscard]] static Result<PageFolder> of(const SharedPot& pot);

    // The pages, and what is the same for every pot.
    void add_pages(const SharedPot& pot, const OutboxOptions& options, const ShareCode& code,
                   const ShareTime& time);
    void add_note(const KeptNote& note);
    Result<void> add_twins();

    [[nodiscard]] std::uint64_t bytes() const;
    // The pages last, so that none has a link to what is not there.
    Result<void> write(const std::filesystem::path& folder) const;

  private:
    using Bytes = std::vector<std::byte>;
    Result<void> add(const FileContent& content, const std::string& name);
    // NAME.png, .jpg or .webp; gives which.
    Result<std::string> add_picture(const FileContent& content, const std::string& name);
    void add_text(const std::string& name, std::string_view text);

    std::map<std::string, Bytes, std::less<>> files_;
    std::string poster_;
    std::string picture_;
    std::string surface_;
    std::string still_;
};

// When a pot goes, as its page says it: "18:00" for a time of the same local day, "24:00" for its end; else
// "2026-11-25, 18:00".
struct GoneAt {
    std::string text;
    bool is_today = false;
};
[[nodiscard]] GoneAt gone_at(const ShareTime& time);

}  // namespace onggi::sharing
