// What a frame's kernels are called with, captured, gives the same bits alone: every kernel of every
// technique's chain, and of every numbered case the pixel's visibility.
#include "casegen/capture.h"

#include "casegen/csv.h"
#include "casegen/demo_scene.h"
#include "casegen/standalone.h"
#include "casegen/technique.h"
#include "runtime/error.h"
#include "runtime/files.h"
#include "tests/pipeline/view.h"
#include "tests/support/broken_kernels.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <set>

namespace gnomon::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Pixels = std::vector<std::uint32_t>;

const Scene& scene() {
    static const Scene demo = demo_scene();
    return demo;
}

Pixels every(std::size_t step, const Pixels& pixels) {
    Pixels kept;
    for (std::size_t i = 0; i < pixels.size(); i += step) kept.push_back(pixels[i]);
    return kept;
}

std::vector<std::uint32_t> answers(const Captured& captured) {
    std::vector<std::uint32_t> words;
    for (const CapturedCall& call : captured.calls)
        words.insert(words.end(), call.result.begin(), call.result.end());
    return words;
}

/// The same calls alone, from the file that capture writes.
std::vector<std::size_t> differing_alone(const Captured& captured, int width, const glsl::Sources& sources) {
    const Case& c = *captured.kernel;
    const std::vector<CsvInput> inputs =
        read_inputs(c, parse_csv(captured_csv(captured, width, "a\nb"), c.name));
    EXPECT_EQ(inputs.size(), captured.calls.size());
    Records records(c);
    for (const CsvInput& input : inputs) records.add(input.words, &input.mask);
    const Outputs outputs = evaluate(shared_device(), sources, c, records);
    EXPECT_EQ(outputs.complaint(), "") << c.name;
    return differing_rows(c, answers(captured), outputs.words);
}

void expect_same_alone(const Captured& captured, int width) {
    if (captured.calls.empty()) return;
    EXPECT_THAT(differing_alone(captured, width, kernel_sources(kernels_folder())), IsEmpty())
        << captured.kernel->name << ", of " << captured.calls.size();
}

/// By technique, the numbers of the cases that were captured.
using Met = std::map<std::string, std::set<unsigned>>;

void expect_cases(Renderer& renderer, const View& view, const std::string& name, Met& met) {
    const Family& family = technique_family(name);
    const Technique technique = technique_of(family);
    const glsl::Sources sources = kernel_sources(kernels_folder());
    const Pixels pixels = every(3, asked_pixels(renderer));
    const std::vector<std::uint32_t> numbers = case_numbers(renderer, technique, pixels);
    std::map<std::uint32_t, std::uint32_t> number_of;
    for (std::size_t i = 0; i < pixels.size(); ++i) number_of[pixels[i]] = numbers[i];
    for (Captured& captured :
         capture_calls(renderer, sources, technique, Question::visibility, numbered_cases(family), pixels)) {
        EXPECT_THAT(captured.unlike_frame, IsEmpty()) << captured.kernel->name;
        const unsigned number = captured.kernel->number;
        std::size_t own = 0;
        for (const CapturedCall& call : captured.calls) {
            if (number_of.at(call.pixel.value()) != number) continue; // called by another case
            ++own;
            ASSERT_EQ(call.result.front(), std::bit_cast<std::uint32_t>(call.visibility))
                << captured.kernel->name << " at pixel " << *call.pixel;
        }
        EXPECT_EQ(own, static_cast<std::size_t>(std::ranges::count(numbers, number)))
            << captured.kernel->name;
        if (own > 0) met[name].insert(number);
        expect_same_alone(captured, view.settings.width);
    }
}

/// `alone`: kernels that were compared with themselves alone already; they are not again.
void expect_chain(Renderer& renderer, const View& view, const std::string& name,
                  std::set<std::string>& alone) {
    const Technique technique = technique_of(technique_family(name));
    const glsl::Sources sources = kernel_sources(kernels_folder());
    const Pixels all = asked_pixels(renderer);
    const Pixels pixels = every(all.size() / 150, all);
    for (const Question question : {Question::visibility, Question::number}) {
        std::vector<const Case*> kernels;
        for (const ChainLink& link : chain_of(sources, technique))
            if (link.question == question && link.kernel->number == 0) kernels.push_back(link.kernel);
        if (kernels.empty()) continue;
        for (const Captured& captured :
             capture_calls(renderer, sources, technique, question, kernels, pixels)) {
            const std::string& kernel = captured.kernel->name;
            EXPECT_THAT(captured.unlike_frame, IsEmpty()) << kernel;
            if (!captured.calls.empty() && alone.insert(kernel).second)
                expect_same_alone(captured, view.settings.width);
            if (!kernel.ends_with("/visibility")) continue;
            ASSERT_EQ(captured.calls.size(), pixels.size()) << kernel;
            for (const CapturedCall& call : captured.calls)
                ASSERT_EQ(call.result.front(), std::bit_cast<std::uint32_t>(call.visibility)) << kernel;
        }
    }
}

TEST(CapturedCalls, OfEveryCaseGiveThePixelsVisibilityAndTheSameAlone) {
    Met met;
    for (const View& view : {demo_view(320, 240, 256), demo_view_with_lamp(320, 240, 256)}) {
        const auto renderer = make_renderer(scene(), view);
        for (const std::string& name : numbered_techniques()) expect_cases(*renderer, view, name, met);
    }
    for (const std::string& name : numbered_techniques())
        for (const Case* c : numbered_cases(technique_family(name)))
            EXPECT_TRUE(met[name].contains(c->number)) << "no pixel is of " << c->name;
}

TEST(CapturedCalls, OfEveryOtherKernelGiveTheSameAlone) {
    const View sun = demo_view(160, 120, 128), lamp = demo_view_with_lamp(160, 120, 128);
    const auto in_sun = make_renderer(scene(), sun);
    std::set<std::string> in_sun_alone, in_lamp_alone;
    for (const std::string& name : visibility_techniques()) expect_chain(*in_sun, sun, name, in_sun_alone);
    expect_chain(*make_renderer(scene(), lamp), lamp, "rsmss", in_lamp_alone); // it calls most of them
    for (const char* kernel : {"revectorize/shadow_test", "revectorize/breach", "revectorize/neighbours",
                               "rsmss/with_options", "nsm/visibility"})
        EXPECT_TRUE(in_sun_alone.contains(kernel)) << kernel;
}

TEST(CapturedCalls, OfAHybridsStagesGiveTheSameAlone) {
    const View view = demo_view(120, 90, 96);
    const auto renderer = make_renderer(scene(), view);
    const glsl::Sources sources = kernel_sources(kernels_folder());
    std::map<std::string, std::set<std::string>> stages; // by kernel, those that called it
    for (const HybridTechnique& known : hybrid_techniques()) {
        if (known.name == "crsma" && !shared_device().has_geometry_shaders()) continue;
        const Technique technique = hybrid(known.name);
        for (const Captured& captured : capture_frame_calls(*renderer, sources, technique,
                                                            kernels_of(renderer->stages(technique)), {})) {
            EXPECT_THAT(captured.unlike_frame, IsEmpty()) << captured.kernel->name;
            std::set<std::string>& known_stages = stages[captured.kernel->name];
            const std::size_t before = known_stages.size();
            for (const CapturedCall& call : captured.calls) known_stages.insert(captured.stages[call.stage]);
            if (known_stages.size() > before) expect_same_alone(captured, view.settings.width);
        }
    }
    // Of every kind of stage, and all kernels but column/hit and those that other kernels' texts hold.
    const std::map<std::string, std::string> some{
        {"certainty/beister", "hybrid/detect_beister.comp"},
        {"certainty/bilinear", "hybrid/detect_beister.comp"},
        {"certainty/crsm", "hybrid/detect_crsm.comp"},
        {"column/overlaps", "hybrid/bin.comp"},
        {"column/depth_bounds", "hybrid/fill_lists.comp"},
        {"column/touches", "hybrid/detect_sheet.comp"},
        {"column/opposite", "hybrid/detect_sheet.comp"},
        {"column/plane", "hybrid/detect_sheet.comp"},
        {"column/coverage", "hybrid/detect_lists.comp"},
        {"column/height", "hybrid/detect_nearest.comp"},
        {"conservative/dilated", "hybrid/dilated.vert"},
        {"conservative/clip_box", "hybrid/dilated.vert"},
        {"conservative/in_clip_box", "hybrid/dilated.frag"},
        {"conservative/eroded", "hybrid/eroded.vert"},
        {"conservative/erodes_as_published", "hybrid/one_ring.vert"},
        {"conservative/depth_at", "hybrid/eroded.vert"},
        {"adjacency/one_ring", "hybrid/one_ring.vert"},
        {"adjacency/away", "hybrid/count_adjacent.comp"}};
    for (const auto& [kernel, stage] : some)
        EXPECT_THAT(stages[kernel], ::testing::Contains(stage)) << kernel;
}

TEST(CapturedCalls, OfAHybridAtAPixelAreThatPixelsAlone) {
    const View view = demo_view(64, 48, 64);
    const auto renderer = make_renderer(scene(), view);
    const glsl::Sources sources = kernel_sources(kernels_folder());
    const auto captured = [&](const Pixels& pixels, std::size_t most = 0) {
        return capture_frame_calls(*renderer, sources, hybrid("crsm"),
                                   {&find_case("certainty/crsm"), &find_case("conservative/eroded")}, pixels,
                                   most);
    };
    const std::vector<Captured> all = captured({});
    ASSERT_GT(all[0].calls.size(), 100u);
    EXPECT_EQ(all[1].calls.size(), 3 * scene().triangles.size());
    EXPECT_FALSE(all[1].calls[0].pixel);
    const CapturedCall &one = all[0].calls[17], &other = all[0].calls[90];
    const std::vector<Captured> two = captured({*other.pixel, *one.pixel});
    EXPECT_THAT(two[1].calls, IsEmpty()); // a vertex is no pixel's
    ASSERT_EQ(two[0].calls.size(), 2u);
    EXPECT_EQ(two[0].calls[0].inputs, one.inputs);
    EXPECT_EQ(two[0].calls[1].inputs, other.inputs);
    const std::vector<Captured> few = captured({}, 3);
    EXPECT_EQ(few[0].all, all[0].calls.size());
    ASSERT_EQ(few[0].calls.size(), 3u);
    EXPECT_EQ(few[0].calls[2].pixel, all[0].calls[2 * all[0].calls.size() / 3].pixel);
}

TEST(CapturedCalls, KnowWhichKernelsATechniqueCalls) {
    const auto names = [](const std::string& technique) {
        std::vector<std::string> all;
        for (const ChainLink& link :
             chain_of(kernel_sources(kernels_folder()), technique_of(technique_family(technique))))
            all.push_back((link.question == Question::number ? "number: " : "") + link.kernel->name);
        return all;
    };
    EXPECT_THAT(names("nsm"), ElementsAre("revectorize/shadow_test", "nsm/visibility"));
    const std::vector<std::string> smsr = names("smsr");
    for (const char* kernel : {"revectorize/walk", "smsr/decision", "smsr/case_12", "number: smsr/number"})
        EXPECT_THAT(smsr, ::testing::Contains(kernel));
    EXPECT_THAT(smsr, ::testing::Not(::testing::Contains("rsmss/case_01")));
}

TEST(CapturedCalls, AreMoreThanOneWhereAKernelIsCalledOften) {
    const View view = demo_view(64, 48, 64);
    const auto renderer = make_renderer(scene(), view);
    const glsl::Sources sources = kernel_sources(kernels_folder());
    const Technique technique = technique_of(technique_family("rsmss"));
    const Pixels pixels = asked_pixels(*renderer);
    const Captured captured = capture_calls(*renderer, sources, technique, Question::visibility,
                                            {&find_case("revectorize/walk")}, pixels)
                                  .front();
    EXPECT_EQ(captured.calls.size(), 4 * pixels.size());
}

TEST(CapturedCalls, OfAKernelThatIsNoFunctionOfItsParametersAreNoticed) {
    const ChangedKernels kernels("smsr/case_09.glsl", "return 1.0 - p.y",
                                 "if (gl_GlobalInvocationID.y > 3u) return 0.25;\n    return 1.0 - p.y");
    const View view = demo_view(160, 120, 128);
    const glsl::Sources sources = kernel_sources(kernels.folder());
    Renderer renderer(shared_device(), sources, scene(), view.camera, view.light, view.settings);
    const Captured captured =
        capture_calls(renderer, sources, technique_of(technique_family("smsr")), Question::visibility,
                      {&find_case("smsr/case_09")}, asked_pixels(renderer))
            .front();
    EXPECT_GT(captured.unlike_frame.size(), 10u);
}

TEST(CapturedCalls, OfAnotherKernelThanTheOneAloneAreNoticed) {
    const View view = demo_view(160, 120, 128);
    const auto renderer = make_renderer(scene(), view);
    glsl::Sources sources = kernel_sources(kernels_folder());
    const Technique technique = technique_of(technique_family("rsmss"));
    const Case& c = find_case("rsmss/case_22");
    const Captured captured =
        capture_calls(*renderer, sources, technique, Question::visibility, {&c}, asked_pixels(*renderer))
            .front();
    ASSERT_GT(captured.calls.size(), 20u);
    EXPECT_THAT(differing_alone(captured, view.settings.width, sources), IsEmpty());
    std::string text = read_file(kernels_folder() / "rsmss/case_22.glsl");
    const std::size_t at = text.find("2.0 - p.y");
    ASSERT_NE(at, text.npos);
    sources.overlaid["rsmss/case_22.glsl"] = text.replace(at, 3, "2.0000005");
    const std::size_t differing = differing_alone(captured, view.settings.width, sources).size();
    EXPECT_GT(differing, 0u);
    EXPECT_LT(differing, captured.calls.size()); // those that are cut off at 0 and 1 are the same
}

TEST(DifferingRows, AreToldBitForBitWithEveryNanAlike) {
    const auto words = [](std::vector<float> values) {
        std::vector<std::uint32_t> bits;
        for (const float value : values) bits.push_back(std::bit_cast<std::uint32_t>(value));
        return bits;
    };
    const Case& scalar = find_case("smsr/case_09");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(differing_rows(scalar, words({0, 1, nan, 0, nan}), words({0, 1, -nan, -0.0f, 1})),
                ElementsAre(3, 4));
    const Case& whole = find_case("revectorize/discontinuity");
    const std::vector<std::uint32_t> pairs{1, 2, 3, 0, 1, 1}, others{1, 2, 0, 3, 1, 2};
    EXPECT_THAT(differing_rows(whole, pairs, others), ElementsAre(1, 2));
    const std::vector<std::uint32_t> nans{0x7fc00000u, 0}, integers{0x7fc00001u, 0};
    EXPECT_THAT(differing_rows(whole, nans, integers), ElementsAre(0)); // of integers no word is a NaN
}

TEST(CapturedCsv, HasTheKernelsColumnsThenThePixelItsAnswerAndItsVisibility) {
    Captured captured;
    captured.kernel = &find_case("revectorize/discontinuity");
    CapturedCall call;
    call.pixel = 23;
    call.inputs = {18, 18};
    call.result = {1, 2};
    call.visibility = 0.5f;
    auto mask = std::make_shared<Mask>(2, 2);
    mask->set(1, 0, false);
    call.window = mask;
    captured.calls = {call, call};
    EXPECT_EQ(captured_csv(captured, 10, "one\ntwo"),
              "# one\n# two\n"
              "mask,outside,texel_x,texel_y,pixel_x,pixel_y,captured_x,captured_y,visibility\n"
              ".#/..,clamp,18,18,3,2,1,2,0x1p-1\n"
              ".#/..,clamp,18,18,3,2,1,2,0x1p-1\n");
}

TEST(CapturedCsv, OfAHybridSaysTheStageAndItsInvocation) {
    Captured captured;
    captured.kernel = &find_case("certainty/crsm");
    captured.stages = {"hybrid/eroded.vert", "hybrid/detect_crsm.comp"};
    CapturedCall call;
    call.inputs.assign(9, 1);
    call.result = {2};
    call.invocation = {4, 5};
    captured.calls = {call, call};
    captured.calls[1].stage = 1;
    captured.calls[1].pixel = 23;
    const Csv csv = parse_csv(captured_csv(captured, 10, "one"), "captured");
    const std::vector<std::string> tail(csv.header.end() - 7, csv.header.end());
    EXPECT_THAT(tail, ElementsAre("pixel_x", "pixel_y", "captured", "visibility", "stage", "invocation_x",
                                  "invocation_y"));
    EXPECT_THAT(std::vector(csv.rows[0].end() - 7, csv.rows[0].end()),
                ElementsAre("", "", "2", "", "hybrid/eroded.vert", "4", "5"));
    EXPECT_THAT(std::vector(csv.rows[1].end() - 7, csv.rows[1].end()),
                ElementsAre("3", "2", "2", "0x0p+0", "hybrid/detect_crsm.comp", "4", "5"));
    EXPECT_EQ(read_inputs(*captured.kernel, csv).size(), 2u);
}

TEST(CapturedCsv, AddsNoColumnThatAKernelHas) {
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            for (const std::string& column : columns(c))
                for (const char* added : {"pixel_x", "pixel_y", "captured", "visibility", "stage",
                                          "invocation_x", "invocation_y"})
                    EXPECT_NE(column, added) << c.name;
}

} // namespace
} // namespace gnomon::testing
