#include "casegen/atlas/html.h"

#include "casegen/atlas/page.h"
#include "runtime/image.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace gnomon::atlas {
namespace {

TEST(escape_html, leaves_nothing_that_means_something) {
    EXPECT_EQ(escape_html("a < b && \"c\" > d"), "a &lt; b &amp;&amp; &quot;c&quot; &gt; d");
    EXPECT_EQ(escape_html("q − é\n\t"), "q − é\n\t");
    EXPECT_EQ(escape_html(std::string_view("\0\x1b", 2)), "??");
}

TEST(base64, of_rfc_4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string_view("\xff\xfb\xf0\x00", 4)), "//vwAA==");
}

TEST(data_uri, holds_the_png_that_would_be_a_file) {
    Image image(3, 2, {10, 20, 30});
    image.at(2, 1) = {255, 0, 0};
    const gnomon::testing::TemporaryFolder folder;
    const Image back = read_png(folder.write("image.png", encode_png(image)));
    EXPECT_EQ(back.pixels, image.pixels);
    EXPECT_EQ(data_uri(image), "data:image/png;base64," + base64(encode_png(image)));
    EXPECT_FALSE(gnomon::testing::error_of([] { encode_png(Image()); }).empty());
}

TEST(glsl_to_html, colours_and_escapes) {
    EXPECT_EQ(glsl_to_html("// a < b\nfloat f(vec2 p) {\n    return p.x < 1.0 ? 0u : g2;\n}\n"),
              "<span class=\"c\">// a &lt; b</span>\n<span class=\"k\">float</span> f(<span "
              "class=\"k\">vec2</span> p) {\n    <span class=\"k\">return</span> p.x &lt; <span "
              "class=\"n\">1.0</span> ? <span class=\"n\">0u</span> : g2;\n}\n");
    EXPECT_EQ(
        glsl_to_html("#include <smsr/cases>\na # b /* c\n*/ d /* e"),
        "<span class=\"d\">#include &lt;smsr/cases&gt;</span>\na # b <span class=\"c\">/* c\n*/</span> d "
        "<span class=\"c\">/* e</span>");
}

TEST(page_links, lead_to_the_kernels_of_the_same_repository_only) {
    const testing::TemporaryFolder folder;
    for (const char* name : {"repository/kernels", "repository/out/atlas", "elsewhere"})
        std::filesystem::create_directories(folder.path() / name);
    const auto link = [&](const char* from) {
        return atlas::link_to_kernels(folder.path() / from, folder.path() / "repository/kernels");
    };
    EXPECT_EQ(link("repository/out/atlas"), "../../kernels");
    EXPECT_EQ(link("repository"), "kernels");
    EXPECT_EQ(link("elsewhere"), "");
}

} // namespace
} // namespace gnomon::atlas
