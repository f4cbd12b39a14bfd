// See three_mf.h. The only file that includes lib3mf. Any thread.
#include "engine/asset/three_mf.h"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "engine/asset/mesh_rules.h"
#include "engine/asset/utf8.h"

namespace onggi::asset {
namespace {

// Releases a lib3mf object on every return.
template <typename T>
class Handle {
  public:
    Handle() = default;
    ~Handle() {
        if (held_ != nullptr) NMR::lib3mf_release(held_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    T** out() { return &held_; }
    [[nodiscard]] T* get() const { return held_; }

  private:
    T* held_ = nullptr;
};

struct Welded {
    std::vector<NMR::MODELMESHVERTEX> vertices;
    std::vector<NMR::MODELMESHTRIANGLE> triangles;
};

Welded welded(const Mesh& mesh) {
    Welded solid;
    std::map<std::array<float, 3>, DWORD> known;
    std::vector<DWORD> place_of;
    place_of.reserve(mesh.positions_m.size());
    for (const vec3& position_m : mesh.positions_m) {
        const vec3 at = z_up_mm(position_m);
        const auto next = static_cast<DWORD>(solid.vertices.size());
        const auto [found, is_new] = known.try_emplace({at.x, at.y, at.z}, next);
        if (is_new) solid.vertices.push_back({{at.x, at.y, at.z}});
        place_of.push_back(found->second);
    }
    solid.triangles.reserve(mesh.triangle_count());
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        solid.triangles.push_back(
            {{place_of[mesh.indices[i]], place_of[mesh.indices[i + 1]], place_of[mesh.indices[i + 2]]}});
    }
    return solid;
}

// Scales the picture down to thumbnail size by averaging blocks of pixels.
Image thumbnail_of(const Image& picture) {
    const int by = (std::max(picture.width, picture.height) + kThumbnailSide - 1) / kThumbnailSide;
    if (by <= 1) return picture;
    Image small{
        .width = std::max(1, picture.width / by), .height = std::max(1, picture.height / by), .rgba = {}};
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            std::array<unsigned, 4> sum{};
            for (int row = y * by; row < std::min((y + 1) * by, picture.height); ++row) {
                for (int column = x * by; column < std::min((x + 1) * by, picture.width); ++column) {
                    const std::size_t at =
                        4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                             static_cast<std::size_t>(column));
                    for (std::size_t channel = 0; channel < 4; ++channel)
                        sum[channel] += picture.rgba[at + channel];
                }
            }
            const auto count = static_cast<unsigned>(std::min((y + 1) * by, picture.height) - y * by) *
                               static_cast<unsigned>(std::min((x + 1) * by, picture.width) - x * by);
            for (const unsigned channel : sum)
                small.rgba.push_back(static_cast<std::uint8_t>((channel + count / 2) / count));
        }
    }
    return small;
}

struct Sink {
    std::vector<std::byte> bytes;
    std::size_t at = 0;
};
BOOL write_to(const BYTE* data, DWORD count, void* user) {
    auto& sink = *static_cast<Sink*>(user);
    sink.bytes.resize(std::max(sink.bytes.size(), sink.at + count));
    std::memcpy(sink.bytes.data() + sink.at, data, count);
    sink.at += count;
    return 0;
}
BOOL seek_to(UINT64 place, void* user) {
    static_cast<Sink*>(user)->at = static_cast<std::size_t>(place);
    return 0;
}

template <typename Number>
std::optional<Number> number_at(const std::vector<std::byte>& bytes, std::uint64_t at) {
    if (at > bytes.size() || bytes.size() - at < sizeof(Number)) return std::nullopt;
    Number number{};
    std::memcpy(&number, bytes.data() + at, sizeof number);
    return number;
}

// The file with its directory in the form of small files (APPNOTE 6.3.9, 4.3.12 and 4.3.16), where lib3mf
// writes ZIP64, which assimp 5.2.5 does not read there; and with the first day that ZIP can name, where
// lib3mf writes month zero, which readers refuse that make a date of it
// (findings/assimp-reads-no-3mf-that-lib3mf-wrote.sh). Empty: not in lib3mf's form.
std::vector<std::byte> with_plain_directory(const std::vector<std::byte>& zip) {
    constexpr std::uint16_t kFirstOfJanuary = (1U << 5U) | 1U;  // the year counts from 1980
    constexpr std::uint32_t kEntry = 0x02014b50;
    constexpr std::uint32_t kHead = 0x04034b50;
    constexpr std::uint32_t kEnd = 0x06054b50;
    constexpr std::size_t kEntryBytes = 46;
    constexpr std::size_t kEndBytes = 22;
    constexpr std::size_t kLocatorBytes = 20;
    if (zip.size() < kEndBytes + kLocatorBytes || zip.size() > std::numeric_limits<std::uint32_t>::max())
        return {};
    const auto end =
        number_at<std::uint64_t>(zip, zip.size() - kEndBytes - kLocatorBytes + 8).value_or(zip.size());
    const std::uint64_t directory = number_at<std::uint64_t>(zip, end + 48).value_or(zip.size());
    if (directory > end || end > zip.size()) return {};
    std::vector<std::byte> plain(zip.begin(), zip.begin() + static_cast<std::ptrdiff_t>(directory));
    const auto put = [&](std::uint64_t at, auto number) {
        std::memcpy(plain.data() + at, &number, sizeof number);
    };
    std::uint16_t count = 0;
    for (std::uint64_t at = directory; number_at<std::uint32_t>(zip, at) == kEntry; ++count) {
        const std::uint64_t name = number_at<std::uint16_t>(zip, at + 28).value_or(0);
        const std::uint64_t extra = number_at<std::uint16_t>(zip, at + 30).value_or(0);
        const std::uint64_t wide = at + kEntryBytes + name;  // the extra field: size, packed size, place
        const auto head = number_at<std::uint64_t>(zip, wide + 20);
        if (!head || *head > directory || number_at<std::uint32_t>(zip, *head) != kHead) return {};
        const std::uint64_t entry = plain.size();
        const auto first = zip.begin() + static_cast<std::ptrdiff_t>(at);
        plain.insert(plain.end(), first, first + static_cast<std::ptrdiff_t>(kEntryBytes + name));
        put(entry + 14, kFirstOfJanuary);
        put(entry + 20, static_cast<std::uint32_t>(*number_at<std::uint64_t>(zip, wide + 12)));
        put(entry + 24, static_cast<std::uint32_t>(*number_at<std::uint64_t>(zip, wide + 4)));
        put(entry + 30, std::uint16_t{0});
        put(entry + 42, static_cast<std::uint32_t>(*head));
        put(*head + 12, kFirstOfJanuary);
        at = wide + extra;
    }
    const std::uint64_t ends = plain.size();
    plain.resize(ends + kEndBytes);
    put(ends, kEnd);
    put(ends + 8, count);
    put(ends + 10, count);
    put(ends + 12, static_cast<std::uint32_t>(ends - directory));
    put(ends + 16, static_cast<std::uint32_t>(directory));
    return count > 0 ? plain : std::vector<std::byte>();
}

// Keeps the first failure of a sequence of library calls.
class Calls {
  public:
    void operator()(LIB3MFRESULT result, const char* doing) {
        if (result != LIB3MF_OK && !trouble_)
            trouble_ = failed(fmt::format("3MF: {}: the library says {:#x}", doing, result));
    }
    [[nodiscard]] bool are_good() const { return !trouble_.has_value(); }
    [[nodiscard]] const Error& trouble() const { return *trouble_; }

  private:
    std::optional<Error> trouble_;
};

// Fixed identifiers, because the library would generate random ones for each file; one object, one item and
// one plate need no others.
constexpr const char* kObjectId = "6f6e6767-6900-4000-8000-000000000001";
constexpr const char* kItemId = "6f6e6767-6900-4000-8000-000000000002";
constexpr const char* kBuildId = "6f6e6767-6900-4000-8000-000000000003";

}  // namespace

Result<std::vector<std::byte>> encode_3mf(const Mesh& mesh, const ThreeMfWords& words, const Image* picture) {
    if (const Result<void> good = check_mesh(mesh); !good) return good.error();
    Welded solid = welded(mesh);
    std::optional<std::vector<std::byte>> thumbnail;
    if (picture != nullptr) {
        auto png = encode_png(thumbnail_of(*picture));
        if (!png) return png.error();
        thumbnail = std::move(png).value();
    }

    Calls calls;
    Handle<NMR::PLib3MFModel> model;
    calls(NMR::lib3mf_createmodel(model.out()), "making a model");
    if (!calls.are_good()) return calls.trouble();
    calls(NMR::lib3mf_model_setunit(model.get(), NMR::MODELUNIT_MILLIMETER), "its unit");
    calls(NMR::lib3mf_model_setbuilduuidutf8(model.get(), kBuildId), "its name");
    for (const auto& [key, value] : {std::pair("Title", &words.title),
                                     {"Description", &words.description},
                                     {"Application", &words.application},
                                     {"Copyright", &words.copyright},
                                     {"LicenseTerms", &words.licence_terms},
                                     {"CreationDate", &words.creation_date}}) {
        if (!value->empty())
            calls(NMR::lib3mf_model_addmetadatautf8(model.get(), key, xml_text(*value).c_str()), key);
    }
    Handle<NMR::PLib3MFModelMeshObject> object;
    calls(NMR::lib3mf_model_addmeshobject(model.get(), object.out()), "making an object");
    if (!calls.are_good()) return calls.trouble();
    calls(NMR::lib3mf_meshobject_setgeometry(
              object.get(), solid.vertices.data(), static_cast<DWORD>(solid.vertices.size()),
              solid.triangles.data(), static_cast<DWORD>(solid.triangles.size())),
          "its triangles");
    calls(NMR::lib3mf_object_setuuidutf8(object.get(), kObjectId), "its name");
    calls(NMR::lib3mf_object_setnameutf8(object.get(), valid_utf8(words.title).c_str()), "its title");
    Handle<NMR::PLib3MFModelBuildItem> item;
    calls(NMR::lib3mf_model_addbuilditem(model.get(), object.get(), nullptr, item.out()), "putting it up");
    if (!calls.are_good()) return calls.trouble();
    calls(NMR::lib3mf_builditem_setuuidutf8(item.get(), kItemId), "its name");
    Handle<NMR::PLib3MFModelAttachment> shown;
    if (thumbnail) {
        constexpr BOOL kCreate = 1;
        calls(NMR::lib3mf_model_getpackagethumbnailattachment(model.get(), kCreate, shown.out()),
              "a picture");
        if (!calls.are_good()) return calls.trouble();
        calls(NMR::lib3mf_attachment_readfrombuffer(shown.get(), reinterpret_cast<BYTE*>(thumbnail->data()),
                                                    thumbnail->size()),
              "its pixels");
    }
    Handle<NMR::PLib3MFModelWriter> writer;
    calls(NMR::lib3mf_model_querywriter(model.get(), "3mf", writer.out()), "making a file");
    if (!calls.are_good()) return calls.trouble();
    Sink sink;
    calls(NMR::lib3mf_writer_writetocallback(writer.get(), reinterpret_cast<void*>(&write_to),
                                             reinterpret_cast<void*>(&seek_to), &sink),
          "writing");
    if (!calls.are_good()) return calls.trouble();
    std::vector<std::byte> file = with_plain_directory(sink.bytes);
    if (file.empty()) return failed("3MF: expected a ZIP file in lib3mf's form");
    return file;
}

}  // namespace onggi::asset
