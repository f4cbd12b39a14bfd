// Fields of a JSON file, read with their bounds: the first that is wrong is kept as the one line a user
// reads. Any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/math/math.h"

namespace onggi::wheel {

struct Bounds {
    double least = 0.0;
    double most = 0.0;
};

// A reader over one file. After the first error every read gives zeros, so that callers ask once at the end.
class JsonFields {
  public:
    // `file` is what messages call it.
    explicit JsonFields(std::string file) : file_(std::move(file)) {}

    // The whole file as an object; an error if it is none.
    [[nodiscard]] nlohmann::json parse(std::string_view text);

    // `place` is the path to the object, for messages: "cameras.throw_16x9".
    [[nodiscard]] const nlohmann::json& object(const nlohmann::json& in, const std::string& place,
                                               const char* name);
    [[nodiscard]] const nlohmann::json& array(const nlohmann::json& in, const std::string& place,
                                              const char* name, std::size_t size);
    [[nodiscard]] double number(const nlohmann::json& in, const std::string& place, const char* name,
                                Bounds bounds);
    [[nodiscard]] int whole_number(const nlohmann::json& in, const std::string& place, Bounds bounds);
    // An array of three numbers.
    [[nodiscard]] vec3 triple(const nlohmann::json& in, const std::string& place, const char* name,
                              Bounds bounds);
    [[nodiscard]] vec3 triple(const nlohmann::json& value, const std::string& place, Bounds bounds);

    void complain(const std::string& place, const std::string& expected, const std::string& found);
    [[nodiscard]] const std::optional<Error>& error() const { return error_; }

  private:
    [[nodiscard]] double number_itself(const nlohmann::json& value, const std::string& place, Bounds bounds);

    std::string file_;
    std::optional<Error> error_;
};

}  // namespace onggi::wheel
