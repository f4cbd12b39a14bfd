#include "game/app/system/restart.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace onggi::app {
namespace {

// The words the program was started with, its own name first.
std::vector<std::string> own_words() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(file), {}};
    std::vector<std::string> words;
    for (std::size_t at = 0; at < all.size(); at += words.back().size() + 1)
        words.emplace_back(all.c_str() + at);
    return words;
}

// Where it lies; after an update there is a new one of the same name.
std::string own_place() {
    std::error_code error;
    std::string place = std::filesystem::read_symlink("/proc/self/exe", error).string();
    constexpr std::string_view kGone = " (deleted)";
    if (place.ends_with(kGone)) place.resize(place.size() - kGone.size());
    return place;
}

}  // namespace

Error start_anew() {
    const std::string place = own_place();
    std::vector<std::string> words = own_words();
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::fflush(nullptr);
    if (!words.empty()) ::execv(place.c_str(), arguments.data());
    return system_lacks(
        fmt::format("restart: expected to start {} anew, found {}", place, std::strerror(errno)));
}

}  // namespace onggi::app
