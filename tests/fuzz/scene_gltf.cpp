#include "tests/fuzz/scene.h"

FUZZ_TARGET(scene_gltf) {
    static const gnomon::fuzzing::InputFile file("scene.gltf");
    return gnomon::fuzzing::read_scene(file, gnomon::fuzzing::text_of(data, size));
}
