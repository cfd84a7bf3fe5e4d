#include "runtime/scene.h"

#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using testing::error_of;
using ::testing::HasSubstr;
using testing::TemporaryFolder;
using namespace std::string_literals;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

template <typename T>
void append(std::string& bytes, T value) {
    const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    bytes.append(raw.data(), raw.size());
}

void expect_near(glm::vec3 actual, glm::vec3 expected, float tolerance = 1e-6f) {
    EXPECT_LE(glm::length(actual - expected), tolerance)
        << fmt::format("({}, {}, {}) instead of ({}, {}, {})", actual.x, actual.y, actual.z, expected.x,
                       expected.y, expected.z);
}

glm::vec3 face_normal(const Scene& scene, std::size_t triangle) {
    const glm::uvec3 t = scene.triangles[triangle];
    const glm::vec3 a = scene.positions[t.x], b = scene.positions[t.y], c = scene.positions[t.z];
    return glm::normalize(glm::cross(b - a, c - a));
}

void expect_consistent(const Scene& scene) {
    ASSERT_EQ(scene.positions.size(), scene.normals.size());
    for (const glm::uvec3 t : scene.triangles)
        for (int k = 0; k < 3; ++k) ASSERT_LT(t[k], scene.positions.size());
    for (const glm::vec3 normal : scene.normals) ASSERT_NEAR(glm::length(normal), 1.0f, 1e-5f);
}

/// An ASCII PLY file of positions.
std::string ply(int vertices, int faces, const std::string& body) {
    return fmt::format("ply\nformat ascii 1.0\ncomment test\nelement vertex {}\nproperty float x\n"
                       "property float y\nproperty float z\nelement face {}\n"
                       "property list uchar int vertex_indices\nend_header\n{}",
                       vertices, faces, body);
}

/// A binary PLY file of a quad with normals.
std::string binary_ply(float third_z = 0.0f, std::int32_t last_index = 3) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\n"
        "property float y\nproperty float z\nproperty float nx\nproperty float ny\n"
        "property float nz\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
    const glm::vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, third_z}, {0, 1, 0}};
    for (const glm::vec3 p : corners)
        for (const float value : {p.x, p.y, p.z, 0.0f, 0.0f, 2.0f}) append(bytes, value);
    for (const std::int32_t index : {0, 1, 2}) {
        if (index == 0) append(bytes, std::uint8_t{3});
        append(bytes, index);
    }
    append(bytes, std::uint8_t{3});
    for (const std::int32_t index : {0, 2, last_index}) append(bytes, index);
    return bytes;
}

/// A glTF file of one triangle without normals, (0,0,0) (1,0,0) (0,1,0), its data in the file `bin` or the
/// data chunk.
std::string gltf(const std::string& nodes, const std::string& bin, int mode = 4, bool with_normals = false) {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0{}}},"indices":1,"mode":{}}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}},
{{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}},
{{"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"}}],
"bufferViews":[{{"buffer":0,"byteLength":36}},{{"buffer":0,"byteOffset":72,"byteLength":6}},
{{"buffer":0,"byteOffset":36,"byteLength":36}}],
"buffers":[{{"byteLength":80{}}}]}})",
        nodes, with_normals ? R"(,"NORMAL":2)" : "", mode,
        bin.empty() ? "" : fmt::format(R"(,"uri":"{}")", bin));
}

std::string gltf_data(float first_x = 0.0f, glm::vec3 normal = {0, 0, 1}, std::uint16_t last_index = 2) {
    std::string bytes;
    for (const float value : {first_x, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f}) append(bytes, value);
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) append(bytes, normal[k]);
    for (const std::uint16_t index : {std::uint16_t{0}, std::uint16_t{1}, last_index}) append(bytes, index);
    append(bytes, std::uint16_t{0});
    return bytes;
}

/// Binary glTF of a text chunk, whose size is stated too large by `excess`, and a data chunk.
std::string glb(std::string text, const std::string& data, std::uint32_t excess = 0) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto text_size = static_cast<std::uint32_t>(text.size());
    const auto data_size = static_cast<std::uint32_t>(data.size());
    std::string bytes = "glTF";
    for (const std::uint32_t value : {2u, 28 + text_size + data_size, text_size + excess})
        append(bytes, value);
    bytes += "JSON" + text;
    append(bytes, data_size);
    return bytes + "BIN\0"s + data;
}

TEST(Scene, BoundsHoldEveryPosition) {
    Scene scene;
    EXPECT_GT(scene.bounds().lower.x, scene.bounds().upper.x);
    scene.positions = {{1, -2, 3}, {-4, 5, 0}};
    EXPECT_EQ(scene.bounds().lower, glm::vec3(-4, -2, 0));
    EXPECT_EQ(scene.bounds().upper, glm::vec3(1, 5, 3));
    EXPECT_EQ(scene.bounds().centre(), glm::vec3(-1.5f, 1.5f, 1.5f));
}

TEST(Scene, ObjWithoutNormalsBecomesFlat) {
    const TemporaryFolder folder;
    const Scene scene =
        load_scene(folder.write("tent.OBJ", "v -1 0 0\nv 0 1 0\nv 0 1 2\nv -1 0 2\nv 1 0 0\nv 1 0 2\n"
                                            "f 1 4 3 2\nf 2 3 6 5\n"));
    EXPECT_EQ(scene.name, "tent");
    EXPECT_EQ(scene.triangles.size(), 4u);
    EXPECT_EQ(scene.positions.size(), 12u);
    EXPECT_TRUE(scene.warnings.empty());
    expect_consistent(scene);
    for (std::size_t i = 0; i < 4; ++i) {
        const float side = i < 2 ? -1.0f : 1.0f;
        for (int k = 0; k < 3; ++k)
            expect_near(scene.normals[scene.triangles[i][k]], glm::normalize(glm::vec3(side, 1, 0)));
        expect_near(face_normal(scene, i), glm::normalize(glm::vec3(side, 1, 0)));
    }
}

TEST(Scene, PlyKeepsItsNormalsAtUnitLengthAndItsSharedVertices) {
    const TemporaryFolder folder;
    const Scene scene = load_scene(folder.write("quad.ply", binary_ply(0.5f)));
    EXPECT_EQ(scene.positions.size(), 4u);
    ASSERT_EQ(scene.triangles.size(), 2u);
    EXPECT_EQ(scene.positions[scene.triangles[0].z], glm::vec3(1, 1, 0.5f));
    for (const glm::vec3 normal : scene.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(Scene, UnusedVerticesPointsAndLinesAreLeftOut) {
    const TemporaryFolder folder;
    const Scene obj = load_scene(
        folder.write("mixed.obj", "v 9 9 9\nv 1 0 0\nv 0 1 0\nv 0 0 0\nl 1 2\np 1\nf 2 3 4\nv 77 0 0\n"));
    EXPECT_EQ(obj.triangles.size(), 1u);
    EXPECT_EQ(obj.bounds().upper, glm::vec3(1, 1, 0));
    const Scene flat =
        load_scene(folder.write("a.ply", ply(4, 2, "0 0 0\n1 0 0\n0 1 0\n9 9 9\n2 0 3\n3 0 1 2\n")));
    EXPECT_EQ(flat.triangles.size(), 1u);
    EXPECT_EQ(flat.bounds().upper, glm::vec3(1, 1, 0));
}

TEST(Scene, ZeroAreaTrianglesAreDroppedAndCounted) {
    const TemporaryFolder folder;
    const fs::path path = folder.write(
        "thin.ply", ply(4, 4, "0 0 0\n1 0 0\n0 1 0\n2 0 0\n3 0 1 3\n3 0 1 2\n3 1 1 2\n3 2 2 2\n"));
    const Scene scene = load_scene(path);
    EXPECT_EQ(scene.triangles.size(), 1u);
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_THAT(scene.warnings[0], AllOf(HasSubstr(path.string()), HasSubstr("3 triangles of zero area")));
    expect_consistent(scene);
}

TEST(Scene, VeryThinTrianglesAreKept) {
    const TemporaryFolder folder;
    const Scene scene = load_scene(folder.write("thin.ply", ply(3, 1, "0 0 0\n1 0 0\n0 1e-30 0\n3 0 1 2\n")));
    EXPECT_EQ(scene.triangles.size(), 1u);
    expect_near(scene.normals[0], {0, 0, 1});
}

TEST(Scene, MissingNormalsAreMended) {
    const TemporaryFolder folder;
    const Scene scene = load_scene(folder.write(
        "some.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\nvn 0 0 0\nf 1//1 2//1 3//1\nf 1//2 2//1 3//1\nf 3 2 1\n"));
    EXPECT_EQ(scene.triangles.size(), 3u);
    expect_consistent(scene);
    expect_near(scene.normals[scene.triangles[0].x], {1, 0, 0});
    expect_near(scene.normals[scene.triangles[1].x], {0, 0, 1});
    expect_near(scene.normals[scene.triangles[2].x], {0, 0, -1});
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_THAT(scene.warnings[0], HasSubstr("4 vertices without a normal"));
}

TEST(Scene, GltfNodesAreMovedToTheWorldAndInstancesRepeated) {
    const TemporaryFolder folder;
    folder.write("data.bin", gltf_data());
    const Scene scene = load_scene(folder.write(
        "nodes.gltf", gltf(R"({"translation":[10,0,0],"children":[1,2]},{"mesh":0,"scale":[2,3,1]},
                              {"mesh":0,"translation":[0,0,5]})",
                           "data.bin")));
    ASSERT_EQ(scene.triangles.size(), 2u);
    expect_consistent(scene);
    expect_near(scene.positions[scene.triangles[0].y], {12, 0, 0});
    expect_near(scene.positions[scene.triangles[0].z], {10, 3, 0});
    expect_near(scene.positions[scene.triangles[1].y], {11, 0, 5});
}

TEST(Scene, BinaryGltfIsRead) {
    const TemporaryFolder folder;
    const std::string text = gltf(R"({"mesh":0,"translation":[0,0,7]})", "");
    const Scene scene = load_scene(folder.write("triangle.glb", glb(text, gltf_data())));
    ASSERT_EQ(scene.triangles.size(), 1u);
    EXPECT_EQ(scene.bounds().upper, glm::vec3(1, 1, 7));
}

TEST(Scene, GltfNormalsFollowAnUnevenScale) {
    const TemporaryFolder folder;
    const glm::vec3 normal = glm::normalize(glm::vec3(1, 1, 0));
    folder.write("data.bin", gltf_data(0, normal));
    const Scene scene =
        load_scene(folder.write("scaled.gltf", gltf(R"({"mesh":0,"scale":[2,1,1]})", "data.bin", 4, true)));
    for (const glm::vec3 n : scene.normals) expect_near(n, glm::normalize(glm::vec3(0.5f, 1, 0)));
}

TEST(Scene, MirroringKeepsNormalsOutside) {
    const TemporaryFolder folder;
    folder.write("data.bin", gltf_data());
    for (const bool with_normals : {false, true}) {
        const Scene scene = load_scene(
            folder.write("mirror.gltf", gltf(R"({"mesh":0,"scale":[-1,1,1]})", "data.bin", 4, with_normals)));
        for (const glm::vec3 normal : scene.normals) expect_near(normal, {0, 0, 1});
        expect_near(face_normal(scene, 0), {0, 0, 1});
    }
}

TEST(Scene, FlatteningScaleKeepsThePlanesNormal) {
    const TemporaryFolder folder;
    folder.write("data.bin", gltf_data());
    const Scene scene =
        load_scene(folder.write("flat.gltf", gltf(R"({"mesh":0,"scale":[1,1,0]})", "data.bin", 4, true)));
    for (const glm::vec3 normal : scene.normals) expect_near(normal, {0, 0, 1});
}

TEST(Scene, BadFilesAreNamedOnOneLineAndNothingIsPrinted) {
    const TemporaryFolder folder;
    folder.write("nan.bin", gltf_data(nan));
    folder.write("index.bin", gltf_data(0, {0, 0, 1}, 9));
    folder.write("short.bin", gltf_data().substr(0, 40));
    folder.write("good.bin", gltf_data());
    const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", node = R"({"mesh":0})";
    struct Bad {
        std::string name, bytes, expected;
    };
    const Bad bad[] = {
        {"empty.obj", "", "empty"},
        {"empty.glb", "", "empty"},
        {"model.fbx", "x", "unknown kind"},
        {"model", "x", "unknown kind"},
        {"garbage.obj", "nothing of a model\nin two lines\n", "no triangles"},
        {"garbage.ply", "nothing of a model\nin two lines\n", "not a PLY"},
        {"garbage.gltf", "nothing of a model\nin two lines\n", "cannot be read"},
        {"garbage.glb", "nothing of a model\nin two lines\n", "not a binary glTF"},
        {"other.gltf", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
         "cannot be read"}, // a model, but no glTF
        {"chunk.glb", glb(gltf(node, ""), gltf_data(), 400), "chunk at byte 12"},
        {"old.glb", "glTF\1\0\0\0\0\0\0\0"s, "version 1"},
        {"truncated.gltf", R"({"asset":{"version":"2.0"},"scenes":[)", "cannot be read"},

        {"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no triangles"},
        {"lines.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\n", "no triangles"},
        {"points.ply", ply(3, 0, "0 0 0\n1 0 0\n0 1 0\n"), "no triangles"},
        {"lines.ply", ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n2 0 1\n"), "no triangles"},
        {"thin.ply", ply(3, 1, "0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"), "no triangles of more than zero area"},
        {"lines.gltf", gltf(node, "good.bin", 1), "no triangles"},

        {"nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", "line 2: vertex 2"},
        {"inf.obj", "v 0 0 0\nv 1 0 0\n\nv 0 -inf 0\nf 1 2 3\n", "line 4: vertex 3"},
        {"word.obj", "v 0 0 0\nv 1 zero 0\nv 0 1 0\nf 1 2 3\n", "line 2: y of vertex 2"},
        {"short.obj", "v 0 0 0\nv 1 0\nv 0 1 0\nf 1 2 3\n", "line 2: z of vertex 2"},
        {"far.obj", "v 0 0 0\nv 1 0 2e15\nv 0 1 0\nf 1 2 3\n", "z = 2e+15"},
        {"beyond.obj", "v 0 0 0\nv 1e999 0 0\nv 0 1 0\nf 1 2 3\n", "x = inf"},
        {"nan.ply", ply(3, 1, "0 0 0\n1 NaN 0\n0 1 0\n3 0 1 2\n"), "vertex 1 (counted from 0) has y = nan"},
        {"word.ply", ply(3, 1, "0 0 0\n1 0 0\n0 one 0\n3 0 1 2\n"), "'one' in vertex 2"},
        {"far.ply", ply(3, 1, "0 0 0\n1 0 -1e39\n0 1 0\n3 0 1 2\n"), "z = -1e+39"},
        {"nanb.ply", binary_ply(nan), "vertex 2 (counted from 0) has z = nan"},
        {"nan.gltf", gltf(node, "nan.bin"), "vertex 0"},
        {"far.gltf", gltf(R"({"mesh":0,"translation":[0,1e20,0]})", "good.bin"), "vertex 0"},

        {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "cannot be read"},
        {"zeroth.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "cannot be read"},
        {"index.ply", ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"), "face 0 (counted from 0) uses vertex 3"},
        {"minus.ply", ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), "uses vertex -1"},
        {"indexb.ply", binary_ply(0, 4), "face 1 (counted from 0) uses vertex 4"},
        {"index.gltf", gltf(node, "index.bin"), "vertex that does not exist"},

        {"lacks.ply", ply(4, 1, triangle), "vertex 3 (counted from 0) has more values"},
        {"many.ply", ply(3, 2, triangle), "ends in face 1"},
        {"half.ply", ply(3, 1, "0 0 0\n1 0 0\n0 1"), "ends in vertex 2"},
        {"claim.ply", ply(2000000000, 1, triangle), "vertex 3 (counted from 0) has more values"},
        {"return.ply", ply(4, 1, "0 0 0\n1 0 0\n1 1\r0\n0 1 0\n4 0 1 2 3\n"), "not a number"},
        {"none.ply", ply(3, 1, "0 0 0\n1 0 0\n0 1 0\n0\n"), "list of 0"},
        {"format.ply", "ply\nformat binary_middle_endian 1.0\nend_header\n", "binary_middle_endian"},
        {"header.ply", ply(3, 1, triangle).substr(0, 60), "header"},
        {"type.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\nend_header\n",
         "property quad x"},
        {"typo.ply", "ply\nformat ascii 1.0\nelemental vertex 3\nend_header\n", "elemental"},
        {"absent.gltf", gltf(node, "nowhere.bin"), "nowhere.bin"},
        {"short.gltf", gltf(node, "short.bin"), "cannot be read"},
    };
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    for (const Bad& file : bad) {
        const fs::path path = folder.write(file.name, file.bytes);
        EXPECT_THAT(error_of([&] { load_scene(path); }),
                    AllOf(HasSubstr(path.string()), HasSubstr(file.expected)));
    }
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Scene, BinaryPlyCutAnywhereIsReported) {
    const TemporaryFolder folder;
    const std::string bytes = binary_ply();
    EXPECT_EQ(load_scene(folder.write("whole.ply", bytes)).triangles.size(), 2u);
    for (std::size_t size = 1; size < bytes.size(); ++size) {
        const fs::path path = folder.write("cut.ply", bytes.substr(0, size));
        EXPECT_THAT(error_of([&] { load_scene(path); }), HasSubstr("cut.ply")) << size;
    }
}

TEST(Scene, MissingFileAndFolder) {
    const TemporaryFolder folder;
    EXPECT_THAT(error_of([&] { load_scene(folder.path() / "absent.ply"); }), HasSubstr("absent.ply"));
    fs::create_directory(folder.path() / "folder.obj");
    EXPECT_THAT(error_of([&] { load_scene(folder.path() / "folder.obj"); }),
                AllOf(HasSubstr("folder.obj"), HasSubstr("is a folder")));
}

TEST(Scene, ObjOfOtherHabitsIsRead) {
    const TemporaryFolder folder;
    const Scene scene =
        load_scene(folder.write("habits.obj", "# comment\r\nmtllib absent.mtl\r\nv 0 0 \\\r\n0\r\n"
                                              "v\t+1.0\t0\t0 1.0\r\nv 0 1 1e-400\r\nf -3 -2 -1"));
    ASSERT_EQ(scene.triangles.size(), 1u);
    EXPECT_EQ(scene.bounds().upper, glm::vec3(1, 1, 0));
}

TEST(Scene, NestingThatWouldExhaustTheStackIsRefused) {
    const TemporaryFolder folder;
    std::string deep = R"({"asset": {"version": "2.0"}, "extras": )";
    deep += std::string(100000, '[') + std::string(100000, ']') + "}";
    EXPECT_THAT(error_of([&] { load_scene(folder.write("deep.gltf", deep)); }), HasSubstr("deep.gltf"));

    const auto chain = [](int length, bool circle) {
        std::string text =
            R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)";
        for (int i = 0; i + 1 < length; ++i) text += fmt::format(R"({{"children": [{}]}},)", i + 1);
        return text + (circle ? R"({"children": [0]}]})" : "{}]}");
    };
    EXPECT_THAT(error_of([&] { load_scene(folder.write("chain.gltf", chain(30000, false))); }),
                HasSubstr("chain.gltf"));
    EXPECT_THAT(error_of([&] { load_scene(folder.write("circle.gltf", chain(3, true))); }),
                HasSubstr("circle"));
}

TEST(Scene, SparseAccessorsWithoutViewsAreRefused) {
    const TemporaryFolder folder;
    const std::string views = R"("bufferViews": [{"buffer": 0, "byteLength": 36}])";
    for (const char* sparse :
         {"{}", "7", R"({"indices": {"bufferView": 0}})", R"({"indices": 0, "values": {"bufferView": 0}})",
          R"({"indices": {"bufferView": 1}, "values": {"bufferView": 0}})",
          R"({"indices": {"bufferView": 0}, "values": {"bufferView": -1}})"})
        EXPECT_THAT(
            error_of([&] {
                load_scene(folder.write(
                    "sparse.gltf",
                    fmt::format(
                        R"({{"asset": {{"version": "2.0"}}, "accessors": [{{}}, {{"sparse": {}}}], {}}})",
                        sparse, views)));
            }),
            HasSubstr("accessor 1 (counted from 0) is sparse, and there is no buffer view for its"))
            << sparse;
}

TEST(Scene, NodesThatAreChildrenTwiceAreRefused) {
    const TemporaryFolder folder;
    // Sixty nodes, and 2^59 triangles if one follows every path.
    std::string text = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)";
    for (int i = 0; i < 59; ++i) text += fmt::format(R"({{"children": [{0}, {0}]}},)", i + 1);
    EXPECT_THAT(error_of([&] { load_scene(folder.write("doubling.gltf", text + "{}]}")); }),
                HasSubstr("node 1 (counted from 0) is a child more than once"));
    // What Assimp's JSON reader understands otherwise than ours.
    const std::string whole = text + "{}]}";
    for (const std::string& odd :
         {whole + '\0' + "x", whole + "\"\xff\"", "{\"nodes\": [{}]," + whole.substr(1)})
        EXPECT_THAT(error_of([&] { load_scene(folder.write("odd.gltf", odd)); }), HasSubstr("odd.gltf"));
    EXPECT_THAT(error_of([&] {
                    load_scene(folder.write("zero.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
                        "scenes": [{"nodes": [0]}], "nodes": [{"children": [-0]}]})"));
                }),
                HasSubstr("circle"));
}

} // namespace
} // namespace gnomon
