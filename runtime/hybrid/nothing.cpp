#include "runtime/hybrid/make.h"

namespace gnomon {
namespace {

class Nothing : public Classifier {
public:
    explicit Nothing(Resources& resources)
        : resources_(resources), kernel_(resources.kernel("hybrid/detect_nothing.comp")) {}
    void create_maps() override {}
    bool has_maps() const override { return false; }
    void detect(gpu::Buffer& states) override {
        Resources& r = resources_;
        r.device.run(kernel_, {&r.frame_buffer, &r.receivers, &states, &r.visibility}, r.per_pixel());
    }

private:
    Resources& resources_;
    gpu::Kernel kernel_;
};

} // namespace

std::unique_ptr<Classifier> make_nothing(Resources& resources) {
    return std::make_unique<Nothing>(resources);
}

} // namespace gnomon
