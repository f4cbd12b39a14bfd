#include "game/app/sharing/page_store.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <string>

#include "game/sharing/kept_note.h"
#include "game/sharing/page_files.h"

namespace onggi::app {
namespace {

OpenFile open_in(int folder, const std::string& name) {
    // Does not block if a pipe stands in place of the file.
    const int descriptor =
        ::openat(folder, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (descriptor < 0) return {};
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
        ::close(descriptor);
        return {};
    }
    return {descriptor, static_cast<std::uint64_t>(status.st_size)};
}

bool is_over(int folder, std::int64_t wall_s) {
    const OpenFile note = open_in(folder, std::string(sharing::kNoteName));
    if (!note || note.size() > sharing::kMostNoteBytes) return true;
    std::array<char, sharing::kMostNoteBytes> text{};
    const ssize_t got = ::read(note.descriptor(), text.data(), text.size());
    if (got <= 0) return true;
    const auto read = sharing::read_note({text.data(), static_cast<std::size_t>(got)});
    return !read || sharing::is_over(*read, wall_s);
}

}  // namespace

OpenFile::~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

OpenFile PageStore::open(const sharing::ShareCode& code, std::string_view name, std::int64_t wall_s) const {
    const int folder =
        ::open((outbox_ / code.text()).c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) return {};
    OpenFile file = is_over(folder, wall_s) ? OpenFile() : open_in(folder, std::string(name));
    ::close(folder);
    return file;
}

}  // namespace onggi::app
