// Calls that stages record: which are kept, in which order, and how many there is room for.
#include "runtime/pipeline/recording.h"

#include "tests/support/device.h"
#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace gnomon::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(RecordedCalls, AreSortedAndEachIsThereOnce) {
    // Stage, y, x, number, tag, count, words.
    const std::vector<std::uint32_t> words{1, 0, 5, 0, 7, 1, 42,    //
                                           0, 2, 0, 0, 7, 2, 1,  9, //
                                           1, 0, 5, 0, 7, 1, 42,    // the same again
                                           0, 1, 9, 0, 7, 0,        //
                                           1, 0, 5, 0, 7, 1, 41};
    EXPECT_THAT(read_calls(words),
                ElementsAre(RecordedCall{0, 1, 9, 0, 7, {}}, RecordedCall{0, 2, 0, 0, 7, {1, 9}},
                            RecordedCall{1, 0, 5, 0, 7, {41}}, RecordedCall{1, 0, 5, 0, 7, {42}}));
    EXPECT_THAT(read_calls({}), ElementsAre());
}

/// A stage whose invocations are pixels.
class Stage {
public:
    explicit Stage(const std::string& body) {
        glsl::Sources sources{kernels_folder(), {}};
        sources.generated["record/stage"] =
            "const uint RECORD_STAGE = 3u;\nconst bool RECORD_PIXELS = true;\n"
            "uvec2 record_invocation() { return gl_GlobalInvocationID.xy; }\n";
        const std::string text =
            "#include \"pipeline/record.glslh\"\nlayout(local_size_x = 8) in;\nvoid main() {\n" + body +
            "}\n";
        kernel_ = shared_device().kernel(glsl::compile(sources, text, "recording", glsl::Stage::compute),
                                         "recording");
    }
    std::vector<RecordedCall> record(std::uint32_t threads, std::vector<std::uint32_t> pixels = {}) {
        return record_calls(shared_device(), 64, 2, pixels, [&] {
            ++frames;
            shared_device().run(kernel_, {}, {.threads = {threads, 1, 1}});
        });
    }
    int frames = 0;

private:
    gpu::Kernel kernel_;
};

TEST(RecordedCalls, OfAllThreadsAndOfMarkedPixelsAlone) {
    Stage stage("    for (uint i = 0u; i < 2u; ++i)\n        if (record_call(5u, 1u)) record(10u * "
                "record_invocation().x + i);\n");
    const std::vector<RecordedCall> all = stage.record(64);
    ASSERT_EQ(all.size(), 128u);
    EXPECT_EQ(all[7], (RecordedCall{3, 0, 3, 1, 5, {31}}));
    EXPECT_EQ(stage.frames, 2); // the first says how much room is needed
    EXPECT_THAT(stage.record(64, {40, 3}),
                ElementsAre(RecordedCall{3, 0, 3, 0, 5, {30}}, RecordedCall{3, 0, 3, 1, 5, {31}},
                            RecordedCall{3, 0, 40, 0, 5, {400}}, RecordedCall{3, 0, 40, 1, 5, {401}}));
    EXPECT_THROW(stage.record(64, {128}), std::out_of_range);
    EXPECT_EQ(stage.record(64).size(), 128u); // nothing is left of that
}

TEST(RecordedCalls, ThatAreTooManyAreRefused) {
    // No word is written without room for all of a call; the count alone grows.
    for (const char* words : {"0x0fffffffu", "0xfffffff0u"}) { // more than may be; more than a word counts
        Stage stage("    if (record_call(5u, " + std::string(words) + ")) record(1u);\n");
        EXPECT_THAT(error_of([&] { stage.record(8); }),
                    HasSubstr("words that can be recorded; take fewer pixels"))
            << words;
    }
}

} // namespace
} // namespace gnomon::testing
