#include "tests/fuzz/scene.h"

FUZZ_TARGET(scene_ply) {
    static const gnomon::fuzzing::InputFile file("scene.ply");
    return gnomon::fuzzing::read_scene(file, gnomon::fuzzing::text_of(data, size));
}
