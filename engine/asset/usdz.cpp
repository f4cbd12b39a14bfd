// See usdz.h. Any thread.
#include "engine/asset/usdz.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "engine/asset/mesh_rules.h"
#include "engine/asset/utf8.h"
#include "engine/core/little_endian.h"

namespace onggi::asset {
namespace {

using Bytes = std::vector<std::byte>;
using little_endian::put;

// A ZIP file without compression (PKWARE APPNOTE 6.3.9): every file begins at a multiple of 64 bytes, behind
// an extra field that fills the gap.
class StoredZip {
  public:
    void add(std::string_view name, const Bytes& content) {
        constexpr std::size_t kAlignment = 64;
        constexpr std::size_t kHeadBytes = 30;
        constexpr std::size_t kFieldHeadBytes = 4;
        constexpr std::uint16_t kPadding = 0x1986;  // the field that Pixar's own writer uses
        const auto at = static_cast<std::uint32_t>(bytes_.size());
        const std::size_t begin = at + kHeadBytes + name.size() + kFieldHeadBytes;
        const std::size_t gap = (kAlignment - begin % kAlignment) % kAlignment;
        const auto size = static_cast<std::uint32_t>(content.size());
        const auto crc =
            static_cast<std::uint32_t>(::crc32(0, reinterpret_cast<const Bytef*>(content.data()), size));
        put(bytes_, std::uint32_t{0x04034b50});
        put_common(bytes_, name, crc, size, static_cast<std::uint16_t>(kFieldHeadBytes + gap));
        put_text(bytes_, name);
        put(bytes_, kPadding);
        put(bytes_, static_cast<std::uint16_t>(gap));
        bytes_.resize(bytes_.size() + gap);
        bytes_.insert(bytes_.end(), content.begin(), content.end());
        put(directory_, std::uint32_t{0x02014b50});
        put(directory_, std::uint16_t{10});  // made by: version 1.0
        put_common(directory_, name, crc, size, 0);
        put(directory_, std::uint16_t{0});  // comment
        put(directory_, std::uint16_t{0});  // disk
        put(directory_, std::uint16_t{0});  // attributes
        put(directory_, std::uint32_t{0});
        put(directory_, at);
        put_text(directory_, name);
        ++count_;
    }
    [[nodiscard]] Bytes whole() && {
        const auto at = static_cast<std::uint32_t>(bytes_.size());
        bytes_.insert(bytes_.end(), directory_.begin(), directory_.end());
        put(bytes_, std::uint32_t{0x06054b50});
        put(bytes_, std::uint32_t{0});  // disks
        put(bytes_, count_);
        put(bytes_, count_);
        put(bytes_, static_cast<std::uint32_t>(directory_.size()));
        put(bytes_, at);
        put(bytes_, std::uint16_t{0});  // comment
        return std::move(bytes_);
    }

  private:
    static void put_text(Bytes& bytes, std::string_view text) {
        for (const char letter : text)
            bytes.push_back(static_cast<std::byte>(letter));
    }
    // What a file's head and its entry in the directory have in common.
    static void put_common(Bytes& bytes, std::string_view name, std::uint32_t crc, std::uint32_t size,
                           std::uint16_t extra) {
        constexpr std::uint16_t kFirstOfJanuary = (1U << 5U) | 1U;  // the year counts from 1980
        put(bytes, std::uint16_t{10});                              // needs version 1.0
        put(bytes, std::uint16_t{0});                               // flags
        put(bytes, std::uint16_t{0});                               // stored
        put(bytes, std::uint16_t{0});                               // midnight
        put(bytes, kFirstOfJanuary);
        put(bytes, crc);
        put(bytes, size);
        put(bytes, size);
        put(bytes, static_cast<std::uint16_t>(name.size()));
        put(bytes, extra);
    }

    Bytes bytes_;
    Bytes directory_;
    std::uint16_t count_ = 0;
};

std::string quoted(std::string_view text) {
    std::string out = "\"";
    for (const char letter : valid_utf8(text)) {
        if (letter == '"' || letter == '\\') out += '\\';
        const auto byte = static_cast<unsigned char>(letter);
        out += byte < 0x20 || byte == 0x7f ? ' ' : letter;
    }
    return out + '"';
}

// "[(1, 2, 3), (4, 5, 6)]". Six digits are a tenth of a micrometre of a pot.
template <int kCount, typename Vector>
std::string tuples(const std::vector<Vector>& vectors) {
    std::string out = "[";
    for (const Vector& vector : vectors) {
        out += out.size() == 1 ? "(" : ", (";
        for (int i = 0; i < kCount; ++i)
            fmt::format_to(std::back_inserter(out), "{}{:.6g}", i == 0 ? "" : ", ", vector[i] + 0.0F);
        out += ')';
    }
    return out + ']';
}

struct UsdPicture {
    std::string name;  // of the shader
    const Bytes* file;
    const char* colour_space;
    dvec3 scale{1.0};
    bool is_of_normals = false;  // counts from -1 to 1

    [[nodiscard]] std::string file_name() const {
        constexpr std::byte kStartOfPng{0x89};
        return name + (file->front() == kStartOfPng ? ".png" : ".jpg");
    }
};

std::vector<UsdPicture> pictures_of(const Material& material) {
    const Textures& textures = material.textures;
    std::vector<UsdPicture> pictures;
    const auto add = [&](UsdPicture picture) {
        if (!picture.file->empty()) pictures.push_back(std::move(picture));
    };
    add({"colour", &textures.base_colour, "sRGB", material.base_colour_linear});
    add({.name = "normals", .file = &textures.normal, .colour_space = "raw", .is_of_normals = true});
    add({"surface", &textures.surface, "raw", {1.0, material.roughness, material.metallic}});
    add({"coat", &textures.clearcoat, "raw", {material.clearcoat.factor, 1.0, 1.0}});
    return pictures;
}

std::string shader_of(const UsdPicture& picture) {
    const auto vector = [&](double x, double y, double z, int w) {
        return fmt::format("({:.6g}, {:.6g}, {:.6g}, {})", x, y, z, w);
    };
    const dvec3& scale = picture.scale;
    return fmt::format(R"(
        def Shader "{}"
        {{
            uniform token info:id = "UsdUVTexture"
            asset inputs:file = @{}@
            float4 inputs:bias = {}
            float4 inputs:scale = {}
            token inputs:sourceColorSpace = "{}"
            float2 inputs:st.connect = </Pot/Material/places.outputs:result>
            token inputs:wrapS = "repeat"
            token inputs:wrapT = "clamp"
            float outputs:r
            float outputs:g
            float outputs:b
            float3 outputs:rgb
        }}
)",
                       picture.name, picture.file_name(),
                       picture.is_of_normals ? vector(-1, -1, -1, 0) : vector(0, 0, 0, 0),
                       picture.is_of_normals ? vector(2, 2, 2, 1) : vector(scale.x, scale.y, scale.z, 1),
                       picture.colour_space);
}

std::string material_text(const Material& material, const std::vector<UsdPicture>& pictures) {
    const Textures& textures = material.textures;
    const dvec3& colour = material.base_colour_linear;
    std::string inputs;
    const auto add = [&](const char* input, bool is_pictured, const char* picture, const std::string& value) {
        if (is_pictured) {
            inputs += fmt::format("\n            {}.connect = </Pot/Material/{}>", input, picture);
        } else if (!value.empty()) {
            inputs += fmt::format("\n            {} = {}", input, value);
        }
    };
    const bool has_surface = !textures.surface.empty();
    const bool is_coated = material.clearcoat.factor > 0.0;
    const auto number = [](double value) { return fmt::format("{:.6g}", value); };
    add("color3f inputs:diffuseColor", !textures.base_colour.empty(), "colour.outputs:rgb",
        fmt::format("({:.6g}, {:.6g}, {:.6g})", colour.x, colour.y, colour.z));
    add("normal3f inputs:normal", !textures.normal.empty(), "normals.outputs:rgb", "");
    add("float inputs:occlusion", has_surface, "surface.outputs:r", "");
    add("float inputs:roughness", has_surface, "surface.outputs:g", number(material.roughness));
    add("float inputs:metallic", has_surface, "surface.outputs:b", number(material.metallic));
    add("float inputs:clearcoat", is_coated && !textures.clearcoat.empty(), "coat.outputs:r",
        is_coated ? number(material.clearcoat.factor) : "");
    add("float inputs:clearcoatRoughness", false, "", is_coated ? number(material.clearcoat.roughness) : "");
    std::string shaders;
    for (const UsdPicture& picture : pictures)
        shaders += shader_of(picture);
    return fmt::format(R"(
    def Material "Material"
    {{
        token outputs:surface.connect = </Pot/Material/look.outputs:surface>

        def Shader "look"
        {{
            uniform token info:id = "UsdPreviewSurface"{}
            token outputs:surface
        }}

        def Shader "places"
        {{
            uniform token info:id = "UsdPrimvarReader_float2"
            string inputs:varname = "st"
            float2 outputs:result
        }}
{}    }}
)",
                       inputs, shaders);
}

std::string mesh_text(const Mesh& mesh) {
    vec3 low(std::numeric_limits<float>::max());
    vec3 high(std::numeric_limits<float>::lowest());
    for (const vec3& place : mesh.positions_m) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    std::vector<vec2> places;  // v upwards
    for (const vec2& uv : mesh.uvs)
        places.emplace_back(uv.x, 1.0F - uv.y);
    const std::string uvs =
        places.empty() ? ""
                       : fmt::format(
                             "\n        texCoord2f[] primvars:st = {} (\n            interpolation = "
                             "\"vertex\"\n        )",
                             tuples<2>(places));
    return fmt::format(
        R"(
    def Mesh "Shape" (
        prepend apiSchemas = ["MaterialBindingAPI"]
    )
    {{
        float3[] extent = {}
        int[] faceVertexCounts = [{}]
        int[] faceVertexIndices = [{}]
        normal3f[] normals = {} (
            interpolation = "vertex"
        )
        point3f[] points = {}{}
        rel material:binding = </Pot/Material>
        uniform token subdivisionScheme = "none"
    }}
)",
        tuples<3>(std::vector<vec3>{low, high}), fmt::join(std::vector<int>(mesh.triangle_count(), 3), ", "),
        fmt::join(mesh.indices, ", "), tuples<3>(mesh.normals), tuples<3>(mesh.positions_m), uvs);
}

// What the file says: Dublin Core's terms in each language, and the extras' numbers and texts.
std::string custom_data(const GltfContent& content) {
    std::string data;
    const auto add = [&](const std::string& kind, std::string_view key, const std::string& value) {
        data += fmt::format("        {} {} = {}\n", kind, quoted(key), value);
    };
    const auto add_text = [&](std::string_view key, const std::string& text) {
        if (!text.empty()) add("string", key, quoted(text));
    };
    const auto add_wordings = [&](const char* term, const Wordings& wordings) {
        add_text(term, first_of(wordings));
        for (const Wording& one : wordings)
            add_text(fmt::format("{}-{}", term, one.language), one.text);
    };
    const About& about = content.about;
    add_text("creator", content.generator);
    add_text("copyright", about.copyright());
    add_wordings("title", about.title);
    add_wordings("description", about.description);
    add_wordings("rights", about.rights);
    add_wordings("publisher", about.publisher);
    for (const auto& [term, text] :
         {std::pair("date", &about.date), {"identifier", &about.identifier}, {"relation", &about.relation}})
        add_text(term, *text);
    for (const auto& [name, value] : content.extras) {
        if (const double* number = std::get_if<double>(&value)) {
            if (!std::isfinite(*number)) continue;
            add("double", "onggi-" + name, fmt::format("{}", *number));
        } else if (const auto* text = std::get_if<std::string>(&value)) {
            add_text("onggi-" + name, *text);
        }
    }
    return data;
}

}  // namespace

Result<std::vector<std::byte>> encode_usdz(const GltfContent& content) {
    if (const Result<void> good = check_content(content); !good) return good.error();
    const std::vector<UsdPicture> pictures = pictures_of(content.material);
    const std::string text = fmt::format(R"(#usda 1.0
(
    customLayerData = {{
{}    }}
    defaultPrim = "Pot"
    doc = {}
    metersPerUnit = 1
    upAxis = "Y"
)

def Xform "Pot" (
    assetInfo = {{
        string name = {}
    }}
    kind = "component"
)
{{{}{}}}
)",
                                         custom_data(content), quoted(content.name), quoted(content.name),
                                         mesh_text(content.mesh), material_text(content.material, pictures));
    const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
    StoredZip zip;
    zip.add("pot.usda", {bytes.begin(), bytes.end()});
    for (const UsdPicture& picture : pictures)
        zip.add(picture.file_name(), *picture.file);
    return std::move(zip).whole();
}

}  // namespace onggi::asset
