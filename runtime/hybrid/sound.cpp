// sheet, nearest-8 and lists: classifiers that are right wherever they are certain. [hybrid.md, sound
// classifiers]
#include "runtime/hybrid/columns.h"
#include "runtime/hybrid/make.h"

namespace gnomon {
namespace {

class Lists : public Classifier {
public:
    explicit Lists(Resources& resources)
        : r_(resources), columns_(resources), detect_(resources.kernel("hybrid/detect_lists.comp")) {}

    void create_maps() override { columns_.build(); }

    void detect(gpu::Buffer& states) override {
        r_.device.run(detect_,
                      {&columns_.space, &columns_.places, &r_.triangles, &r_.frame_buffer, &r_.receivers,
                       &states, &r_.visibility, &columns_.slots, &columns_.heads, &columns_.nodes_buffer,
                       &columns_.rings},
                      r_.per_pixel());
    }

    MapCost cost() const override {
        return {columns_.nodes(), static_cast<double>(columns_.bytes()) /
                                      (static_cast<double>(r_.frame.size.z) * r_.frame.size.z)};
    }

private:
    Resources& r_;
    Columns columns_;
    gpu::Kernel detect_;
};

class Sheet : public Classifier {
public:
    explicit Sheet(Resources& resources)
        : r_(resources), columns_(resources), detect_(resources.kernel("hybrid/detect_sheet.comp")) {}

    void create_maps() override { columns_.build(); }

    void detect(gpu::Buffer& states) override {
        r_.device.run(detect_,
                      {&columns_.space, &columns_.places, &r_.triangles, &r_.frame_buffer, &r_.receivers,
                       &states, &r_.visibility, &columns_.slots, &columns_.heads, &columns_.nodes_buffer,
                       &columns_.rings, &r_.world_texels},
                      r_.per_pixel());
    }

    MapCost cost() const override {
        return {columns_.nodes(), static_cast<double>(columns_.bytes()) /
                                      (static_cast<double>(r_.frame.size.z) * r_.frame.size.z)};
    }

private:
    Resources& r_;
    Columns columns_;
    gpu::Kernel detect_;
};

class Nearest : public Classifier {
public:
    explicit Nearest(Resources& resources)
        : r_(resources), columns_(resources), nearest_(resources.kernel("hybrid/nearest.comp")),
          detect_(resources.kernel("hybrid/detect_nearest.comp")),
          records_(resources.device.allocate(resources.pixels() * record_bytes)) {}

    void create_maps() override {
        columns_.build();
        r_.device.run(nearest_,
                      {&columns_.space, &columns_.farthest, &columns_.heads, &columns_.nodes_buffer,
                       &records_, &r_.frame_buffer},
                      r_.per_pixel());
    }

    void detect(gpu::Buffer& states) override {
        r_.device.run(detect_,
                      {&columns_.space, &columns_.places, &r_.triangles, &r_.frame_buffer, &r_.receivers,
                       &states, &r_.visibility, &columns_.slots, &columns_.heads, &columns_.nodes_buffer,
                       &columns_.rings, &records_},
                      r_.per_pixel());
    }

    MapCost cost() const override {
        return {columns_.nodes(), static_cast<double>(columns_.bytes() + records_.size()) /
                                      (static_cast<double>(r_.frame.size.z) * r_.frame.size.z)};
    }

private:
    static constexpr std::size_t record_bytes = 9 * sizeof(std::uint32_t); // hybrid/nearest.glslh
    Resources& r_;
    Columns columns_;
    gpu::Kernel nearest_, detect_;
    gpu::Buffer records_;
};

} // namespace

std::unique_ptr<Classifier> make_lists(Resources& resources) { return std::make_unique<Lists>(resources); }
std::unique_ptr<Classifier> make_sheet(Resources& resources) { return std::make_unique<Sheet>(resources); }
std::unique_ptr<Classifier> make_nearest(Resources& resources) {
    return std::make_unique<Nearest>(resources);
}

} // namespace gnomon
