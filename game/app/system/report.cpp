#include "game/app/system/report.h"

#include <iostream>

namespace onggi::app {

int report(const Error& error) {
    remark(error.message);
    return exit_code(error.kind);
}

void remark(std::string_view line) {
    std::cerr << "onggi: " << line << '\n';
}

}  // namespace onggi::app
