// How well this machine's device came to draw, from one run of the program to the next: one line in
// FOLDER/picture, written whole or not at all. What it says: LiveView::quality_note(). Main thread; blocks.
#pragma once

#include <filesystem>
#include <string>

#include "engine/core/result.h"

namespace onggi::app {

class PictureNote {
  public:
    explicit PictureNote(std::filesystem::path folder) : file_(std::move(folder) / "picture") {}

    // Empty where there is none, or what is there cannot be one.
    [[nodiscard]] std::string read();
    // Writes it where it is another than was read or kept before. Errors: the disk's; it is not tried again.
    Result<void> keep(const std::string& note);

  private:
    std::filesystem::path file_;
    std::string kept_;
};

}  // namespace onggi::app
