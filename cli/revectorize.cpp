#include "casegen/catalogue.h"
#include "casegen/csv.h"
#include "casegen/mask.h"
#include "casegen/standalone.h"
#include "cli/commands.h"
#include "cli/progress.h"
#include "cli/report.h"
#include "cli/view.h"
#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/image.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <optional>

namespace gnomon::cli {
namespace {

struct RevectorizeCommand {
    std::filesystem::path mask, samples;
    std::vector<std::filesystem::path> out;
    std::string technique = "smsr", outside = "clamp";
    std::vector<std::string> readings;
    int scale = 16;
};

struct Point {
    glm::ivec2 texel{0};
    glm::vec2 p{0};
};

/// A technique's kernels over one mask.
class KernelsOfMask {
public:
    KernelsOfMask(const std::string& name, const Readings& readings, const Common& common, const Mask& mask)
        : mask_(mask), visibility_(*find_kernel(technique_family(name), "visibility")),
          number_(find_kernel(technique_family(name), "number")), device_(common.device),
          sources_(kernel_sources(common.kernels, readings)),
          visibility_kernel_(device_.kernel(compile_standalone(visibility_, sources_), visibility_.name)) {}

    std::vector<float> visibility(std::span<const Point> points) {
        std::vector<float> result;
        for (const std::uint32_t word : run(visibility_, visibility_kernel_, points, true))
            result.push_back(std::bit_cast<float>(word));
        return result;
    }

    /// The number of the case at each point's texel; 0 for techniques that have no cases.
    std::vector<std::uint32_t> numbers(std::span<const Point> points) {
        if (!number_) return std::vector<std::uint32_t>(points.size(), 0);
        gpu::Kernel kernel = device_.kernel(compile_standalone(*number_, sources_), number_->name);
        return run(*number_, kernel, points, false);
    }

private:
    std::vector<std::uint32_t> run(const Case& c, gpu::Kernel& kernel, std::span<const Point> points,
                                   bool with_p) {
        Records records(c);
        records.reserve(points.size());
        for (const Point& point : points) {
            const std::array<std::uint32_t, 4> words{
                std::bit_cast<std::uint32_t>(point.texel.x), std::bit_cast<std::uint32_t>(point.texel.y),
                std::bit_cast<std::uint32_t>(point.p.x), std::bit_cast<std::uint32_t>(point.p.y)};
            records.add(std::span(words).first(with_p ? 4 : 2), &mask_);
        }
        Outputs outputs = run_standalone(device_, kernel, c, records);
        if (const std::string complaint = outputs.complaint(); !complaint.empty())
            throw Error("{}: {}; gnomon check {} tells more", c.name, complaint, c.name);
        return std::move(outputs.words);
    }

    const Mask& mask_;
    const Case& visibility_;
    const Case* number_;
    gpu::Device device_;
    glsl::Sources sources_;
    gpu::Kernel visibility_kernel_;
};

Image image_of(KernelsOfMask& technique, const Mask& mask, int scale) {
    const std::int64_t width = std::int64_t{mask.width} * scale, height = std::int64_t{mask.height} * scale;
    if (width > 16384 || height > 16384)
        throw Error("--scale {} makes an image of {} x {}; at most 16384 on a side", scale, width, height);
    Image image(static_cast<int>(width), static_cast<int>(height));
    Progress progress("revectorizing");
    const int rows_at_once = std::max(1, (1 << 20) / image.width);
    for (int first = 0; first < image.height; first += rows_at_once) {
        const int last = std::min(image.height, first + rows_at_once);
        std::vector<Point> points;
        for (int y = first; y < last; ++y)
            for (int x = 0; x < image.width; ++x) {
                const auto within = [&](int i) {
                    return (static_cast<float>(i % scale) + 0.5f) / static_cast<float>(scale);
                };
                points.push_back({{x / scale, y / scale}, {within(x), within(y)}});
            }
        const std::vector<float> values = technique.visibility(points);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::uint8_t grey = srgb(values[i]);
            image.pixels[image.index(0, first) + i] = {grey, grey, grey};
        }
        progress.show(static_cast<std::size_t>(last), static_cast<std::size_t>(image.height));
    }
    return image;
}

std::vector<Point> points_of(const Csv& csv) {
    const std::size_t x = csv.column("x"), y = csv.column("y"), px = csv.column("px"), py = csv.column("py");
    std::vector<Point> points;
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        const auto whole = [&](std::size_t column) {
            return std::bit_cast<int>(
                parse_word(Scalar::int32, csv.rows[row][column], csv.place(row, column)));
        };
        const auto fraction = [&](std::size_t column) {
            const float v = std::bit_cast<float>(
                parse_word(Scalar::float32, csv.rows[row][column], csv.place(row, column)));
            if (!(v >= 0 && v <= 1))
                throw Error("{} is {}; a position within the texel is 0 to 1", csv.place(row, column), v);
            return v;
        };
        points.push_back({{whole(x), whole(y)}, {fraction(px), fraction(py)}});
    }
    return points;
}

std::string table_of(KernelsOfMask& technique, const Csv& csv, std::span<const Point> points) {
    const std::vector<float> visibility = technique.visibility(points);
    const std::vector<std::uint32_t> numbers = technique.numbers(points);
    std::string text = fmt::format("{},case,visibility\n", fmt::join(csv.header, ","));
    for (std::size_t row = 0; row < points.size(); ++row)
        text += fmt::format("{},{},{}\n", fmt::join(csv.rows[row], ","), numbers[row], visibility[row]);
    return text;
}

void run(const RevectorizeCommand& options, const Common& common) {
    std::optional<std::filesystem::path> image, table;
    for (const std::filesystem::path& path : options.out) {
        std::optional<std::filesystem::path>& slot = path.extension() == ".png" ? image : table;
        if (slot)
            throw Error("--out {}: two files of one kind; one .png and one table are possible",
                        path.string());
        slot = path;
    }
    if (table && options.samples.empty())
        throw Error("--out {}: a table needs --samples IN.csv; an image's name ends in .png",
                    table->string());
    if (!image && options.samples.empty())
        throw Error("revectorize needs --out IMAGE.png, or --samples IN.csv, or both");
    const Readings readings = readings_for(options.technique, options.readings);
    Mask mask = load_mask(options.mask);
    mask.outside = parse_outside(options.outside, "--outside");
    if (readings.flip_isolated) mask = without_isolated(mask);
    Csv csv;
    std::vector<Point> points;
    if (!options.samples.empty()) {
        csv = read_csv(options.samples);
        points = points_of(csv);
    }
    for (const auto& output : {table, image})
        if (output) require_writable(*output);

    // Whatever can go wrong does so before the first file is written.
    KernelsOfMask technique(options.technique, readings, common, mask);
    Image drawn;
    if (image) drawn = image_of(technique, mask, options.scale);
    std::string text;
    if (!options.samples.empty()) text = table_of(technique, csv, points);
    require_no_validation_messages();
    if (image) write_png(*image, drawn);
    if (table)
        write_file(*table, text);
    else
        fmt::print("{}", text);
}

} // namespace

void add_revectorize(CLI::App& app, Common& common) {
    CLI::App* verb =
        app.add_subcommand("revectorize", "run a technique's assembled kernel over a shadow mask");
    auto options = std::make_shared<RevectorizeCommand>();
    verb->add_option("MASK", options->mask,
                     "PNG (dark is shadow) or text (# shadow, . lit; the first row is y = 0)")
        ->required();
    verb->add_option("--technique", options->technique, "what to run")
        ->check(CLI::IsMember(visibility_techniques()))
        ->capture_default_str();
    add_reading_option(*verb, options->readings);
    verb->add_option("--outside", options->outside, "what lies beyond the mask: clamp, lit or shadow")
        ->check(CLI::IsMember({"clamp", "lit", "shadow"}))
        ->capture_default_str();
    verb->add_option("--scale", options->scale, "pixels per texel of the image")
        ->check(CLI::Range(1, 16384))
        ->capture_default_str();
    verb->add_option(
        "--samples", options->samples,
        "CSV with columns x,y (texel) and px,py (position in it); the output adds case,visibility");
    verb->add_option("--out", options->out,
                     "IMAGE.png, or the table for --samples (default: print); may be given twice")
        ->expected(1, 2);
    verb->footer("  gnomon revectorize mask.txt --scale 32 --out edges.png\n"
                 "  gnomon revectorize mask.png --samples points.csv --out visibility.csv");
    verb->callback([options, &common] { run(*options, common); });
}

} // namespace gnomon::cli
