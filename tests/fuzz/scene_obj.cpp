#include "tests/fuzz/scene.h"

FUZZ_TARGET(scene_obj) {
    static const gnomon::fuzzing::InputFile file("scene.obj");
    return gnomon::fuzzing::read_scene(file, gnomon::fuzzing::text_of(data, size));
}
