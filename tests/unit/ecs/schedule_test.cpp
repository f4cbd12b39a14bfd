#include "engine/ecs/schedule.h"

#include <gtest/gtest.h>

#include <string>

namespace onggi::ecs {
namespace {

struct Trace {
    std::string text;
};

void receive(Registry&, Trace& trace) {
    trace.text += "r";
}
void animate_first(Registry&, Trace& trace) {
    trace.text += "a";
}
void animate_second(Registry&, Trace& trace) {
    trace.text += "b";
}
void extract(Registry&, Trace& trace) {
    trace.text += "x";
}

TEST(Schedule, RunsPhasesInOrderWhateverTheOrderOfAdding) {
    Schedule<Trace> schedule;
    schedule.add(Phase::kExtract, "extract", extract)
        .add(Phase::kAnimate, "animate first", animate_first)
        .add(Phase::kReceive, "receive", receive)
        .add(Phase::kAnimate, "animate second", animate_second);

    Registry registry;
    Trace trace;
    schedule.run(registry, trace);
    EXPECT_EQ(trace.text, "rabx");
    EXPECT_EQ(schedule.names(),
              (std::vector<std::string_view>{"receive", "animate first", "animate second", "extract"}));
}

}  // namespace
}  // namespace onggi::ecs
