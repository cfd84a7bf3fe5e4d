// gnomon render.
#include "runtime/files.h"
#include "runtime/image.h"
#include "tests/pipeline/cli.h"
#include "tests/support/environment.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace gnomon::testing {
namespace {

using ::testing::HasSubstr;

const Arguments small{"--size", "160x120", "--shadow-map", "128", "--frames", "1"};

std::size_t count(const Image& image, Rgb colour) {
    return static_cast<std::size_t>(std::ranges::count(image.pixels, colour));
}

TEST(Render, ReportsWhatItsPicturesShow) {
    const TemporaryFolder folder;
    const std::string report = folder.path() / "report.json", image = folder.path() / "image.png",
                      errors = folder.path() / "errors.png";
    const Ran ran =
        run_well(Arguments{"render", "--report", report, "--image", image, "--errors", errors} + small);
    EXPECT_THAT(ran.out, HasSubstr("smsr"));
    EXPECT_THAT(ran.out, HasSubstr("face the light"));

    const nlohmann::json json = read_json(report);
    EXPECT_EQ(json["scene"], "demo");
    EXPECT_EQ(json["technique"], "smsr");
    EXPECT_EQ(json["frames"], 1);
    EXPECT_EQ(json["view"]["size"], (std::vector{160, 120}));
    EXPECT_EQ(json["view"]["shadow_map"], 128);
    EXPECT_EQ(json["view"]["receiver"], "plane");
    EXPECT_EQ(json["view"]["camera"]["position"].size(), 3u);
    for (const char* step : {"g-buffer", "receivers", "shadow map", "visibility", "shade"}) {
        ASSERT_TRUE(json["milliseconds"].contains(step)) << step;
        EXPECT_GT(json["milliseconds"][step].get<double>(), 0) << step;
    }
    EXPECT_DOUBLE_EQ(json["visibility_milliseconds"].get<double>(),
                     json["milliseconds"]["shadow map"].get<double>() +
                         json["milliseconds"]["visibility"].get<double>());

    const nlohmann::json pixels = json["pixels"];
    const auto number = [&](const char* name) { return pixels.at(name).get<std::size_t>(); };
    EXPECT_EQ(number("all"), 160u * 120u);
    EXPECT_EQ(number("covered"), number("facing_light") + number("facing_away"));
    EXPECT_EQ(number("facing_light"), number("lit_by_truth") + number("shadowed_by_truth"));
    EXPECT_NEAR(pixels["wrong_share_of_facing"].get<double>(),
                static_cast<double>(number("wrong_lit") + number("wrong_shadowed")) /
                    static_cast<double>(number("facing_light")),
                1e-12);
    EXPECT_GT(number("wrong_shadowed"), 0u);

    const Image picture = read_png(image), wrong = read_png(errors);
    for (const Image& each : {picture, wrong}) {
        EXPECT_EQ(each.width, 160);
        EXPECT_EQ(each.height, 120);
    }
    EXPECT_EQ(count(wrong, {255, 255, 255}), number("all") - number("covered"));
    EXPECT_EQ(count(wrong, {92, 104, 120}), number("facing_away"));
    EXPECT_EQ(count(wrong, {230, 30, 30}), number("wrong_lit"));
    EXPECT_EQ(count(wrong, {30, 90, 240}), number("wrong_shadowed"));
    EXPECT_EQ(count(wrong, {208, 208, 208}), number("lit_by_truth") - number("wrong_shadowed"));
    EXPECT_EQ(count(wrong, {72, 72, 72}), number("shadowed_by_truth") - number("wrong_lit"));
}

TEST(Render, EveryTechnique) {
    const TemporaryFolder folder;
    nlohmann::json pixels;
    for (const std::string technique : {"none", "nsm", "smsr", "raytraced"}) {
        const std::string report = folder.path() / (technique + ".json");
        run_well(Arguments{"render", "--technique", technique, "--report", report} + small);
        const nlohmann::json json = read_json(report);
        EXPECT_EQ(json["technique"], technique);
        pixels[technique] = json["pixels"];
        // What is true does not depend on who is judged.
        for (const char* same :
             {"covered", "facing_light", "facing_away", "lit_by_truth", "shadowed_by_truth"})
            EXPECT_EQ(pixels[technique][same], pixels["none"][same]) << technique << ' ' << same;
    }
    EXPECT_EQ(pixels["none"]["wrong_lit"], pixels["none"]["shadowed_by_truth"]);
    EXPECT_EQ(pixels["none"]["wrong_shadowed"], 0);
    EXPECT_EQ(pixels["raytraced"]["wrong_lit"], 0);
    EXPECT_EQ(pixels["raytraced"]["wrong_shadowed"], 0);
    EXPECT_LT(pixels["smsr"]["wrong_lit"], pixels["nsm"]["wrong_lit"]);
    EXPECT_GT(pixels["smsr"]["wrong_shadowed"], pixels["nsm"]["wrong_shadowed"]);
}

TEST(Render, TheSameTwice) {
    const TemporaryFolder folder;
    for (const Arguments& light :
         {Arguments{}, Arguments{"--light-position", "2,5,3", "--receiver", "depth", "--bias", "0.05"}}) {
        std::vector<std::string> images, errors;
        std::vector<nlohmann::json> pixels;
        for (const std::string run : {"1", "2"}) {
            const std::string report = folder.path() / (run + ".json"),
                              image = folder.path() / (run + ".png"),
                              wrong = folder.path() / (run + "_errors.png");
            run_well(Arguments{"render", "--report", report, "--image", image, "--errors", wrong} + light +
                     small);
            images.push_back(read_file(image));
            errors.push_back(read_file(wrong));
            pixels.push_back(read_json(report)["pixels"]);
        }
        EXPECT_EQ(images[0], images[1]);
        EXPECT_EQ(errors[0], errors[1]);
        EXPECT_EQ(pixels[0], pixels[1]);
    }
}

TEST(Render, TakesTheViewItIsGiven) {
    const TemporaryFolder folder;
    const std::string report = folder.path() / "r.json";
    run_well({"render",    "--report",
              report,      "--camera-position",
              "1,2,7",     "--camera-direction",
              "0,-0.2,-1", "--fov",
              "33",        "--near",
              "0.5",       "--far",
              "40",        "--light-position",
              "1,6,2",     "--light-direction",
              "0,-1,0.1",  "--light-fov",
              "75",        "--size",
              "80x60",     "--shadow-map",
              "64",        "--frames",
              "2",         "--bias",
              "0.01",      "--receiver",
              "depth"});
    const nlohmann::json json = read_json(report), view = json["view"];
    EXPECT_EQ(view["camera"]["position"], (std::vector{1, 2, 7}));
    EXPECT_EQ(view["camera"]["fov_degrees_vertical"], 33);
    EXPECT_EQ(view["camera"]["near"], 0.5);
    EXPECT_EQ(view["camera"]["far"], 40);
    EXPECT_EQ(view["light"]["position"], (std::vector{1, 6, 2}));
    EXPECT_EQ(view["light"]["fov_degrees"], 75);
    EXPECT_EQ(view["receiver"], "depth");
    EXPECT_NEAR(view["bias"].get<double>(), 0.01, 1e-9);
    EXPECT_EQ(json["frames"], 2);
    EXPECT_GT(json["pixels"]["covered"], 1000);
}

TEST(Render, ExplainsWhatLeavingCasesOutIsWorth) {
    const TemporaryFolder folder;
    const std::string report = folder.path() / "r.json";
    // Without slots and bars nobody searches for breaches: what is left is much less.
    const Ran ran = run_well(Arguments{"render", fixtures_folder() / "scenes/box.obj", "--technique", "rsmss",
                                       "--explain", "--assembly", "scene", "--report", report} +
                             small);
    for (const char* what : {"rsmss/case_12", "held", "left out", "instructions", "GLSL to SPIR-V", "driver",
                             "visibility", "the same, bit for bit"})
        EXPECT_THAT(ran.out, HasSubstr(what));
    const nlohmann::json json = read_json(report), explanation = json["explanation"];
    EXPECT_EQ(json["assembly"], "scene");
    EXPECT_EQ(explanation["pixels_differing"], 0);
    EXPECT_EQ(explanation["pixels_left_out"], 0);
    EXPECT_EQ(explanation["held"].size() + explanation["left_out"].size(), 31u);
    const double all = explanation["instructions"]["all"], reduced = explanation["instructions"]["reduced"];
    EXPECT_GT(reduced, 100);
    EXPECT_LT(reduced, 0.75 * all);
    EXPECT_GT(explanation["left_out"].size(), 10u);
    EXPECT_THAT(ran.out, HasSubstr("facts breach"));
    for (const char* time : {"compiler_milliseconds", "driver_milliseconds", "visibility_milliseconds"})
        EXPECT_GT(explanation[time]["all"].get<double>(), 0) << time;
}

TEST(Render, OfAViewsOwnCasesIsTheSamePicture) {
    const TemporaryFolder folder;
    const std::string full = folder.path() / "full.png", scene = folder.path() / "scene.png";
    run_well(Arguments{"render", "--image", full} + small);
    run_well(Arguments{"render", "--image", scene, "--assembly", "scene"} + small);
    EXPECT_EQ(read_file(full), read_file(scene));
}

TEST(Render, SaysThatItSeesNothing) {
    const TemporaryFolder folder;
    const std::string report = folder.path() / "r.json", image = folder.path() / "i.png";
    const Ran ran = run_gnomon(Arguments{"render", "--camera-position", "0,3,20", "--camera-direction",
                                         "0,0,1", "--report", report, "--image", image} +
                               small);
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.err, "gnomon: the camera sees nothing of the scene\n");
    const nlohmann::json pixels = read_json(report)["pixels"];
    EXPECT_EQ(pixels["covered"], 0);
    EXPECT_EQ(pixels["wrong_share_of_facing"], 0);
    EXPECT_EQ(read_png(image).width, 160);
}

/// A square with a triangle above it, in three formats.
struct Model {
    std::vector<std::array<float, 3>> vertices{{-2, 0, -2}, {-2, 0, 2},   {2, 0, 2},           {2, 0, -2},
                                               {-1, 1, 0},  {0.5f, 1, 1}, {0.75f, 1.5f, -0.5f}};
    std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}};

    std::string obj() const {
        std::string text;
        for (const auto& v : vertices) text += fmt::format("v {} {} {}\n", v[0], v[1], v[2]);
        for (const auto& t : triangles) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
        return text;
    }
    std::string ply() const {
        std::string text = fmt::format(
            "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float "
            "z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
            vertices.size(), triangles.size());
        for (const auto& v : vertices) text += fmt::format("{} {} {}\n", v[0], v[1], v[2]);
        for (const auto& t : triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
        return text;
    }
    std::string gltf_bytes() const {
        std::string bytes;
        const auto append = [&](const auto& values) {
            for (const auto& row : values)
                for (const auto value : row) {
                    const auto word = std::bit_cast<std::array<char, 4>>(value);
                    bytes.append(word.begin(), word.end());
                }
        };
        append(vertices);
        append(triangles);
        return bytes;
    }
    std::string gltf(const std::string& uri) const {
        const std::size_t split = vertices.size() * 12, end = split + triangles.size() * 12;
        return nlohmann::json{
            {"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0}}}}},
            {"nodes", {{{"mesh", 0}}}},
            {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}}},
            {"accessors",
             {{{"bufferView", 0},
               {"componentType", 5126},
               {"count", vertices.size()},
               {"type", "VEC3"},
               {"min", {-2, 0, -2}},
               {"max", {2, 1.5, 2}}},
              {{"bufferView", 1},
               {"componentType", 5125},
               {"count", 3 * triangles.size()},
               {"type", "SCALAR"}}}},
            {"bufferViews",
             {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", split}},
              {{"buffer", 0}, {"byteOffset", split}, {"byteLength", end - split}}}},
            {"buffers", {{{"uri", uri}, {"byteLength", end}}}}}
            .dump();
    }
};

TEST(Render, ReadsObjPlyAndGltfAlike) {
    const TemporaryFolder folder;
    const Model model;
    folder.write("m.bin", model.gltf_bytes());
    std::vector<nlohmann::json> pixels;
    std::vector<std::string> images;
    for (const auto& [name, text] : {std::pair("m.obj", model.obj()), std::pair("m.ply", model.ply()),
                                     std::pair("m.gltf", model.gltf("m.bin"))}) {
        const std::string report = folder.path() / "r.json", image = folder.path() / "i.png";
        run_well(Arguments{"render", folder.write(name, text), "--report", report, "--image", image} + small);
        const nlohmann::json json = read_json(report);
        EXPECT_EQ(json["scene"], "m");
        EXPECT_EQ(json["triangles"], 3);
        pixels.push_back(json["pixels"]);
        images.push_back(read_file(image));
        EXPECT_GT(json["pixels"]["shadowed_by_truth"], 100);
        EXPECT_EQ(pixels.back(), pixels.front()) << name;
        EXPECT_EQ(images.back(), images.front()) << name;
    }
}

TEST(Render, MendsZeroAreaTrianglesWithAWarning) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("m.obj", Model{}.obj() + "f 1 1 2\n");
    const Ran ran = run_gnomon(Arguments{"render", scene} + small);
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_THAT(ran.err, HasSubstr("zero area"));
}

TEST(Render, RefusesBadScenes) {
    const TemporaryFolder folder;
    const std::string image = folder.path() / "out.png", report = folder.path() / "out.json";
    const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 0 1\n";
    const auto refused = [&](const std::string& scene, const std::string& what) {
        expect_refused(folder, Arguments{"render", scene, "--image", image, "--report", report} + small,
                       what);
    };
    const auto file = [&](const char* name, const std::string& text) {
        return folder.write(name, text).string();
    };
    refused(folder.path() / "missing.obj", "missing.obj");
    refused(folder.path(), "folder");
    refused(file("a.txt", corners), "unknown kind");
    refused(file("noextension", corners), "unknown kind");
    refused(file("empty.obj", ""), "empty");
    refused(file("no_faces.obj", corners), "no triangles");
    refused(file("comment.obj", "# nothing\n"), "comment.obj");
    refused(file("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 0 1\nf 1 2 3\n"), "nan");
    refused(file("text.obj", "v 0 0 zero\nv 1 0 0\nv 0 0 1\nf 1 2 3\n"), "not a number");
    refused(file("huge.obj", "v 0 0 1e30\nv 1 0 0\nv 0 0 1\nf 1 2 3\n"), "1e+15");
    refused(file("flat.obj", corners + "f 1 1 2\nf 1 2 2\n"), "zero area");
    refused(file("index.obj", corners + "f 1 2 4\n"), "index.obj");
    refused(file("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\n"), "cut.ply");
    refused(file("nan.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
                            "y\nproperty float z\nelement face 1\nproperty list uchar int "
                            "vertex_indices\nend_header\n0 0 nan\n1 0 0\n0 0 1\n3 0 1 2\n"),
            "nan.ply");
    refused(file("brace.gltf", "{"), "brace.gltf");
    refused(file("object.gltf", "{}"), "object.gltf");
    refused(file("no_buffer.gltf", Model{}.gltf("absent.bin")), "no_buffer.gltf");
    refused(file("noise.glb", "not a glb"), "noise.glb");
    refused(file("noise.ply", std::string(300, '\xff')), "noise.ply");
}

TEST(Render, RefusesBadOptions) {
    const TemporaryFolder folder;
    const std::string image = folder.path() / "out.png";
    const std::vector<std::pair<Arguments, std::string>> all{
        {{"--size", "0x0"}, "--size"},
        {{"--size", "100x"}, "--size"},
        {{"--size", "x100"}, "--size"},
        {{"--size", "100"}, "--size"},
        {{"--size", "12x12x12"}, "--size"},
        {{"--size", "-5x5"}, "--size"},
        {{"--size", "99999x99999"}, "--size"},
        {{"--size", "4294967297x5"}, "--size"},
        {{"--shadow-map", "0"}, "--shadow-map"},
        {{"--shadow-map", "-5"}, "--shadow-map"},
        {{"--shadow-map", "100000"}, "--shadow-map"},
        {{"--shadow-map", "1e9"}, "--shadow-map"},
        {{"--shadow-map", "many"}, "--shadow-map"},
        {{"--fov", "0"}, "--fov"},
        {{"--fov", "180"}, "--fov"},
        {{"--fov", "nan"}, "--fov"},
        {{"--fov", "wide"}, "--fov"},
        {{"--near", "0"}, "--near"},
        {{"--far", "0"}, "--far"},
        {{"--near", "5", "--far", "1"}, "--near"},
        {{"--camera-direction", "0,0,0"}, "--camera-direction"},
        {{"--camera-direction", "a,b,c"}, "--camera-direction"},
        {{"--camera-direction", "1,2"}, "--camera-direction"},
        {{"--camera-direction", "1,2,3,4"}, "--camera-direction"},
        {{"--camera-direction", "1,nan,0"}, "--camera-direction"},
        {{"--camera-position", "inf,0,0"}, "--camera-position"},
        {{"--camera-position", ""}, "--camera-position"},
        {{"--light-direction", "0,0,0"}, "--light-direction"},
        {{"--light-position", "1,2"}, "--light-position"},
        {{"--light-position", "0,50,0", "--light-direction", "0,1,0"}, "looks away"},
        {{"--light-position", "0,50,0", "--light-fov", "180"}, "--light-fov"},
        {{"--light-fov", "60"}, "--light-position"},
        {{"--bias", "-1"}, "--bias"},
        {{"--bias", "nan"}, "--bias"},
        {{"--technique", "wrong"}, "--technique"},
        {{"--receiver", "sphere"}, "--receiver"},
        {{"--assembly", "half"}, "--assembly"},
        {{"--assembly", "scene", "--technique", "nsm"}, "numbered cases"},
        {{"--explain", "--technique", "raytraced"}, "numbered cases"},
        {{"--frames", "0"}, "--frames"},
        {{"--frames", "-1"}, "--frames"},
        {{"--colour", "red"}, "--colour"},
        {{"--report", folder.path()}, "folder"},
        {{"--report", folder.path() / "absent" / "r.json"}, "absent"},
        {{"--errors", folder.path() / "absent" / "e.png"}, "absent"},
        {{"--errors", image}, "both name"},
        {{"--report", folder.path() / "." / "out.png"}, "both name"},
        {{"--report", ""}, "--report"},
    };
    for (const auto& [options, what] : all)
        expect_refused(folder, Arguments{"render", "--image", image} + options, what);
    expect_refused(folder, {"render", "--image", folder.path() / "absent" / "i.png"}, "absent");
    expect_refused(folder, {"render", "--image", folder.path()}, "folder");
}

/// The scene's centre as a position leaves no direction to look in.
TEST(Render, RefusesToLookFromTheCentreToTheCentre) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("m.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n");
    expect_refused(folder, {"render", scene, "--camera-position", "0,0,0"}, "--camera-direction");
    expect_refused(folder, {"render", scene, "--light-position", "0,0,0"}, "--light-direction");
}

/// Cases counted elsewhere are not those of this view: some pixels need others, and get them.
TEST(Render, FallsBackWhereAnotherCensusLeftCasesOut) {
    const TemporaryFolder folder;
    const std::string shares = folder.write("shares.json", R"({"rsmss": {"23": 0.5, "31": 0.4, "1": 0.1}})");
    const std::string full = folder.path() / "full.png", other = folder.path() / "other.png";
    const Arguments view{"render",       "--technique", "rsmss",    "--size", "160x120",
                         "--shadow-map", "128",         "--frames", "1"};
    run_well(view + Arguments{"--image", full});
    const Ran ran = run_well(view + Arguments{"--image", other, "--assembly", "scene", "--census", shares});
    EXPECT_THAT(ran.out, HasSubstr("were of a case left out: found again with all cases"));
    EXPECT_EQ(read_png(full).pixels, read_png(other).pixels);
    expect_refused(
        folder,
        view + Arguments{"--assembly", "scene", "--census", folder.write("no.json", R"({"smsr": {"1": 1}})")},
        "rsmss");
    expect_refused(folder, {"render", "--technique", "nsm", "--reading", "bar=ramp"}, "bar");
    expect_refused(folder, {"render", "--technique", "raytraced", "--reading", "isolated=flipped"},
                   "asks no shadow map");
}

} // namespace
} // namespace gnomon::testing
