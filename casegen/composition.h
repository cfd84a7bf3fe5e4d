// A family's visibility taken apart: every kernel that it is made of, each alone on what those before it
// gave. The assembled kernel must give the same bits.
#pragma once

#include "casegen/catalogue.h"
#include "casegen/standalone.h"

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

/// A point in a texel of a mask.
struct TexelPoint {
    const Mask* mask = nullptr;
    glm::ivec2 texel{0};
    glm::vec2 p{0};
};

/// The result words of a kernel over records.
using RunKernel = std::function<std::vector<std::uint32_t>(const Case&, const Records&)>;

/// The family's kernel `name` (number, visibility), which takes a texel and maybe a point in it.
std::vector<std::uint32_t> run_assembled(const Case& kernel, std::span<const TexelPoint> points,
                                         const RunKernel& run);

/// All that the kernels of revectorize say of some points, and what families make of it.
class Composition {
public:
    using Words = std::vector<std::uint32_t>;

    /// Runs the parts that all families share, in the order in which each needs the one before. The points'
    /// masks must outlive it.
    Composition(std::span<const TexelPoint> points, RunKernel run);

    /// Per point; of a family with numbered cases.
    struct Composed {
        Words numbers;    ///< of the texel's case; 0: none
        Words visibility; ///< the case on the facts it takes; the shadow test of a texel of no case
    };
    Composed compose(const Family& family);

private:
    Words run(const Case& kernel, std::span<const std::size_t> which,
              const std::map<std::string, std::string>& renamed = {}) const;
    Words run(const char* kernel, const std::map<std::string, std::string>& renamed = {}) const;
    Words component(const std::string& fact, std::size_t stride, std::size_t first, std::size_t count) const;
    Words interleaved(const Words& x, const Words& y) const;
    /// Positions along the runs as the family takes them where a run ends nowhere, or twice.
    void set_positions(const Family& family);
    void set_walls();

    std::vector<TexelPoint> points_;
    std::vector<std::size_t> all_; ///< 0, 1, …
    RunKernel run_;
    std::map<std::string, Words> facts_; ///< by a parameter's name; as many components per point
    Words along_x_, along_y_;            ///< revectorize/along, whatever the runs' types
};

} // namespace gnomon
