// One view of the thesis, counted as it counted.
#pragma once

#include "cli/reproduce/counts.h"
#include "cli/reproduce/views.h"
#include "runtime/glsl/compiler.h"
#include "runtime/gpu/device.h"
#include "runtime/scene.h"

#include <span>

namespace gnomon::cli {

/// The techniques that the thesis counts, in its order, and variants that it does not print.
std::span<const char* const> counted_hybrids();

/// Adds to `counts` what the truth, normal shadow mapping and the hybrid techniques say of one view at one
/// image size and the given shadow map sizes, under the conventions of as_published.
void count_view(gpu::Device& device, const glsl::Sources& sources, const Scene& scene, const ThesisView& view,
                int width, int height, std::span<const int> maps, Counts& counts);

} // namespace gnomon::cli
