// How a pixel's visibility is found, and the shaders that ask a technique's kernels.
#pragma once

#include "runtime/glsl/compiler.h"

#include <map>
#include <string>

namespace gnomon {

struct Technique {
    enum class Kind {
        none,      ///< everything that faces the light is lit
        kernel,    ///< by the kernel `family`/visibility over the shadow map
        raytraced, ///< by a shadow ray: the truth
        hybrid,    ///< by maps where they are certain, by rays elsewhere (runtime/hybrid)
        automatic, ///< by the exact hybrid that calibration finds fastest (runtime/hybrid/choice.h)
    };
    Kind kind = Kind::none;
    std::string name;
    std::string family{}; ///< the folder of its kernels; empty: the name
    /// Texts that kernels include by <>, before those of the renderer's sources: an assembly that leaves
    /// cases out.
    std::map<std::string, std::string> generated{};
    /// A frame in which a pixel's case was left out is found again with the renderer's own sources. Without
    /// it such pixels are lit, which is wrong: for tests that this matters.
    bool falls_back = true;
    /// A hybrid leaves out what a frame does not need. The image is the same without: for tests.
    bool prune = true;
};

/// The sources with the technique's own before them, and <technique>:
///     float technique_visibility(ivec2 texel, vec2 p)
/// or, for a census, uint technique_number(ivec2 texel).
glsl::Sources visibility_sources(const glsl::Sources& sources, const Technique& technique);
glsl::Sources number_sources(const glsl::Sources& sources, const Technique& technique);

/// What a technique is asked: float visibility, or the number of the case.
enum class Question { visibility, number };

/// The same for either question, and <technique> also has its answer's bits:
///     uint technique_answer(ivec2 texel, vec2 p)
glsl::Sources answer_sources(const glsl::Sources& sources, const Technique& technique, Question question);

/// A stage by its file below the kernels' folder, "hybrid/fill.comp"; a bare name is below pipeline/.
std::string stage_text(const glsl::Sources& sources, const std::string& file);
std::string stage_name(const glsl::Sources& sources, const std::string& file);

} // namespace gnomon
