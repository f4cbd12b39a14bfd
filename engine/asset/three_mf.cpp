// See three_mf.h. The only file that includes lib3mf. Any thread.
#include "engine/asset/three_mf.h"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
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

// lib3mf dates its entries in month zero, which readers refuse that make a date of it. Sets the first day
// that ZIP can name, in the directory (APPNOTE 6.3.9, 4.3.12; lib3mf writes ZIP64) and before each entry's
// data.
bool date_entries(std::vector<std::byte>& zip) {
    constexpr std::uint16_t kFirstOfJanuary = (1U << 5U) | 1U;  // the year counts from 1980
    constexpr std::uint32_t kEntry = 0x02014b50;
    constexpr std::uint32_t kHead = 0x04034b50;
    constexpr std::size_t kEntryBytes = 46;
    constexpr std::size_t kEndsBytes = 20 + 22;  // the locator of the ZIP64 end record, and the older record
    if (zip.size() < kEndsBytes) return false;
    const auto end = number_at<std::uint64_t>(zip, zip.size() - kEndsBytes + 8).value_or(zip.size());
    const std::uint64_t count = number_at<std::uint64_t>(zip, end + 32).value_or(0);
    std::uint64_t at = number_at<std::uint64_t>(zip, end + 48).value_or(zip.size());
    for (std::uint64_t i = 0; i < count; ++i) {
        const std::uint64_t name = number_at<std::uint16_t>(zip, at + 28).value_or(0);
        const std::uint64_t extra = number_at<std::uint16_t>(zip, at + 30).value_or(0);
        const auto head = number_at<std::uint64_t>(zip, at + kEntryBytes + name + 20).value_or(zip.size());
        if (number_at<std::uint32_t>(zip, at) != kEntry || number_at<std::uint32_t>(zip, head) != kHead)
            return false;
        std::memcpy(zip.data() + at + 14, &kFirstOfJanuary, sizeof kFirstOfJanuary);
        std::memcpy(zip.data() + head + 12, &kFirstOfJanuary, sizeof kFirstOfJanuary);
        at += kEntryBytes + name + extra;
    }
    return count > 0;
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
    if (!date_entries(sink.bytes)) return failed("3MF: expected a ZIP file in lib3mf's form");
    return std::move(sink.bytes);
}

}  // namespace onggi::asset
