#include "game/app/command_line/finding.h"

#include <fmt/format.h>

#include <algorithm>

namespace onggi::app {
namespace {

const char* word_for(Finding::Verdict verdict) {
    switch (verdict) {
        case Finding::Verdict::kGood:
            return "good";
        case Finding::Verdict::kNote:
            return "note";
        case Finding::Verdict::kLacking:
            return "lacking";
    }
    return "";
}

}  // namespace

std::string findings_as_text(std::span<const Finding> findings) {
    std::size_t width = 0;
    for (const Finding& finding : findings)
        width = std::max(width, finding.subject.size());
    std::string text;
    const auto add_line = [&](std::string_view verdict, std::string_view subject, std::string_view words) {
        text += fmt::format("{:<8} {:<{}}  {}\n", verdict, subject, width, words);
    };
    for (const Finding& finding : findings) {
        add_line(word_for(finding.verdict), finding.subject, finding.found);
        if (finding.verdict != Finding::Verdict::kLacking) continue;
        add_line("", "", "costs: " + finding.cost);
        add_line("", "", "mend: " + finding.remedy);
    }
    return text;
}

bool any_lacking(std::span<const Finding> findings) {
    return std::any_of(findings.begin(), findings.end(),
                       [](const Finding& finding) { return finding.verdict == Finding::Verdict::kLacking; });
}

}  // namespace onggi::app
