// Which sound device and which speech program are asked, by what the system shows of them.
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "engine/sound/openal_player.h"
#include "engine/sound/speech_program.h"
#include "tests/support/temporary_folder.h"

namespace onggi::sound {
namespace {

// A variable of the environment, which is put back at the end.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* const before = std::getenv(name); before != nullptr) before_ = before;
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() { ::setenv(name_, before_.c_str(), 1); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
    std::string before_;
};

class WhereSoundGoes : public ::testing::Test {
  protected:
    // An empty file in place of a device or a socket.
    void add(const std::string& name) const {
        std::filesystem::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name).flush();
    }
    [[nodiscard]] std::string obstacle() const { return why_no_sound(folder_ / "snd"); }

    const test::TemporaryFolder folder_;

  private:
    const Variable driver_{"ALSOFT_DRIVERS", ""};
    const Variable server_{"PULSE_SERVER", ""};
    const Variable runtime_{"XDG_RUNTIME_DIR", folder_.path().string()};
};

TEST_F(WhereSoundGoes, NoDeviceIsOpenedWithoutACardAndAServer) {
    add("snd/timer");
    add("snd/pcmC0D0c");  // a microphone
    EXPECT_EQ(obstacle(), "expected a sound card or a sound server, found neither");
}

TEST_F(WhereSoundGoes, ACardIsEnough) {
    add("snd/pcmC0D0p");
    EXPECT_EQ(obstacle(), "");
}

TEST_F(WhereSoundGoes, PulseAudiosSocketIsEnough) {
    add("pulse/native");
    EXPECT_EQ(obstacle(), "");
}

TEST_F(WhereSoundGoes, PipeWiresOwnSocketIsEnough) {
    add("pipewire-0");
    EXPECT_EQ(obstacle(), "");
}

// speech-dispatcher answers OK to a language that it has not
// (findings/speech-dispatcher-takes-a-module-and-a-language-that-it-has-not.sh).
TEST_F(WhereSoundGoes, SpeechComesFromEspeakNgItselfAndNotFromAServer) {
    std::filesystem::create_directories(folder_ / "speech-dispatcher");
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = (folder_ / "speech-dispatcher/speechd.sock").string();
    ASSERT_LT(path.size(), sizeof address.sun_path);
    std::memcpy(address.sun_path, path.c_str(), path.size());
    const int server = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    ASSERT_EQ(::bind(server, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    ASSERT_EQ(::listen(server, 1), 0);
    const Variable where("SPEECHD_ADDRESS", "unix_socket:" + path);
    // A program that has no voice for any language.
    const std::string program = (folder_ / "espeak-ng").string();
    std::ofstream(program) << "#!/bin/sh\necho \"$*\" >" << (folder_ / "asked").string() << "\nexit 1\n";
    ASSERT_EQ(::chmod(program.c_str(), 0700), 0);
    const Variable programs("PATH", folder_.path().string());

    const auto line = synthesise("Open", {.language = "xx"}, [] { return true; });
    ASSERT_FALSE(line);
    EXPECT_NE(line.error().message.find("expected speech in the language 'xx', found an error"),
              std::string::npos)
        << line.error().message;
    std::string asked;
    std::getline(std::ifstream(folder_ / "asked"), asked);
    EXPECT_NE(asked.find("-v xx"), std::string::npos) << asked;
    pollfd caller{.fd = server, .events = POLLIN, .revents = 0};
    EXPECT_EQ(::poll(&caller, 1, 0), 0) << "a server was asked";
    ::close(server);
}

}  // namespace
}  // namespace onggi::sound
