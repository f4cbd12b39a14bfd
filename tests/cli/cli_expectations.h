// Helpers for all tests of the command line: gestures on disk, one clear line, no files left behind.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/run_program.h"
#include "tests/support/places.h"
#include "tests/support/temporary_folder.h"

namespace onggi::test {

inline const std::string kPressAndHold = in_checkout("assets/gestures/press-and-hold.csv");
inline const std::string kGestureHeaderLine = "t_s,x_mm,y_mm,z_mm,button,tool_radius_mm\n";
inline const std::string kShortGesture =
    kGestureHeaderLine + "0,90,100,0,1,10\n0.1,69,100,0,1,10\n0.3,69,120,0,1,10\n0.4,90,120,0,0,10\n";

// Refused with this code, and one line on stderr that holds `reason`; nothing on stdout.
inline void expect_one_line(const ProgramRun& run, int exit_code, const std::string& reason) {
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(run.err.starts_with("onggi")) << run.err;
    EXPECT_NE(run.err.find(reason), std::string::npos) << "expected: " << reason << "\nfound: " << run.err;
    EXPECT_TRUE(std::none_of(run.err.begin(), run.err.end() - (run.err.empty() ? 0 : 1), [](unsigned char c) {
        return c < 0x20 || c == 0x7f;
    })) << run.err;
    EXPECT_EQ(run.out, "");
}

inline void expect_silent_success(const ProgramRun& run) {
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, "");
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

}  // namespace onggi::test
