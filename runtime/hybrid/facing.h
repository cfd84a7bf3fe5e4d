// Whether a frame has anything that a shadow could fall on.
#pragma once

#include "runtime/pipeline/resources.h"

namespace gnomon {

class FacingTest {
public:
    /// `resources` must outlive it.
    explicit FacingTest(Resources& resources);

    /// True if any of the frame's pixels faces the light. One dispatch, which over most frames looks at a few
    /// pixels.
    bool any();

private:
    Resources& r_;
    gpu::Kernel kernel_;
    gpu::Buffer found_;
};

} // namespace gnomon
