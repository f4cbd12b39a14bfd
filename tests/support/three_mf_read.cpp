#include "tests/support/three_mf_read.h"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace onggi::support {
namespace {

template <typename T>
T word_at(std::span<const std::byte> bytes, std::size_t at) {
    T word{};
    if (at + sizeof word > bytes.size()) throw std::runtime_error("ZIP: cut short");
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

std::string unpacked(std::span<const std::byte> packed, std::size_t size) {
    std::string text(size, '\0');
    z_stream stream{};
    constexpr int kRawDeflate = -MAX_WBITS;
    if (inflateInit2(&stream, kRawDeflate) != Z_OK) throw std::runtime_error("ZIP: no memory");
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(text.data());
    stream.avail_out = static_cast<uInt>(text.size());
    const int result = inflate(&stream, Z_FINISH);
    inflateEnd(&stream);
    if (result != Z_STREAM_END || stream.avail_out != 0) throw std::runtime_error("ZIP: a damaged part");
    return text;
}

void check(LIB3MFRESULT result, const char* doing) {
    if (result != LIB3MF_OK) throw std::runtime_error(fmt::format("{}: {:#x}", doing, result));
}

void take_mesh(ThreeMfFile& file, NMR::PLib3MFModelMeshObject* object) {
    DWORD vertices = 0;
    DWORD triangles = 0;
    check(NMR::lib3mf_meshobject_getvertexcount(object, &vertices), "vertices");
    check(NMR::lib3mf_meshobject_gettrianglecount(object, &triangles), "triangles");
    for (DWORD i = 0; i < vertices; ++i) {
        NMR::MODELMESHVERTEX vertex;
        check(NMR::lib3mf_meshobject_getvertex(object, i, &vertex), "a vertex");
        const dvec3 mm(double{vertex.m_fPosition[0]}, double{vertex.m_fPosition[1]},
                       double{vertex.m_fPosition[2]});
        file.mesh.positions_m.push_back(1e-3 * dvec3(mm.x, mm.z, 0.0 - mm.y));
        file.mesh.normals.emplace_back(0.0);
    }
    for (DWORD i = 0; i < triangles; ++i) {
        NMR::MODELMESHTRIANGLE triangle;
        check(NMR::lib3mf_meshobject_gettriangle(object, i, &triangle), "a triangle");
        file.mesh.indices.insert(file.mesh.indices.end(), std::begin(triangle.m_nIndices),
                                 std::end(triangle.m_nIndices));
    }
    BOOL manifold = 0;
    check(NMR::lib3mf_meshobject_ismanifoldandoriented(object, &manifold), "manifold");
    file.is_manifold = manifold != 0;
}

void take_words(ThreeMfFile& file, NMR::PLib3MFModel* model) {
    DWORD count = 0;
    check(NMR::lib3mf_model_getmetadatacount(model, &count), "metadata");
    for (DWORD i = 0; i < count; ++i) {
        std::array<char, 4096> key{};
        std::array<char, 4096> value{};
        ULONG ignored = 0;
        check(NMR::lib3mf_model_getmetadatakeyutf8(model, i, key.data(), key.size(), &ignored), "a key");
        check(NMR::lib3mf_model_getmetadatavalueutf8(model, i, value.data(), value.size(), &ignored),
              "a value");
        file.words[key.data()] = value.data();
    }
}

void take_thumbnail(ThreeMfFile& file, NMR::PLib3MFModel* model) {
    NMR::PLib3MFModelAttachment* shown = nullptr;
    if (NMR::lib3mf_model_getpackagethumbnailattachment(model, 0, &shown) != LIB3MF_OK || shown == nullptr)
        return;
    ULONG64 size = 0;
    check(NMR::lib3mf_attachment_getstreamsize(shown, &size), "the thumbnail's size");
    file.thumbnail.resize(size);
    check(NMR::lib3mf_attachment_writetobuffer(shown, reinterpret_cast<BYTE*>(file.thumbnail.data()), size),
          "the thumbnail");
    NMR::lib3mf_release(shown);
}

ThreeMfFile read(NMR::PLib3MFModel* model, std::vector<std::byte> bytes) {
    NMR::PLib3MFModelReader* reader = nullptr;
    check(NMR::lib3mf_model_queryreader(model, "3mf", &reader), "a reader");
    check(NMR::lib3mf_reader_setstrictmodeactive(reader, 1), "strictness");
    check(NMR::lib3mf_reader_readfrombuffer(reader, reinterpret_cast<BYTE*>(bytes.data()), bytes.size()),
          "reading");
    DWORD warnings = 0;
    check(NMR::lib3mf_reader_getwarningcount(reader, &warnings), "warnings");
    NMR::lib3mf_release(reader);
    if (warnings > 0) throw std::runtime_error(fmt::format("{} warnings", warnings));
    ThreeMfFile file;
    DWORD unit = 0;
    check(NMR::lib3mf_model_getunit(model, &unit), "the unit");
    file.is_millimetres = unit == NMR::MODELUNIT_MILLIMETER;
    NMR::PLib3MFModelResourceIterator* objects = nullptr;
    check(NMR::lib3mf_model_getmeshobjects(model, &objects), "objects");
    BOOL is_there = 0;
    while (NMR::lib3mf_resourceiterator_movenext(objects, &is_there) == LIB3MF_OK && is_there != 0) {
        NMR::PLib3MFModelResource* object = nullptr;
        check(NMR::lib3mf_resourceiterator_getcurrent(objects, &object), "an object");
        if (++file.objects == 1) take_mesh(file, object);
        NMR::lib3mf_release(object);
    }
    NMR::lib3mf_release(objects);
    NMR::PLib3MFModelBuildItemIterator* items = nullptr;
    check(NMR::lib3mf_model_getbuilditems(model, &items), "items");
    while (NMR::lib3mf_builditemiterator_movenext(items, &is_there) == LIB3MF_OK && is_there != 0)
        ++file.items;
    NMR::lib3mf_release(items);
    take_words(file, model);
    take_thumbnail(file, model);
    return file;
}

}  // namespace

Result<ThreeMfFile> read_3mf(std::span<const std::byte> bytes) {
    NMR::PLib3MFModel* model = nullptr;
    if (NMR::lib3mf_createmodel(&model) != LIB3MF_OK) return failed("3MF: no model");
    try {
        ThreeMfFile file = read(model, {bytes.begin(), bytes.end()});
        NMR::lib3mf_release(model);
        return file;
    } catch (const std::runtime_error& trouble) {
        NMR::lib3mf_release(model);
        return bad_input(fmt::format("3MF: {}", trouble.what()));
    }
}

// APPNOTE 6.3.10, section 4.3: the directory at the end names every part. A part's own head may use ZIP64.
std::map<std::string, std::string> zip_parts(std::span<const std::byte> bytes) {
    constexpr std::uint32_t kEnd = 0x06054b50;
    constexpr std::uint32_t kEntry = 0x02014b50;
    constexpr std::size_t kEndBytes = 22;  // without a comment
    constexpr std::size_t kEntryBytes = 46;
    constexpr std::size_t kHeadBytes = 30;
    constexpr std::uint16_t kDeflated = 8;
    if (bytes.size() < kEndBytes) throw std::runtime_error("ZIP: cut short");
    const std::size_t end = bytes.size() - kEndBytes;
    if (word_at<std::uint32_t>(bytes, end) != kEnd) throw std::runtime_error("ZIP: no directory");
    std::map<std::string, std::string> parts;
    std::size_t at = word_at<std::uint32_t>(bytes, end + 16);
    for (auto left = word_at<std::uint16_t>(bytes, end + 10); left > 0; --left) {
        if (word_at<std::uint32_t>(bytes, at) != kEntry) throw std::runtime_error("ZIP: no entry");
        const auto name_bytes = word_at<std::uint16_t>(bytes, at + 28);
        const auto packed = word_at<std::uint32_t>(bytes, at + 20);
        const auto size = word_at<std::uint32_t>(bytes, at + 24);
        const auto head = word_at<std::uint32_t>(bytes, at + 42);
        const auto date = word_at<std::uint16_t>(bytes, at + 14);
        if ((date & 31U) == 0 || ((date >> 5U) & 15U) == 0 ||
            word_at<std::uint16_t>(bytes, head + 12) != date)
            throw std::runtime_error("ZIP: expected a date");
        const std::size_t data = head + kHeadBytes + word_at<std::uint16_t>(bytes, head + 26) +
                                 word_at<std::uint16_t>(bytes, head + 28);
        if (data + packed > bytes.size()) throw std::runtime_error("ZIP: cut short");
        if (word_at<std::uint16_t>(bytes, at + 10) != kDeflated)
            throw std::runtime_error("ZIP: expected a packed part");
        const std::string text = unpacked(bytes.subspan(data, packed), size);
        const auto crc =
            ::crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
        if (crc != word_at<std::uint32_t>(bytes, at + 16)) throw std::runtime_error("ZIP: a damaged part");
        parts[std::string(reinterpret_cast<const char*>(bytes.data()) + at + kEntryBytes, name_bytes)] = text;
        at += kEntryBytes + name_bytes + word_at<std::uint16_t>(bytes, at + 30) +
              word_at<std::uint16_t>(bytes, at + 32);
    }
    if (at != end) throw std::runtime_error("ZIP: expected the end behind the directory");
    return parts;
}

}  // namespace onggi::support
