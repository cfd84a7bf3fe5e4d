#include "casegen/fuzz/scene_input.h"

#include "casegen/csv.h"
#include "runtime/error.h"
#include "runtime/one_line.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <initializer_list>

namespace gnomon::fuzz {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array fit_names{"seen box", "camera frustum", "visible points"};
constexpr std::array fits{LightFit::seen_box, LightFit::camera_frustum, LightFit::visible_points};
constexpr int most_texels = 4096; ///< on a side of image and map: a regression is small
constexpr std::size_t most_corners = std::size_t{1} << 20;

/// Goes through all that a scene is made of in one order, whoever asks: `float_at(float&)`,
/// `whole_at(std::uint32_t&)`.
template <typename Float, typename Whole>
void visit(SceneInput& s, const Float& float_at, const Whole& whole_at) {
    for (glm::vec3* v : {&s.camera.position, &s.camera.direction, &s.light.direction})
        for (int axis = 0; axis < 3; ++axis) float_at((*v)[axis]);
    for (float* f : {&s.camera.fov, &s.camera.near, &s.camera.far, &s.settings.ray_begin}) float_at(*f);
    for (int* i : {&s.settings.width, &s.settings.height, &s.settings.shadow_map}) {
        auto word = static_cast<std::uint32_t>(*i);
        whole_at(word);
        *i = static_cast<int>(word);
    }
    auto fit = static_cast<std::uint32_t>(std::ranges::find(fits, s.settings.light_fit) - fits.begin());
    whole_at(fit);
    s.settings.light_fit = fits.at(fit);
    auto vertices = static_cast<std::uint32_t>(s.scene.positions.size());
    whole_at(vertices);
    if (vertices > most_corners) throw Error("a scene of {} vertices", vertices);
    s.scene.positions.resize(vertices);
    for (glm::vec3& position : s.scene.positions)
        for (int axis = 0; axis < 3; ++axis) float_at(position[axis]);
    auto triangles = static_cast<std::uint32_t>(s.scene.triangles.size());
    whole_at(triangles);
    if (triangles > most_corners) throw Error("a scene of {} triangles", triangles);
    s.scene.triangles.resize(triangles);
    for (glm::uvec3& triangle : s.scene.triangles)
        for (int corner = 0; corner < 3; ++corner) whole_at(triangle[corner]);
}

void finish(SceneInput& s, const std::string& name) {
    s.scene.name = "fuzzed";
    s.scene.normals.assign(s.scene.positions.size(), glm::vec3(0, 1, 0));
    for (const glm::uvec3& triangle : s.scene.triangles)
        for (int corner = 0; corner < 3; ++corner)
            if (triangle[corner] >= s.scene.positions.size())
                throw Error("{}: a triangle names vertex {} of {}", name, triangle[corner],
                            s.scene.positions.size());
}

Json json_of(glm::vec3 v) {
    Json list = Json::array();
    for (int axis = 0; axis < 3; ++axis)
        list.push_back(format_word(Scalar::float32, std::bit_cast<std::uint32_t>(v[axis])));
    return list;
}
std::string text_of(float value) { return format_word(Scalar::float32, std::bit_cast<std::uint32_t>(value)); }

/// An object whose fields are these and no others.
const Json& object_at(const Json& parent, const char* field, std::initializer_list<const char*> fields,
                      const std::string& name) {
    if (!parent.contains(field) || !parent.at(field).is_object())
        throw Error("{}: has no \"{}\"", name, field);
    const Json& object = parent.at(field);
    for (const auto& [key, value] : object.items())
        if (std::ranges::none_of(fields, [&k = key](const char* known) { return k == known; }))
            throw Error("{}: unknown field \"{}\" in \"{}\"", name, one_line(key), field);
    for (const char* each : fields)
        if (!object.contains(each)) throw Error("{}: has no \"{}\" in \"{}\"", name, each, field);
    return object;
}

float float_of(const Json& value, const std::string& place) {
    if (!value.is_string()) throw Error("{}: not a text as \"0x1.8p+0\"", place);
    return std::bit_cast<float>(parse_word(Scalar::float32, value.get<std::string>(), place));
}
std::uint32_t whole_of(const Json& value, std::uint32_t most, const std::string& place) {
    if (!value.is_number_integer() || value.get<std::int64_t>() < 0 || value.get<std::int64_t>() > most)
        throw Error("{}: not a whole number from 0 to {}", place, most);
    return value.get<std::uint32_t>();
}
const Json& three_at(const Json& value, const std::string& place) {
    if (!value.is_array() || value.size() != 3) throw Error("{}: not three numbers in []", place);
    return value;
}
glm::vec3 vector_of(const Json& value, const std::string& place) {
    const Json& three = three_at(value, place);
    return {float_of(three[0], place), float_of(three[1], place), float_of(three[2], place)};
}
const Json& list_at(const Json& object, const char* field, const std::string& name) {
    if (!object.contains(field) || !object.at(field).is_array() || object.at(field).size() > most_corners)
        throw Error("{}: has no list \"{}\"", name, field);
    return object.at(field);
}

} // namespace

Input words_of(const SceneInput& scene) {
    SceneInput copy = scene;
    Input input;
    visit(
        copy, [&](float& value) { input.words.push_back(std::bit_cast<std::uint32_t>(value)); },
        [&](std::uint32_t& word) { input.words.push_back(word); });
    return input;
}

SceneInput scene_of(const Input& input) {
    SceneInput scene;
    std::size_t at = 0;
    const auto next = [&] {
        if (at >= input.words.size()) throw Error("a scene of too few words");
        return input.words[at++];
    };
    visit(
        scene, [&](float& value) { value = std::bit_cast<float>(next()); },
        [&](std::uint32_t& word) { word = next(); });
    if (at != input.words.size()) throw Error("a scene of too many words");
    finish(scene, "a scene");
    return scene;
}

Json json_of(const SceneInput& s) {
    Json vertices = Json::array(), triangles = Json::array();
    for (const glm::vec3& position : s.scene.positions) vertices.push_back(json_of(position));
    for (const glm::uvec3& t : s.scene.triangles) triangles.push_back({t.x, t.y, t.z});
    const auto fit = static_cast<std::size_t>(std::ranges::find(fits, s.settings.light_fit) - fits.begin());
    return {{"camera",
             {{"position", json_of(s.camera.position)},
              {"direction", json_of(s.camera.direction)},
              {"fov", text_of(s.camera.fov)},
              {"near", text_of(s.camera.near)},
              {"far", text_of(s.camera.far)}}},
            {"light", {{"direction", json_of(s.light.direction)}}},
            {"settings",
             {{"width", s.settings.width},
              {"height", s.settings.height},
              {"shadow_map", s.settings.shadow_map},
              {"light_fit", fit_names.at(fit)},
              {"ray_begin", text_of(s.settings.ray_begin)}}},
            {"vertices", vertices},
            {"triangles", triangles}};
}

SceneInput scene_of(const Json& object, const std::string& name) {
    for (const auto& [key, value] : object.items())
        if (key != "camera" && key != "light" && key != "settings" && key != "vertices" && key != "triangles")
            throw Error("{}: unknown field \"{}\"", name, one_line(key));
    SceneInput s;
    const Json& camera = object_at(object, "camera", {"position", "direction", "fov", "near", "far"}, name);
    s.camera.position = vector_of(camera.at("position"), name + ", camera, position");
    s.camera.direction = vector_of(camera.at("direction"), name + ", camera, direction");
    s.camera.fov = float_of(camera.at("fov"), name + ", camera, fov");
    s.camera.near = float_of(camera.at("near"), name + ", camera, near");
    s.camera.far = float_of(camera.at("far"), name + ", camera, far");
    const Json& light = object_at(object, "light", {"direction"}, name);
    s.light.direction = vector_of(light.at("direction"), name + ", light, direction");
    const Json& settings =
        object_at(object, "settings", {"width", "height", "shadow_map", "light_fit", "ray_begin"}, name);
    s.settings.width = static_cast<int>(whole_of(settings.at("width"), most_texels, name + ", width"));
    s.settings.height = static_cast<int>(whole_of(settings.at("height"), most_texels, name + ", height"));
    s.settings.shadow_map =
        static_cast<int>(whole_of(settings.at("shadow_map"), most_texels, name + ", shadow_map"));
    s.settings.ray_begin = float_of(settings.at("ray_begin"), name + ", ray_begin");
    const auto fit =
        std::ranges::find_if(fit_names, [&](const char* known) { return settings.at("light_fit") == known; });
    if (fit == fit_names.end()) throw Error("{}: no \"light_fit\" of this name", name);
    s.settings.light_fit = fits.at(static_cast<std::size_t>(fit - fit_names.begin()));
    for (const Json& vertex : list_at(object, "vertices", name))
        s.scene.positions.push_back(
            vector_of(vertex, fmt::format("{}, vertex {}", name, s.scene.positions.size())));
    for (const Json& triangle : list_at(object, "triangles", name)) {
        const std::string place = fmt::format("{}, triangle {}", name, s.scene.triangles.size());
        const Json& three = three_at(triangle, place);
        constexpr std::uint32_t most = most_corners;
        s.scene.triangles.emplace_back(whole_of(three[0], most, place), whole_of(three[1], most, place),
                                       whole_of(three[2], most, place));
    }
    if (s.scene.triangles.empty()) throw Error("{}: a scene without triangles", name);
    for (const glm::vec3& position : s.scene.positions)
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(position[axis]) <= 1e15f)) throw Error("{}: a vertex that is no place", name);
    finish(s, name);
    try {
        require_valid(s.camera, s.light, s.settings);
    } catch (const Error& error) {
        throw Error("{}: {}", name, error.what());
    }
    return s;
}

} // namespace gnomon::fuzz
