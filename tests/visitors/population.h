// A number of visitors of a kind, each on a separate wheel, and their results.
#pragma once

#include <string>
#include <vector>

#include "tests/visitors/judge.h"
#include "tests/visitors/people.h"

namespace onggi::visitors {

struct Crowd {
    Kind kind = Kind::kLesson;
    int count = 1;
    std::uint64_t first_seed = 1;
    double mass_g = 1000.0;
    Skill skill{};
    std::vector<dvec2> shown_mm{};  // the outline that the kiosk shows and assists; empty: no outline
};

// The result of one visitor.
struct Left {
    std::uint64_t seed = 0;
    Visit visit;
    Verdict verdict;            // of the pot at "done"
    Verdict after_advice;       // of the pot after the advice of "done", for a visitor who heeds it
    bool is_untouched = false;  // since the last release, to the bit
    double ledger_error_mm3 = 0.0;
    std::vector<dvec2> outer_mm;  // radius and height, every millimetre
    std::vector<dvec2> inner_mm;
};

std::vector<Left> throw_pots(const Crowd& crowd);

// A fraction, 0 to 1.
double fraction_of_pots(const std::vector<Left>& all);
double fraction_of_good_pots(const std::vector<Left>& all);
double fraction_of_good_pots_after_advice(const std::vector<Left>& all);
double fraction_within_mm(const std::vector<Left>& all, double rms_mm);
bool all_untouched(const std::vector<Left>& all);
double median_rms_mm(const std::vector<Left>& all);
double median_made_s(const std::vector<Left>& all);  // visitors without a pot count as infinity

// One line for each failed pot, for the test's message.
std::string words_for(const std::vector<Left>& all);

// One line for the table of kinds: count, pots, good pots at "done" and after its advice, and the medians at
// "done" of the mean and the thickest wall (mm), capacity (ml), height (mm), time (s) and the distance from a
// drawn outline (mm).
std::string row_for(Kind kind, const std::vector<Left>& all);

// Writes their pots as a picture, a row a crowd, half outside and half cut, the outline they meant in white.
void write_sheet(const std::string& path, const std::vector<std::vector<Left>>& rows);

}  // namespace onggi::visitors
