#include "game/wheel/workshop_files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "engine/asset/image.h"
#include "engine/core/quote.h"
#include "engine/core/result.h"
#include "engine/files/read_file.h"
#include "engine/math/math.h"

namespace onggi::wheel {
namespace {

// Reads fields of a JSON file with bounds, and keeps the first error as one line for the user.
struct Bounds {
    double least = 0.0;
    double most = 0.0;
};

// A reader over one file. After the first error every read returns zeros, so that callers check once at the
// end.
class JsonFields {
  public:
    // `file` is its name in messages.
    explicit JsonFields(std::string file) : file_(std::move(file)) {}

    // Parses the whole file as an object; an error if it is not one.
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

const nlohmann::json& nothing() {
    static const nlohmann::json value;
    return value;
}

// A value in a message: its kind, and its text if that is short.
std::string shown(const nlohmann::json& value) {
    if (value.is_null()) return "nothing";
    if (value.is_number() || value.is_boolean()) return value.dump();
    if (value.is_array()) return fmt::format("an array of {}", value.size());
    return std::string(value.is_object() ? "an object" : "a text");
}

std::string below(const std::string& place, const char* name) {
    return place.empty() ? name : place + "." + name;
}

const nlohmann::json& member(const nlohmann::json& in, const char* name) {
    if (!in.is_object()) return nothing();
    const auto found = in.find(name);
    return found == in.end() ? nothing() : *found;
}

nlohmann::json JsonFields::parse(std::string_view text) {
    constexpr bool kThrow = false;
    nlohmann::json value = nlohmann::json::parse(text, nullptr, kThrow);
    if (value.is_discarded() || !value.is_object()) {
        complain("", "a JSON object", value.is_discarded() ? "no JSON" : shown(value));
        return {};
    }
    return value;
}

const nlohmann::json& JsonFields::object(const nlohmann::json& in, const std::string& place,
                                         const char* name) {
    const nlohmann::json& value = member(in, name);
    if (!value.is_object()) complain(below(place, name), "an object", shown(value));
    return value.is_object() ? value : nothing();
}

const nlohmann::json& JsonFields::array(const nlohmann::json& in, const std::string& place, const char* name,
                                        std::size_t size) {
    const nlohmann::json& value = member(in, name);
    const bool fits = value.is_array() && value.size() == size;
    if (!fits) complain(below(place, name), fmt::format("an array of {}", size), shown(value));
    return fits ? value : nothing();
}

double JsonFields::number_itself(const nlohmann::json& value, const std::string& place, Bounds bounds) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (number >= bounds.least && number <= bounds.most) return number;
    complain(place, fmt::format("a number from {} to {}", bounds.least, bounds.most), shown(value));
    return 0.0;
}

double JsonFields::number(const nlohmann::json& in, const std::string& place, const char* name,
                          Bounds bounds) {
    return number_itself(member(in, name), below(place, name), bounds);
}

int JsonFields::whole_number(const nlohmann::json& value, const std::string& place, Bounds bounds) {
    const double number = number_itself(value, place, bounds);
    if (number != std::floor(number)) complain(place, "a whole number", shown(value));
    return static_cast<int>(number);
}

vec3 JsonFields::triple(const nlohmann::json& value, const std::string& place, Bounds bounds) {
    if (!value.is_array() || value.size() != 3) {
        complain(place, "three numbers", shown(value));
        return vec3(0.0F);
    }
    vec3 numbers(0.0F);
    for (int axis = 0; axis < 3; ++axis)
        numbers[axis] =
            static_cast<float>(number_itself(value[static_cast<std::size_t>(axis)], place, bounds));
    return numbers;
}

vec3 JsonFields::triple(const nlohmann::json& in, const std::string& place, const char* name, Bounds bounds) {
    return triple(member(in, name), below(place, name), bounds);
}

void JsonFields::complain(const std::string& place, const std::string& expected, const std::string& found) {
    if (error_) return;
    error_ = bad_input(fmt::format("{}: {}{}expected {}, found {}", file_, place, place.empty() ? "" : ": ",
                                   expected, found));
}

constexpr std::size_t kMostJsonBytes = 1 << 20;
constexpr std::size_t kMostBackgroundBytes = std::size_t{32} << 20;
constexpr std::size_t kMostCameras = 64;
constexpr Bounds kPlaceMm{-1e5, 1e5};
constexpr Bounds kLight{0.0, 1e3};
constexpr Bounds kDirection{-1.0, 1.0};

constexpr const char* kPlates = "plates";
constexpr const char* kKeyJpeg = "_key.jpg";
constexpr const char* kAmbientJpeg = "_ambient.jpg";

bool has_photographs(const std::filesystem::path& workshop, const std::string& camera) {
    std::error_code error;
    return std::filesystem::exists(workshop / kPlates / (camera + kKeyJpeg), error);
}

std::string shown(const std::filesystem::path& path) {
    return shown_path(path.native());
}

// Reads a direction and normalises it; the file has only a few digits.
vec3 unit_vector(JsonFields& fields, const nlohmann::json& in, const std::string& place, const char* name) {
    const vec3 direction = fields.triple(in, place, name, kDirection);
    const float length = glm::length(direction);
    if (std::abs(length - 1.0F) < 0.01F) return direction / length;
    fields.complain(place + "." + name, "a direction of length 1", fmt::format("length {:.3f}", length));
    return {0.0F, 1.0F, 0.0F};
}

// The name becomes part of a file name: it must not lead out of the backgrounds' folder.
bool is_plain_name(const std::string& name) {
    return !name.empty() && name.size() <= 64 &&
           name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

BackgroundCamera read_camera(JsonFields& fields, const std::string& name, const nlohmann::json& in) {
    const std::string place = "cameras." + name;
    if (!is_plain_name(name))
        fields.complain("cameras", "names of at most 64 letters a-z, digits and _", in_quotes(name));
    BackgroundCamera background{.name = name, .camera = {}, .width_px = 0, .height_px = 0};
    background.camera.eye_mm = fields.triple(in, place, "eye_mm", kPlaceMm);
    background.camera.target_mm = fields.triple(in, place, "target_mm", kPlaceMm);
    constexpr Bounds kFovRad{0.02, 2.6};
    background.camera.vertical_fov_rad =
        static_cast<float>(fields.number(in, place, "vertical_fov_rad", kFovRad));
    const nlohmann::json& size = fields.array(in, place, "size", 2);
    if (size.is_array()) {
        constexpr Bounds kSide{16, asset::kMaxImageSide};
        background.width_px = fields.whole_number(size[0], place + ".size", kSide);
        background.height_px = fields.whole_number(size[1], place + ".size", kSide);
    }
    const vec3 ahead = background.camera.target_mm - background.camera.eye_mm;
    const float distance_mm = glm::length(ahead);
    if (!fields.error() && glm::length(vec2(ahead.x, ahead.z)) < 1.0F)
        fields.complain(place, "a camera that does not look straight up or down", "one that does");
    background.camera.near_mm = 0.2F * distance_mm;
    background.camera.far_mm = 6.0F * distance_mm;
    return background;
}

// A camera with larger photographs takes all other fields from the camera it names in larger_than.
nlohmann::json enlarged(JsonFields& fields, const nlohmann::json& cameras, const std::string& name) {
    const nlohmann::json& in = cameras[name];
    const nlohmann::json& smaller = in["larger_than"];
    if (!smaller.is_string() || !cameras.contains(smaller) || cameras[smaller].contains("larger_than")) {
        fields.complain("cameras." + name + ".larger_than",
                        "the name of a camera that is not larger than another",
                        smaller.is_string() ? in_quotes(smaller.get<std::string>()) : "no name");
        return in;
    }
    nlohmann::json whole = cameras[smaller];
    whole.update(in);
    return whole;
}

void read_light(JsonFields& fields, const nlohmann::json& in, Workshop& workshop) {
    const nlohmann::json& key = fields.object(in, "", "key");
    workshop.key.towards_light = unit_vector(fields, key, "key", "towards_light");
    workshop.key.radiance = fields.triple(key, "key", "radiance", kLight);
    constexpr Bounds kAngleRad{1e-4, 0.7};
    workshop.key.angular_radius_rad =
        static_cast<float>(fields.number(key, "key", "angular_radius_rad", kAngleRad));
    if (workshop.key.towards_light.y < 0.1F)
        fields.complain("key.towards_light", "a light from above", "one from the side or below");

    const nlohmann::json& rest = fields.object(in, "", "irradiance_over_pi");
    const nlohmann::json& coefficients = fields.array(rest, "irradiance_over_pi", "coefficients", 9);
    constexpr Bounds kCoefficient{-1e3, 1e3};
    for (std::size_t i = 0; i < coefficients.size(); ++i)
        workshop.irradiance[i] = fields.triple(
            coefficients[i], fmt::format("irradiance_over_pi.coefficients[{}]", i), kCoefficient);

    render::Environment& environment = workshop.environment;
    const nlohmann::json& sky = fields.object(in, "", "environment");
    environment.zenith = fields.triple(sky, "environment", "zenith", kLight);
    environment.horizon = fields.triple(sky, "environment", "horizon", kLight);
    environment.nadir = fields.triple(sky, "environment", "nadir", kLight);
    const nlohmann::json& panels = fields.array(sky, "environment", "panels", environment.panels.size());
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const std::string place = fmt::format("environment.panels[{}]", i);
        constexpr Bounds kSharpness{0.1, 1e4};
        environment.panels[i] = {
            unit_vector(fields, panels[i], place, "direction"),
            fields.triple(panels[i], place, "radiance", kLight),
            static_cast<float>(fields.number(panels[i], place, "sharpness", kSharpness))};
    }
}

// The bytes of a JPEG file.
struct Negative {
    std::string name;
    std::string bytes;
};

Result<Negative> load_negative(const std::filesystem::path& path) {
    auto bytes = files::read_file(path, kMostBackgroundBytes);
    if (!bytes) return bytes.error();
    return Negative{shown(path), std::move(*bytes)};
}

Result<asset::Image> developed(const Negative& negative, const BackgroundCamera& camera) {
    auto image = asset::decode_jpeg(std::as_bytes(std::span(negative.bytes)), negative.name);
    if (!image) return image.error();
    if (image->width != camera.width_px || image->height != camera.height_px) {
        return bad_input(fmt::format("{}: expected {} x {} pixels as cameras.json says, found {} x {}",
                                     negative.name, camera.width_px, camera.height_px, image->width,
                                     image->height));
    }
    return image;
}

// The compressed bytes stay in memory, a twentieth of the pictures: a lost device is refilled from them,
// whatever happened to the files.
Result<std::shared_ptr<render::Photographs>> load_photographs(const std::filesystem::path& folder,
                                                              const BackgroundCamera& camera) {
    auto key = load_negative(folder / (camera.name + kKeyJpeg));
    if (!key) return key.error();
    auto key_image = developed(*key, camera);
    if (!key_image) return key_image.error();
    auto ambient = load_negative(folder / (camera.name + kAmbientJpeg));
    if (!ambient) return ambient.error();
    auto ambient_image = developed(*ambient, camera);
    if (!ambient_image) return ambient_image.error();
    return std::make_shared<render::Photographs>(
        render::PhotographPair{std::move(*key_image), std::move(*ambient_image)},
        [key = std::move(*key), ambient = std::move(*ambient), camera]() -> Result<render::PhotographPair> {
            auto key_again = developed(key, camera);
            if (!key_again) return key_again.error();
            auto ambient_again = developed(ambient, camera);
            if (!ambient_again) return ambient_again.error();
            return render::PhotographPair{std::move(*key_again), std::move(*ambient_again)};
        });
}

}  // namespace

std::string_view name_of(View view) {
    return view == View::kThrowing ? "throw" : "look_in";
}

const BackgroundCamera* Workshop::camera_for(View view, int width_px, int height_px) const {
    // Compares aspect ratios first, then sizes.
    using Distance = std::pair<double, double>;
    const auto apart = [](double a, double b) { return std::abs(std::log(a / b)); };
    const BackgroundCamera* nearest = nullptr;
    Distance least;
    for (const BackgroundCamera& camera : cameras) {
        if (!camera.name.starts_with(name_of(view))) continue;
        const Distance distance{apart(static_cast<double>(camera.width_px) / camera.height_px,
                                      static_cast<double>(width_px) / height_px),
                                apart(camera.height_px, height_px)};
        if (nearest == nullptr || distance < least) {
            least = distance;
            nearest = &camera;
        }
    }
    return nearest;
}

Result<Workshop> load_workshop(const std::filesystem::path& folder) {
    Workshop workshop{.folder = folder, .cameras = {}, .key = {}, .irradiance = {}, .environment = {}};
    const std::filesystem::path cameras_file = folder / "cameras.json";
    auto text = files::read_file(cameras_file, kMostJsonBytes);
    if (!text) return text.error();
    JsonFields camera_fields(shown(cameras_file));
    const nlohmann::json cameras = camera_fields.parse(*text);
    if (!camera_fields.error()) {
        const nlohmann::json& named = camera_fields.object(cameras, "", "cameras");
        for (const auto& [name, camera] : named.items()) {
            if (workshop.cameras.size() == kMostCameras) break;
            const bool is_larger = camera.is_object() && camera.contains("larger_than");
            if (is_larger && !has_photographs(folder, name)) continue;
            workshop.cameras.push_back(
                read_camera(camera_fields, name, is_larger ? enlarged(camera_fields, named, name) : camera));
        }
    }
    if (camera_fields.error()) return *camera_fields.error();
    if (workshop.camera_for(View::kThrowing, 16, 9) == nullptr) {
        return bad_input(fmt::format("{}: cameras: expected one whose name begins with throw, found none",
                                     shown(cameras_file)));
    }

    const std::filesystem::path light_file = folder / "light.json";
    text = files::read_file(light_file, kMostJsonBytes);
    if (!text) return text.error();
    JsonFields light_fields(shown(light_file));
    const nlohmann::json light = light_fields.parse(*text);
    if (!light_fields.error()) read_light(light_fields, light, workshop);
    if (light_fields.error()) return *light_fields.error();
    return workshop;
}

Result<std::shared_ptr<const render::Background>> load_background(const Workshop& workshop,
                                                                  const BackgroundCamera& camera) {
    auto background = std::make_shared<render::Background>();
    const std::filesystem::path folder = workshop.folder / kPlates;
    auto photographs = load_photographs(folder, camera);
    if (!photographs) return photographs.error();
    background->camera = camera.camera;
    background->width_px = camera.width_px;
    background->height_px = camera.height_px;
    background->photographs = std::move(*photographs);
    return std::shared_ptr<const render::Background>(std::move(background));
}

Result<void> BackgroundLoader::load(std::shared_ptr<const Workshop> workshop,
                                    std::vector<BackgroundCamera> cameras) {
    workshop_ = std::move(workshop);
    cameras_ = std::move(cameras);
    next_ = 0;
    loaded_ = {};
    done_.store(false, std::memory_order_relaxed);
    return thread_.start(*this, "backgrounds");
}

std::optional<BackgroundLoader::Loaded> BackgroundLoader::take() {
    if (!busy() || !done_.load(std::memory_order_acquire)) return std::nullopt;
    thread_.stop();
    return std::exchange(loaded_, {});
}

std::int64_t BackgroundLoader::round(std::int64_t /*now_ns*/) noexcept {
    constexpr std::int64_t kUntilStoppedNs = 3'600'000'000'000;
    if (next_ < cameras_.size()) {
        const BackgroundCamera& camera = cameras_[next_++];
        auto background = load_background(*workshop_, camera);
        if (background) {
            loaded_.backgrounds.emplace_back(camera.name, std::move(*background));
        } else {
            loaded_.lacks.push_back(background.error().message);
        }
    }
    if (next_ < cameras_.size()) return 0;
    done_.store(true, std::memory_order_release);
    return kUntilStoppedNs;
}

}  // namespace onggi::wheel
