// onggi_bench: Google Benchmark's command line, with two differences. Names are literal
// ("paper_tick/2000/5"): the library appends "/manual_time" where a benchmark keeps its own clock, which this
// program omits when printing and matching. A benchmark with a wrong result makes the program exit with 1.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/bench_failure.h"

namespace onggi::bench {
namespace {

constexpr std::string_view kSuffix = "/manual_time";

bool failed = false;

// Wraps a reporter of the library; passes it names without the suffix.
template <typename Reporter>
class LiteralNames : public Reporter {
  public:
    using Reporter::Reporter;

    void ReportRuns(const std::vector<benchmark::BenchmarkReporter::Run>& runs) override {
        std::vector<benchmark::BenchmarkReporter::Run> renamed = runs;
        for (auto& run : renamed) {
            if (run.run_name.time_type == kSuffix.substr(1)) run.run_name.time_type.clear();
        }
        Reporter::ReportRuns(renamed);
    }
};

// The value of NAME=VALUE, "true" for a bare NAME, or otherwise.
std::string_view option(const std::vector<std::string>& arguments, std::string_view name,
                        std::string_view otherwise) {
    std::string_view value = otherwise;
    for (const std::string_view argument : arguments) {
        if (!argument.starts_with(name)) continue;
        const std::string_view rest = argument.substr(name.size());
        if (rest.empty()) value = "true";
        if (rest.starts_with('=')) value = rest.substr(1);
    }
    return value;
}

bool is_yes(std::string_view value) {
    return value == "true" || value == "yes" || value == "1";
}

bool wants_colour(const std::vector<std::string>& arguments) {
    const std::string_view colour = option(arguments, "--benchmark_color", "auto");
    if (colour != "auto") return is_yes(colour);
    return isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr;
}

std::unique_ptr<benchmark::BenchmarkReporter> reporter(std::string_view format, bool colour, bool tabular) {
    using Console = LiteralNames<benchmark::ConsoleReporter>;
    const int options =
        (colour ? Console::OO_Color : Console::OO_None) | (tabular ? Console::OO_Tabular : Console::OO_None);
    if (format == "console") return std::make_unique<Console>(static_cast<Console::OutputOptions>(options));
    if (format == "json") return std::make_unique<LiteralNames<benchmark::JSONReporter>>();
    return nullptr;
}

// "paper_tick/2000/5$" must match what the library calls "paper_tick/2000/5/manual_time".
std::string with_suffix_allowed(std::string_view filter) {
    std::string out;
    for (const char c : filter) {
        if (c == '$') out.append("(").append(kSuffix).append(")?");
        out += c;
    }
    return out;
}

void print_without_suffix(std::string names) {
    for (auto at = names.find(kSuffix); at != std::string::npos; at = names.find(kSuffix)) {
        names.erase(at, kSuffix.size());
    }
    std::fputs(names.c_str(), stdout);
}

int run(const std::vector<std::string>& arguments) {
    const bool tabular = is_yes(option(arguments, "--benchmark_counters_tabular", "false"));
    const auto display =
        reporter(option(arguments, "--benchmark_format", "console"), wants_colour(arguments), tabular);
    const auto file = reporter(option(arguments, "--benchmark_out_format", "json"), false, tabular);
    if (!display || !file) {
        std::fputs("onggi_bench: the formats are console and json\n", stderr);
        return 2;
    }
    const std::string filter = with_suffix_allowed(benchmark::GetBenchmarkFilter());
    if (is_yes(option(arguments, "--benchmark_list_tests", "false"))) {
        std::ostringstream names;
        display->SetOutputStream(&names);
        benchmark::RunSpecifiedBenchmarks(display.get(), filter);
        print_without_suffix(names.str());
        return 0;
    }
    if (option(arguments, "--benchmark_out", "").empty()) {
        benchmark::RunSpecifiedBenchmarks(display.get(), filter);
    } else {
        benchmark::RunSpecifiedBenchmarks(display.get(), file.get(), filter);
    }
    return failed ? 1 : 0;
}

}  // namespace

void fail(benchmark::State& state, const char* message) {
    failed = true;
    state.SkipWithError(message);
}

}  // namespace onggi::bench

int main(int argc, char** argv) {
    // Copied before the library removes its own options from argv.
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    const int exit_code = onggi::bench::run(arguments);
    benchmark::Shutdown();
    return exit_code;
}
