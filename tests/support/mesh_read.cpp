// The readers of mesh_check.h, written from the formats' own descriptions. Any thread.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <map>

#include "tests/support/mesh_check.h"

namespace onggi::support {
namespace {

// Little-endian words out of bytes, with the place checked before each read.
class Bytes {
  public:
    explicit Bytes(std::span<const std::byte> bytes) : bytes_(bytes) {}

    [[nodiscard]] bool holds(std::size_t offset, std::size_t length) const {
        return offset <= bytes_.size() && length <= bytes_.size() - offset;
    }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    [[nodiscard]] std::span<const std::byte> part(std::size_t offset, std::size_t length) const {
        return bytes_.subspan(offset, length);
    }
    [[nodiscard]] std::uint32_t word(std::size_t offset, std::size_t bytes = 4) const {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i) {
            value |= std::to_integer<std::uint32_t>(bytes_[offset + i]) << (8 * i);
        }
        return value;
    }
    [[nodiscard]] dvec3 vector(std::size_t offset) const {
        const auto number = [&](std::size_t i) { return double{std::bit_cast<float>(word(offset + 4 * i))}; };
        return {number(0), number(1), number(2)};
    }

  private:
    std::span<const std::byte> bytes_;
};

bool has_negative_zero(const dvec3& v) {
    const auto bad = [](double number) { return number == 0.0 && std::signbit(number); };
    return bad(v.x) || bad(v.y) || bad(v.z);
}

constexpr std::uint32_t kGlbMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN\0"

struct Chunks {
    std::string json;
    std::span<const std::byte> binary;
};

Result<Chunks> split_glb(const Bytes& file) {
    constexpr std::size_t kHeaderBytes = 12;
    if (!file.holds(0, kHeaderBytes + 8) || file.word(0) != kGlbMagic || file.word(4) != 2) {
        return bad_input("GLB: expected the header of version 2");
    }
    if (file.word(8) != file.size()) {
        return bad_input(
            fmt::format("GLB: expected {} bytes as the header says, found {}", file.word(8), file.size()));
    }
    Chunks chunks;
    const std::size_t json_length = file.word(kHeaderBytes);
    const std::size_t json_at = kHeaderBytes + 8;
    if (file.word(kHeaderBytes + 4) != kJsonChunk || json_length % 4 != 0 ||
        !file.holds(json_at, json_length + 8)) {
        return bad_input("GLB: expected a JSON chunk of whole words, then another chunk");
    }
    const auto json_bytes = file.part(json_at, json_length);
    for (const std::byte byte : json_bytes)
        chunks.json += static_cast<char>(byte);
    const std::size_t binary_at = json_at + json_length;
    const std::size_t binary_length = file.word(binary_at);
    if (file.word(binary_at + 4) != kBinChunk || binary_length % 4 != 0 ||
        binary_at + 8 + binary_length != file.size()) {
        return bad_input("GLB: expected a BIN chunk of whole words, and nothing after it");
    }
    chunks.binary = file.part(binary_at + 8, binary_length);
    return chunks;
}

// Where an accessor's tightly packed elements lie in the binary chunk.
struct Located {
    std::size_t offset = 0;
    std::size_t count = 0;
};

Located locate(const nlohmann::json& json, const nlohmann::json& accessor, std::size_t element_bytes,
               const Bytes& binary) {
    const nlohmann::json& view = json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
    const std::size_t in_view = accessor.value("byteOffset", std::size_t{0});
    Located located{view.value("byteOffset", std::size_t{0}) + in_view,
                    accessor.at("count").get<std::size_t>()};
    const std::size_t length = located.count * element_bytes;
    if (view.contains("byteStride")) throw std::runtime_error("a stride, where tight packing is expected");
    if (located.offset % 4 != 0) throw std::runtime_error("a view that starts between words");
    if (in_view + length > view.at("byteLength").get<std::size_t>() ||
        !binary.holds(located.offset, length)) {
        throw std::runtime_error("an accessor that reaches past its data");
    }
    return located;
}

std::vector<dvec3> read_vectors(const nlohmann::json& json, std::size_t accessor_index, const Bytes& binary) {
    constexpr int kFloat = 5126;
    const nlohmann::json& accessor = json.at("accessors").at(accessor_index);
    if (accessor.at("componentType") != kFloat || accessor.at("type") != "VEC3") {
        throw std::runtime_error("an attribute that is not three floats");
    }
    constexpr std::size_t kBytes = 12;
    const Located located = locate(json, accessor, kBytes, binary);
    std::vector<dvec3> vectors;
    for (std::size_t i = 0; i < located.count; ++i)
        vectors.push_back(binary.vector(located.offset + i * kBytes));
    return vectors;
}

dvec3 read_bound(const nlohmann::json& bound) {
    return {bound.at(0).get<double>(), bound.at(1).get<double>(), bound.at(2).get<double>()};
}

void read_primitive(GlbFile& file, const Bytes& binary) {
    constexpr int kUnsignedShort = 5123;
    constexpr int kUnsignedInt = 5125;
    const nlohmann::json& json = file.json;
    if (json.at("meshes").size() != 1 || json["meshes"][0].at("primitives").size() != 1) {
        throw std::runtime_error("not just one mesh of one primitive");
    }
    const nlohmann::json& primitive = json["meshes"][0]["primitives"][0];
    if (primitive.value("mode", 4) != 4) throw std::runtime_error("something else than triangles");

    const std::size_t positions = primitive.at("attributes").at("POSITION").get<std::size_t>();
    file.mesh.positions_m = read_vectors(json, positions, binary);
    file.mesh.normals = read_vectors(json, primitive["attributes"].at("NORMAL").get<std::size_t>(), binary);
    file.stated_min_m = read_bound(json["accessors"][positions].at("min"));
    file.stated_max_m = read_bound(json["accessors"][positions].at("max"));

    const nlohmann::json& accessor = json["accessors"].at(primitive.at("indices").get<std::size_t>());
    const int type = accessor.at("componentType").get<int>();
    if (type != kUnsignedShort && type != kUnsignedInt) throw std::runtime_error("indices of a wrong type");
    file.index_bytes = type == kUnsignedShort ? 2 : 4;
    const Located located = locate(json, accessor, file.index_bytes, binary);
    for (std::size_t i = 0; i < located.count; ++i) {
        file.mesh.indices.push_back(binary.word(located.offset + i * file.index_bytes, file.index_bytes));
    }
}

}  // namespace

Result<GlbFile> read_glb(std::span<const std::byte> bytes) {
    const Result<Chunks> chunks = split_glb(Bytes(bytes));
    if (!chunks) return chunks.error();
    GlbFile file;
    try {
        file.json = nlohmann::json::parse(chunks->json);
        read_primitive(file, Bytes(chunks->binary));
    } catch (const std::exception& problem) {
        return bad_input(fmt::format("GLB: found {}", problem.what()));
    }
    for (const dvec3& position : file.mesh.positions_m) {
        if (has_negative_zero(position)) return bad_input("GLB: found a negative zero in a position");
    }
    return file;
}

Result<SolidMesh> read_stl(std::span<const std::byte> bytes) {
    constexpr std::size_t kHeaderBytes = 84;
    constexpr std::size_t kTriangleBytes = 50;
    const Bytes file(bytes);
    if (!file.holds(0, kHeaderBytes)) return bad_input("STL: expected a header of 84 bytes");
    if (std::memcmp(bytes.data(), "solid", 5) == 0) return bad_input("STL: found the start of a text file");
    const std::size_t triangles = file.word(80);
    if (file.size() != kHeaderBytes + triangles * kTriangleBytes) {
        return bad_input(fmt::format("STL: expected {} triangles in {} bytes", triangles, file.size()));
    }
    SolidMesh mesh;
    std::map<std::array<double, 6>, std::uint32_t> vertices;
    for (std::size_t t = 0; t < triangles; ++t) {
        const std::size_t at = kHeaderBytes + t * kTriangleBytes;
        const dvec3 n = file.vector(at);
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec3 p = file.vector(at + 12 * (k + 1));
            if (has_negative_zero(p)) return bad_input("STL: found a negative zero in a position");
            // 0 - y rather than -y: no negative zero of our own making.
            constexpr double kMetresPerMm = 1e-3;
            const auto number = static_cast<std::uint32_t>(vertices.size());
            const auto [entry, is_new] = vertices.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z}, number);
            if (is_new) {
                mesh.positions_m.push_back(kMetresPerMm * dvec3(p.x, p.z, 0.0 - p.y));
                mesh.normals.push_back(dvec3(n.x, n.z, 0.0 - n.y));
            }
            mesh.indices.push_back(entry->second);
        }
    }
    return mesh;
}

}  // namespace onggi::support
