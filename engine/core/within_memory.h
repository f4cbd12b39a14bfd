// What does without memory where there is too little. Any thread but the haptic one.
#pragma once

#include <new>
#include <string>

#include "engine/core/result.h"

namespace onggi {

// As operator new does for memory that comes from elsewhere: throws std::bad_alloc.
[[noreturn]] inline void refuse_memory() {
    if (const auto handler = std::get_new_handler()) handler();
    throw std::bad_alloc();
}

// Returns the work's Result, or an error that begins with `place`.
template <typename Work>
auto within_memory(const char* place, Work&& work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return system_lacks(std::string(place) + ": expected memory, found none left");
    }
}

}  // namespace onggi
