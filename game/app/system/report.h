// What the program says of itself, a line each, on stderr. Main thread.
#pragma once

#include <string_view>

#include "engine/core/result.h"

namespace onggi::app {

// The exit code that belongs to the error, after saying it.
int report(const Error& error);
// What is no failure.
void remark(std::string_view line);

}  // namespace onggi::app
