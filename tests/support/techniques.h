// What each technique makes of a mask, in double precision: by the references.
#pragma once

#include "casegen/reference/mask_space.h"
#include "casegen/reference/rbsm.h"
#include "casegen/reference/rsmss.h"

namespace gnomon::testing {

struct ReferenceTechnique {
    const char* name;
    double (*visibility)(const Mask& mask, glm::ivec2 texel, glm::dvec2 p);
};

inline double by_edge(double (*function)(const reference::Edge&, glm::dvec2), const Mask& mask,
                      glm::ivec2 texel, glm::dvec2 p) {
    const reference::Edge edge = reference::edge(mask, texel);
    return edge.sides == glm::uvec2(0) ? (edge.lit ? 1 : 0) : function(edge, p);
}

inline const ReferenceTechnique hard_test{
    "nsm", [](const Mask& mask, glm::ivec2 t, glm::dvec2) { return mask.lit(t.x, t.y) ? 1.0 : 0.0; }};
inline const ReferenceTechnique smsr{"smsr", reference::smsr_visibility_in_mask_space};
inline const ReferenceTechnique rbsm_silhouette{
    "rbsm-silhouette", [](const Mask& mask, glm::ivec2 t, glm::dvec2 p) {
        return mask.lit(t.x, t.y) ? by_edge(reference::rbsm_silhouette, mask, t, p) : 0;
    }};
inline const ReferenceTechnique rsmss{"rsmss", [](const Mask& mask, glm::ivec2 t, glm::dvec2 p) {
                                          return reference::rsmss_visibility_in_mask_space(mask, t, p, 0);
                                      }};
inline const ReferenceTechnique rbsm_filter{
    "rbsm-filter", [](const Mask& mask, glm::ivec2 t, glm::dvec2 p) {
        return by_edge([](const reference::Edge& e, glm::dvec2 q) { return reference::rbsm_filter(e, q); },
                       mask, t, p);
    }};

} // namespace gnomon::testing
