// What `onggi doctor` finds: a fact, what its lack costs, and how to mend it. Main thread.
#pragma once

#include <span>
#include <string>

namespace onggi::app {

struct Finding {
    enum class Verdict {
        kGood,     // as it should be
        kNote,     // worth knowing; nothing is lost
        kLacking,  // something is lost: cost and remedy say what, and how to mend it
    };
    std::string subject{};  // one or two words
    Verdict verdict = Verdict::kGood;
    std::string found{};
    std::string cost{};    // only where lacking
    std::string remedy{};  // only where lacking
};

// Plain text, a finding a line, with its cost and remedy on lines of their own below it.
std::string findings_as_text(std::span<const Finding> findings);

bool any_lacking(std::span<const Finding> findings);

}  // namespace onggi::app
