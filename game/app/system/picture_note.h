// Remembers the picture quality that this machine's device reached, from one run of the program to the next:
// one line in FOLDER/picture, written atomically. Its content is LiveView::quality_note(). Main thread;
// blocks.
#pragma once

#include <filesystem>
#include <string>

#include "engine/core/result.h"

namespace onggi::app {

class PictureNote {
  public:
    explicit PictureNote(std::filesystem::path folder) : file_(std::move(folder) / "picture") {}

    // Returns an empty note if the file is missing or its content is not a note.
    [[nodiscard]] std::string read();
    // Writes the note if it differs from the one last read or kept. Errors: the disk's; there is no retry.
    Result<void> keep(const std::string& note);

  private:
    std::filesystem::path file_;
    std::string kept_;
};

}  // namespace onggi::app
