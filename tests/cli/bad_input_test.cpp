// Gestures and sessions that cannot be played: exit code 2, one line with the place, no output touched.
#include <sys/stat.h>

#include "tests/cli/cli_expectations.h"
#include "tests/support/hostile_system.h"

namespace onggi::test {
namespace {

using Words = std::vector<std::string>;

// Throws `input`, which must be refused for this reason, with outputs to an existing profile and to new
// files.
ProgramRun expect_refused(const TemporaryFolder& folder, const std::string& input, int exit_code,
                          const std::string& reason) {
    put_file(folder / "old.csv", "old");
    const Words before = folder.names();
    const ProgramRun run = run_onggi({"throw", input, "--profile", "old.csv", "--forces", "f.csv", "--save",
                                      "s.onggi", "--export", "pot.glb", "--stats", "s.json"},
                                     {.folder = folder.path()});
    expect_one_line(run, exit_code, reason);
    EXPECT_EQ(folder.names(), before) << reason;
    EXPECT_EQ(content_of(folder / "old.csv"), "old");
    return run;
}

// A sanitizer needs memory of its own.
void expect_memory_below(const ProgramRun& run, long most_kb) {
    if (!is_sanitized()) {
        EXPECT_LT(run.most_memory_kb, most_kb);
    }
}

TEST(ABadGesture, IsRefusedWithItsLineAndColumn) {
    const std::string& header = kGestureHeaderLine;
    const std::string row = "0,90,100,0,1,10\n";
    const std::pair<std::string, std::string> cases[] = {
        {"", "g.csv:1: expected the header"},
        {header, "g.csv:2: expected at least one row"},
        {"t,x,y,z,button,radius\n" + row, "g.csv:1: expected the header"},
        {"t_s,x_mm,y_mm,z_mm,tool_radius_mm\n0,90,100,0,10\n", "g.csv:1: expected the header"},
        {"t_s,x_mm,y_mm,z_mm,tool_radius_mm\n0,90,100,0,10\n", "column button is missing"},
        {row, "g.csv:1: expected the header"},
        {header + "0,90,100,0,1\n", "g.csv:2: tool_radius_mm: expected a value, found the end of the line"},
        {header + row + "1,90,high,0,1,10\n", "g.csv:3: y_mm: expected a number, found 'high'"},
        {header + row + "1,nan,100,0,1,10\n", "g.csv:3: x_mm: expected a finite number, found 'nan'"},
        {header + row + "1,90,100,-inf,1,10\n", "g.csv:3: z_mm: expected a finite number, found '-inf'"},
        {header + row + "1,90,100,0,1,10\n0.5,90,100,0,1,10\n",
         "g.csv:4: t_s: expected a time after 1, found '0.5'"},
        {header + "0.5,90,100,0,1,10\n", "g.csv:2: t_s: expected 0 in the first row"},
        {header + row + "3601,90,100,0,1,10\n", "g.csv:3: t_s: expected 0 to 3600"},
        {header + "0,90,100,0,1,0\n", "g.csv:2: tool_radius_mm: expected 2 to 40, found '0'"},
        {header + "0,90,100,0,1,1000\n", "g.csv:2: tool_radius_mm: expected 2 to 40, found '1000'"},
        {header + "0,90,100,0,2,10\n", "g.csv:2: button: expected 0 or 1, found '2'"},
        {header + "0,1e6,100,0,1,10\n", "g.csv:2: x_mm: expected -1000 to 1000, found '1e6'"},
        {std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), "g.csv:1: expected the header"},
        {header + std::string("\0\1\2\3\4\5\n", 7), "g.csv:2: t_s: expected a number, found '\\x00\\x01"},
    };
    for (const auto& [content, reason] : cases) {
        const TemporaryFolder folder;
        put_file(folder / "g.csv", content);
        expect_refused(folder, "g.csv", 2, reason);
    }
}

TEST(ABadGesture, OfAHundredMegabytesInOneLineIsRefusedWithoutReadingThem) {
    const TemporaryFolder folder;
    put_file(folder / "junk.csv", std::string(std::size_t{100} << 20U, '7'));
    ProgramRun run =
        expect_refused(folder, "junk.csv", 2, "junk.csv:1: expected a line of at most 4096 bytes");
    expect_memory_below(run, 64 << 10);

    // The file starts well, so it has to be read; that takes no more memory than its size.
    put_file(folder / "junk.csv",
             kGestureHeaderLine + "0,90,100,0,1,10\n1," + std::string(std::size_t{100} << 20U, '7'));
    run = expect_refused(folder, "junk.csv", 2, "junk.csv:3: expected a line of at most 4096 bytes");
    expect_memory_below(run, 164 << 10);
}

TEST(ABadGesture, OfAGigabyteIsRefusedForItsSize) {
    const TemporaryFolder folder;
    put_file(folder / "huge.csv", kGestureHeaderLine + "0,90,100,0,1,10\n");
    std::filesystem::resize_file(folder / "huge.csv", std::uintmax_t{1} << 30U);
    const ProgramRun run =
        expect_refused(folder, "huge.csv", 2, "huge.csv: expected at most 268435456 bytes");
    expect_memory_below(run, 64 << 10);
}

TEST(AnInput, ThatIsNoFileIsRefused) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "folder");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    expect_refused(folder, "none.csv", 2, "none.csv: no such file");
    expect_refused(folder, "folder", 2, "folder: expected a file, found a folder");
    expect_refused(folder, "pipe", 2, "pipe: expected a file, found a pipe");
    expect_refused(folder, "/dev/zero", 2, "/dev/zero: expected a file, found a device");
    expect_refused(folder, "", 2, "");
}

TEST(AnInput, ThatMayNotBeReadIsAPermissionDenied) {
    const TemporaryFolder folder;
    put_file(folder / "g.csv", kShortGesture);
    std::filesystem::permissions(folder / "g.csv", std::filesystem::perms::none);
    expect_one_line(
        run_onggi({"throw", "g.csv"}, {.folder = folder.path(), .in_child = &bind_permissions_across_exec}),
        3, "g.csv: cannot read: Permission denied");
}

// The bytes of a recorded session.
std::string a_session() {
    const TemporaryFolder folder;
    expect_silent_success(
        run_onggi({"throw", kPressAndHold, "--clay", "paper", "--elements", "100", "--save", "s.onggi"},
                  {.folder = folder.path()}));
    return content_of(folder / "s.onggi");
}

TEST(ABadSession, IsRefusedWithTheOffset) {
    const std::string whole = a_session();
    std::string flipped = whole;
    flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 0x10);
    std::string newer = whole;
    newer[8] = 3;
    std::string older = whole;
    older[8] = 1;
    std::string wrong_size = whole;
    wrong_size[24] = 0x7f;
    const std::pair<std::string, std::string> cases[] = {
        {whole.substr(0, 40), "byte 40: expected a header of 72 bytes, found the end of the file"},
        {whole.substr(0, 200), "byte 200: expected"},
        {flipped, ": expected the checksum"},
        {newer, "byte 8: expected a session of version 2.2, found 3.0, written by a newer program"},
        {older,
         "byte 8: expected a session of version 2.2, found 1.0, recorded before hands could let go: record "
         "it "
         "again"},
        {wrong_size, "byte 68: expected the checksum"},
        {whole + "more", "byte " + std::to_string(whole.size()) + ": expected the end of the file"},
    };
    for (const auto& [content, reason] : cases) {
        const TemporaryFolder folder;
        put_file(folder / "in.onggi", content);
        expect_refused(folder, "in.onggi", 2, reason);
        expect_one_line(run_onggi({"replay", "in.onggi", "--validate"}, {.folder = folder.path()}), 2,
                        reason);
    }
}

TEST(ABadSession, ThatIsNoSessionIsRefusedByReplay) {
    const TemporaryFolder folder;
    put_file(folder / "g.onggi", kShortGesture);
    expect_one_line(run_onggi({"replay", "g.onggi", "--validate"}, {.folder = folder.path()}), 2,
                    "g.onggi: byte 0: expected the first bytes of a session, found 't_s,x_mm'");
    expect_one_line(run_onggi({"replay", "none.onggi", "--validate"}, {.folder = folder.path()}), 2,
                    "none.onggi: no such file");
}

TEST(ACutSession, IsPlayedUpToItsLastWholeBlockAndSaysSo) {
    const std::string whole = a_session();
    const TemporaryFolder folder;
    put_file(folder / "cut.onggi", whole.substr(0, whole.size() - 45));
    const ProgramRun run = run_onggi({"throw", "cut.onggi", "--forces", "f.csv"}, {.folder = folder.path()});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.err.find("cut.onggi: cut short"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("plays 1000 ticks"), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
    const std::string forces = content_of(folder / "f.csv");
    EXPECT_EQ(std::count(forces.begin(), forces.end(), '\n'), 1001);
}

// Refused before any window is opened, with or without a supervisor.
TEST(BadSettingsOfAKiosk, AreRefusedWithTheirLineAndTheAllowedValues) {
    const std::pair<std::string, std::string> cases[] = {
        {"[visit]\nidle_s = 5\n", "bad.toml, line 2: expected 10 to 600 for idle_s, found 5"},
        {"[staff]\nlock = true\n",
         "bad.toml, line 2: expected one of closes_after_s, locked, metrics_folder, name, pin"},
        {"[vist]\n", "bad.toml, line 1: expected a section [screen]"},
        {"[visit\n", "bad.toml, line 1: expected TOML, found "},
        {"[languages]\norder = [\"en\", \"tlh\"]\n",
         "languages: expected a table tlh.tsv for 'tlh', found none"},
    };
    for (const auto& [content, reason] : cases) {
        const TemporaryFolder folder;
        put_file(folder / "bad.toml", content);
        for (const char* device : {"mouse", "auto"}) {
            expect_one_line(
                run_onggi({"kiosk", "--config", "bad.toml", "--device", device}, {.folder = folder.path()}),
                2, reason);
        }
        EXPECT_EQ(folder.names(), Words{"bad.toml"});
    }
    // The doctor reports the same, after its checks.
    const TemporaryFolder ill;
    put_file(ill / "bad.toml", cases[0].first);
    const ProgramRun doctor = run_onggi({"doctor", "--config", "bad.toml"}, {.folder = ill.path()});
    EXPECT_EQ(doctor.exit_code, 0) << doctor.err;
    EXPECT_NE(doctor.out.find("  " + cases[0].second + "\n"), std::string::npos) << doctor.out;
    EXPECT_EQ(run_onggi({"doctor", "--config", "bad.toml", "--strict"}, {.folder = ill.path()}).exit_code, 3);
    const TemporaryFolder folder;
    put_file(folder / "good.toml", "[languages]\nfolder = \".\"\n");
    put_file(folder / "ko.tsv", "key\ttext\tspoken\tcheck\nname\t\t\t\n");
    const ProgramRun noted = run_onggi({"doctor", "--config", "good.toml"}, {.folder = folder.path()});
    EXPECT_EQ(noted.exit_code, 0) << noted.err;
    EXPECT_NE(
        noted.out.find("ko.tsv:2: expected a key and its text, found 'name'; the built-in words stand in"),
        std::string::npos)
        << noted.out;
}

}  // namespace
}  // namespace onggi::test
