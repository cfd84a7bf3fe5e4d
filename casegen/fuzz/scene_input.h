// A whole scene as an input: triangles, camera, light and settings, in words and in a file's text.
#pragma once

#include "casegen/fuzz/failure.h"
#include "runtime/pipeline/view.h"
#include "runtime/scene.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gnomon::fuzz {

/// Normals are not kept: no ray and no map asks for them. The light is directional.
struct SceneInput {
    Scene scene;
    Camera camera;
    Light light;
    ViewSettings settings; ///< width, height, shadow_map, light_fit, ray_begin; the others are the defaults
};

Input words_of(const SceneInput& scene);
/// Throws Error: too few words, an index beyond the vertices, more words than that.
SceneInput scene_of(const Input& input);

/// Numbers in hexadecimal floats, which name every bit: {"camera": {…}, "light": {…}, "settings": {…},
/// "vertices": [["0x1p+0", …], …], "triangles": [[0, 1, 2], …]}.
nlohmann::ordered_json json_of(const SceneInput& scene);
/// `name` stands for the text in messages. Throws Error naming it and the field: missing, unknown, of another
/// type; what no renderer takes (see require_valid); an index beyond the vertices, no triangles.
SceneInput scene_of(const nlohmann::ordered_json& object, const std::string& name);

} // namespace gnomon::fuzz
