// See gltf.h. Any thread.
#include "engine/asset/gltf.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <sstream>

#include "engine/asset/mesh_rules.h"
#include "engine/asset/utf8.h"

namespace onggi::asset {
namespace {

// Appends the values' bytes as a new buffer view. Returns its index. GLB is little-endian, as are all
// machines this builds for. Views start at multiples of four, which covers every component type.
template <typename T>
int add_view(tinygltf::Model& model, const std::vector<T>& values, int target) {
    std::vector<unsigned char>& data = model.buffers[0].data;
    data.resize((data.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = values.size() * sizeof(T);
    if (target != 0) view.target = target;
    data.resize(data.size() + view.byteLength);
    std::memcpy(data.data() + view.byteOffset, values.data(), view.byteLength);
    model.bufferViews.push_back(std::move(view));
    return static_cast<int>(model.bufferViews.size()) - 1;
}

int add_accessor(tinygltf::Model& model, int view, int component_type, int type, std::size_t count) {
    tinygltf::Accessor accessor;
    accessor.bufferView = view;
    accessor.byteOffset = 0;
    accessor.componentType = component_type;
    accessor.type = type;
    accessor.count = count;
    model.accessors.push_back(std::move(accessor));
    return static_cast<int>(model.accessors.size()) - 1;
}

int add_vectors(tinygltf::Model& model, const std::vector<vec3>& vectors) {
    static_assert(sizeof(vec3) == 3 * sizeof(float), "written as laid out in memory");
    const int view = add_view(model, vectors, TINYGLTF_TARGET_ARRAY_BUFFER);
    return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, vectors.size());
}

template <typename Vector>
int add_attribute(tinygltf::Model& model, const std::vector<Vector>& vectors, int type) {
    const int view = add_view(model, vectors, TINYGLTF_TARGET_ARRAY_BUFFER);
    return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_FLOAT, type, vectors.size());
}

// Adds the picture as a texture of the model. Returns its index.
int add_texture(tinygltf::Model& model, const std::vector<std::byte>& file) {
    constexpr int kNoTarget = 0;
    constexpr std::byte kStartOfPng{0x89};
    if (model.samplers.empty()) {
        tinygltf::Sampler round_the_pot;
        round_the_pot.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
        round_the_pot.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
        round_the_pot.wrapS = TINYGLTF_TEXTURE_WRAP_REPEAT;
        round_the_pot.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
        model.samplers.push_back(std::move(round_the_pot));
    }
    tinygltf::Image image;
    image.bufferView = add_view(model, file, kNoTarget);
    image.mimeType = file.front() == kStartOfPng ? "image/png" : "image/jpeg";
    model.images.push_back(std::move(image));
    tinygltf::Texture texture;
    texture.sampler = 0;
    texture.source = static_cast<int>(model.images.size()) - 1;
    model.textures.push_back(std::move(texture));
    return static_cast<int>(model.textures.size()) - 1;
}

// The bounds are computed from the stored floats: glTF 2.0, section 3.6.2.5, requires them to be exact.
void set_bounds(tinygltf::Accessor& accessor, const std::vector<vec3>& vectors) {
    vec3 low(std::numeric_limits<float>::max());
    vec3 high(std::numeric_limits<float>::lowest());
    for (const vec3& v : vectors) {
        low = glm::min(low, v);
        high = glm::max(high, v);
    }
    accessor.minValues = {double{low.x}, double{low.y}, double{low.z}};
    accessor.maxValues = {double{high.x}, double{high.y}, double{high.z}};
}

int add_indices(tinygltf::Model& model, const Mesh& mesh) {
    // 65,535 itself is the primitive-restart value and no index.
    if (mesh.positions_m.size() <= std::numeric_limits<std::uint16_t>::max()) {
        const std::vector<std::uint16_t> narrow(mesh.indices.begin(), mesh.indices.end());
        const int view = add_view(model, narrow, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR,
                            narrow.size());
    }
    const int view = add_view(model, mesh.indices, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                        mesh.indices.size());
}

// Writes texture coordinates only with textures, and tangents only with a normal texture; without tangents
// viewers would compute their own.
void add_mesh(tinygltf::Model& model, const Mesh& mesh, const Textures& textures, const std::string& name) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = 0;
    const int positions = add_vectors(model, mesh.positions_m);
    set_bounds(model.accessors[static_cast<std::size_t>(positions)], mesh.positions_m);
    primitive.attributes["POSITION"] = positions;
    primitive.attributes["NORMAL"] = add_vectors(model, mesh.normals);
    if (textures.are_there())
        primitive.attributes["TEXCOORD_0"] = add_attribute(model, mesh.uvs, TINYGLTF_TYPE_VEC2);
    if (!textures.normal.empty())
        primitive.attributes["TANGENT"] = add_attribute(model, mesh.tangents, TINYGLTF_TYPE_VEC4);
    primitive.indices = add_indices(model, mesh);
    tinygltf::Mesh out;
    out.name = name;
    out.primitives.push_back(std::move(primitive));
    model.meshes.push_back(std::move(out));
}

void add_material(tinygltf::Model& model, const Material& material) {
    tinygltf::Material out;
    out.name = valid_utf8(material.name);
    const dvec3& colour = material.base_colour_linear;
    out.pbrMetallicRoughness.baseColorFactor = {colour.x, colour.y, colour.z, 1.0};
    out.pbrMetallicRoughness.roughnessFactor = material.roughness;
    out.pbrMetallicRoughness.metallicFactor = material.metallic;
    const Textures& textures = material.textures;
    if (!textures.base_colour.empty())
        out.pbrMetallicRoughness.baseColorTexture.index = add_texture(model, textures.base_colour);
    if (!textures.normal.empty()) out.normalTexture.index = add_texture(model, textures.normal);
    if (!textures.surface.empty()) {
        const int surface = add_texture(model, textures.surface);
        out.pbrMetallicRoughness.metallicRoughnessTexture.index = surface;
        out.occlusionTexture.index = surface;
    }
    if (material.clearcoat.factor > 0.0) {
        constexpr const char* kExtension = "KHR_materials_clearcoat";
        tinygltf::Value::Object coat;
        coat["clearcoatFactor"] = tinygltf::Value(material.clearcoat.factor);
        coat["clearcoatRoughnessFactor"] = tinygltf::Value(material.clearcoat.roughness);
        if (!material.textures.clearcoat.empty()) {
            tinygltf::Value::Object texture;
            texture["index"] = tinygltf::Value(add_texture(model, material.textures.clearcoat));
            coat["clearcoatTexture"] = tinygltf::Value(std::move(texture));
        }
        out.extensions[kExtension] = tinygltf::Value(std::move(coat));
        model.extensionsUsed.emplace_back(kExtension);
    }
    model.materials.push_back(std::move(out));
}

// Converts the value to JSON. Empty for NaN and infinity, which JSON cannot express (the library would write
// null).
std::optional<tinygltf::Value> json_of(const std::variant<double, std::string, std::vector<double>>& value) {
    if (const double* number = std::get_if<double>(&value)) {
        if (!std::isfinite(*number)) return std::nullopt;
        return tinygltf::Value(*number);
    }
    if (const auto* text = std::get_if<std::string>(&value)) return tinygltf::Value(valid_utf8(*text));
    tinygltf::Value::Array list;
    for (const double number : std::get<std::vector<double>>(value)) {
        if (!std::isfinite(number)) return std::nullopt;
        list.emplace_back(number);
    }
    return tinygltf::Value(std::move(list));
}

Result<void> add_extras(tinygltf::Model& model, const std::vector<Extra>& extras) {
    if (extras.empty()) return {};
    tinygltf::Value::Object fields;
    for (const auto& [name, value] : extras) {
        auto json = json_of(value);
        if (!json) return bad_input(fmt::format("glTF extras: field {}: expected finite numbers", name));
        // The library would write null (findings/tinygltf-writes-an-empty-list-as-null.sh).
        const auto* list = std::get_if<std::vector<double>>(&value);
        if (list != nullptr && list->empty()) continue;
        fields[valid_utf8(name)] = std::move(*json);
    }
    model.asset.extras = tinygltf::Value(std::move(fields));
    return {};
}

// A packet of XMP as JSON-LD: a language alternative, or a list of names, or one text.
void add_xmp(tinygltf::Model& model, const About& about) {
    using Object = tinygltf::Value::Object;
    const auto text = [](const std::string& words) { return tinygltf::Value(valid_utf8(words)); };
    Object packet;
    const auto add_alternative = [&](const char* term, const Wordings& wordings) {
        if (wordings.empty()) return;
        Object alternative{{"@type", text("rdf:Alt")}};
        for (const Wording& one : wordings) {
            Object item{{"@language", text(one.language)}, {"@value", text(one.text)}};
            alternative[fmt::format("rdf:_{}", alternative.size())] = tinygltf::Value(std::move(item));
        }
        packet[term] = tinygltf::Value(std::move(alternative));
    };
    const auto add_list = [&](const char* term, const char* kind, const std::vector<std::string>& texts) {
        tinygltf::Value::Array list;
        for (const std::string& one : texts)
            if (!one.empty()) list.push_back(text(one));
        if (!list.empty()) packet[term] = tinygltf::Value(Object{{kind, tinygltf::Value(std::move(list))}});
    };
    packet["@context"] = tinygltf::Value(Object{{"dc", text("http://purl.org/dc/elements/1.1/")},
                                                {"rdf", text("http://www.w3.org/1999/02/22-rdf-syntax-ns#")},
                                                {"xmp", text("http://ns.adobe.com/xap/1.0/")}});
    packet["@id"] = text("");
    add_alternative("dc:title", about.title);
    add_alternative("dc:description", about.description);
    add_alternative("dc:rights", about.rights);
    add_list("dc:publisher", "@set", texts_of(about.publisher));
    add_list("dc:date", "@list", {about.date});
    add_list("dc:relation", "@set", {about.relation});
    if (!about.identifier.empty()) packet["dc:identifier"] = text(about.identifier);
    if (!about.tool.empty()) packet["xmp:CreatorTool"] = text(about.tool);
    constexpr const char* kExtension = "KHR_xmp_json_ld";
    tinygltf::Value::Array packets{tinygltf::Value(std::move(packet))};
    model.extensions[kExtension] = tinygltf::Value(Object{{"packets", tinygltf::Value(std::move(packets))}});
    model.asset.extensions[kExtension] = tinygltf::Value(Object{{"packet", tinygltf::Value(0)}});
    model.extensionsUsed.emplace_back(kExtension);
}

Result<std::vector<std::byte>> write_in_memory(const tinygltf::Model& model) {
    std::ostringstream stream;
    try {
        tinygltf::TinyGLTF writer;
        constexpr bool kPretty = false;
        constexpr bool kBinary = true;
        if (!writer.WriteGltfSceneToStream(&model, stream, kPretty, kBinary) || !stream) {
            return failed("glTF: the library could not write the scene");
        }
    } catch (const std::exception& problem) {
        // Names are made valid UTF-8 before; this is for what the library's JSON writer may object to
        // besides.
        return failed(fmt::format("glTF: the library refused the scene: {}", problem.what()));
    }
    const std::string text = stream.str();
    std::vector<std::byte> bytes(text.size());
    std::memcpy(bytes.data(), text.data(), text.size());
    return bytes;
}

}  // namespace

Result<std::vector<std::byte>> encode_glb(const GltfContent& content) {
    if (const Result<void> good = check_content(content); !good) return good.error();
    const Textures& textures = content.material.textures;
    if (!textures.normal.empty() && content.mesh.tangents.empty())
        return bad_input("glTF: expected tangents where a picture is of normals, found none");

    tinygltf::Model model;
    model.asset.version = "2.0";
    model.asset.generator = valid_utf8(content.generator);
    model.asset.copyright = valid_utf8(content.about.copyright());
    if (const Result<void> good = add_extras(model, content.extras); !good) return good.error();
    if (content.about.has_rights()) add_xmp(model, content.about);

    model.buffers.emplace_back();
    const std::string name = valid_utf8(content.name);
    add_material(model, content.material);
    add_mesh(model, content.mesh, textures, name);
    tinygltf::Node node;
    node.name = name;
    node.mesh = 0;
    node.extras = model.asset.extras;
    model.nodes.push_back(std::move(node));
    tinygltf::Scene scene;
    scene.name = name;
    scene.nodes = {0};
    model.scenes.push_back(std::move(scene));
    model.defaultScene = 0;
    return write_in_memory(model);
}

}  // namespace onggi::asset
