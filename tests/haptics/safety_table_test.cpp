// The fifteen safety properties of a kiosk's loop, and the tests of each besides safety_properties_test.cpp.
// A renamed or removed test fails here.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>
#include "tests/support/places.h"

namespace onggi {
namespace {

struct Proof {
    int property;
    const char* what;
    const char* file;  // under tests/
    const char* test;
};

// The fifteen properties, and the other tests of each.
constexpr Proof kProvedElsewhere[] = {
    {1, "force within the device's peak and the profile's cap", "unit/haptics/safety_chain_test.cpp",
     "NeverExceedsThePeakOrTheSlewRateForAnyInput"},
    {1, "continuous force as a thermal mean", "unit/haptics/safety_stages_test.cpp",
     "GivesThePeakForAMomentAndTheContinuousForceForEver"},
    {2, "direction kept by the clamp", "unit/haptics/safety_chain_test.cpp", "KeepsTheDirectionOfEveryForce"},
    {3, "slew, and letting go faster", "unit/haptics/safety_chain_test.cpp",
     "LetsGoTenTimesFasterThanItPushes"},
    {4, "ramp and small force", "unit/haptics/safety_chain_test.cpp",
     "WaitsForASmallForceForMoreThanThreeTicks"},
    {5, "not finite, or outside", "unit/haptics/safety_chain_test.cpp",
     "LatchesAFaultOnAnInputThatIsNotFiniteOrOutside"},
    {6, "speed in contact", "unit/haptics/safety_stages_test.cpp", "BrakesATooFastToolAndThenLetsItGo"},
    {7, "host watchdog", "unit/haptics/watchdog_test.cpp", "LetsTheDeviceGoWhenTheLoopStandsStill"},
    {7, "starvation of a USB device", "unit/hid/hid_session_test.cpp", "RemovesTheForceWhenTheTickStops"},
    {7, "host watchdog of the Inverse3", "unit/haply/inverse_session_test.cpp",
     "LetsGoAtOnceWhenTheWatchdogAsksAndStaysLooseUntilTheForceIsSmall"},
    {7, "the supervisor after SIGKILL", "device/live_program_test.cpp",
     "AForceJoystickIsLetGoByTheSupervisorWhenTheProgramIsKilled"},
    {8, "stale input", "unit/haptics/safety_stages_test.cpp",
     "LetsGoOfAPositionThatIsNotRefreshedForTwoTicks"},
    {8, "stale input of a USB device", "unit/hid/hid_session_test.cpp", "RemovesTheForceWhenItsInputIsStale"},
    {8, "stale input of the Inverse3", "unit/haply/inverse_client_test.cpp",
     "TellsOfEachReadWhetherAMessageCame"},
    {8, "a USB device that has fallen mute", "unit/hid/mute_device_test.cpp",
     "ThatReportsContinuouslyLosesItsForceOnceSilent"},
    {8, "a hand that keeps still", "unit/hid/mute_device_test.cpp",
     "ThatReportsChangesOnlyKeepsItsForceWhileItIsHeldStillAndLosesItWithinASecond"},
    {9, "work of the applied force", "unit/haptics/device_group_test.cpp",
     "TheObserverCountsTheWorkOfTheAppliedForce"},
    {9, "passivity", "haptics/stability_test.cpp", "GainsSeveralTimesTheStiffnessByTheController"},
    {10, "stiffness refused with the number", "haptics/stability_test.cpp",
     "ThatIsStifferThanItsDeviceCanShowStably"},
    {10, "what each device here is granted is borne by it", "haptics/shipped_devices_test.cpp",
     "OscillatesWithTheStudiosClayButNotWithTheLimitedStiffness"},
    {10, "an unknown weight", "haptics/stability_test.cpp",
     "OnADeviceThatDoesNotSayItsWeightAsOnTheHardestOfTheBench"},
    {11, "late ticks counted, never replayed", "unit/jobs/pacer_test.cpp",
     "SkipsAndCountsThePeriodsThatWentByAndNeverReplaysThem"},
    {11, "time clamped to two ticks", "unit/jobs/pacer_test.cpp",
     "ClampsTimeToTwoTicksHoweverManyWereSkipped"},
    {12, "no blocking call in the tick", "unit/hid/hid_device_test.cpp",
     "IsHeardThroughItsThreadAndClosedWithIt"},
    {12, "a blocked device beside the tick", "stress/blocked_device_test.cpp", "DoesNotDelayTheTick"},
    {12, "plugged in again: from nothing", "unit/hid/hid_session_test.cpp",
     "RampsTheForceUpAgainAfterAReplug"},
    {13, "no allocation", "unit/haptic/allocation_test.cpp",
     "AllocatesNothingWhileItTicksPublishesRecordsRestartsAndObeys"},
    {13, "no system call, clock, lock, exception or page fault", "haptics/quiet_tick_test.cpp",
     "TheTickOfTheStudiosClayMakesNoSystemCall"},
    {14, "dead-man", "unit/haptics/safety_stages_test.cpp", "LetsGoWithinFiveMillisecondsOfAMissingHand"},
    {14, "stop key while the picture hangs", "unit/haptics/stop_key_test.cpp",
     "WorksWhileEveryOtherThreadHangs"},
    {15, "every tick recorded, replayed to the bit", "unit/haptic/job_test.cpp",
     "KeepsARecordOfEveryTickThatReplaysToTheSameState"},
};

TEST(SafetyProperties, AreFifteenAndEachIsProvedWhereTheTableSays) {
    std::vector<bool> named(16, false);
    for (const Proof& proof : kProvedElsewhere) {
        named.at(static_cast<std::size_t>(proof.property)) = true;
        std::ifstream in(test::in_checkout("tests/") + proof.file);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        EXPECT_NE(text.find(std::string(", ") + proof.test + ")"), std::string::npos)
            << proof.property << ' ' << proof.what << ": " << proof.file << " has no test " << proof.test;
    }
    for (std::size_t property = 1; property <= 15; ++property)
        EXPECT_TRUE(named[property]) << property;
}

}  // namespace
}  // namespace onggi
