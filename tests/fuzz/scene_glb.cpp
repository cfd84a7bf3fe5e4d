#include "tests/fuzz/scene.h"

FUZZ_TARGET(scene_glb) {
    static const gnomon::fuzzing::InputFile file("scene.glb");
    return gnomon::fuzzing::read_scene(file, gnomon::fuzzing::text_of(data, size));
}
