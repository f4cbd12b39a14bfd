#include "game/app/system/picture_note.h"

#include <system_error>

#include "engine/files/atomic_file.h"
#include "engine/files/read_file.h"

namespace onggi::app {

std::string PictureNote::read() {
    constexpr std::size_t kMostBytes = 400;
    std::error_code error;
    if (!std::filesystem::exists(file_, error)) return {};
    const auto text = files::read_file(file_, kMostBytes);
    if (!text) return {};
    kept_ = text->substr(0, text->find('\n'));
    return kept_;
}

Result<void> PictureNote::keep(const std::string& note) {
    if (note == kept_) return {};
    kept_ = note;
    std::error_code error;
    std::filesystem::create_directories(file_.parent_path(), error);
    return files::write_file_atomically(file_, note + "\n");
}

}  // namespace onggi::app
