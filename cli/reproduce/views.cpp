#include "cli/reproduce/views.h"

namespace gnomon::cli {
namespace {

ThesisView view(const char* name, glm::vec3 position, glm::vec3 direction, bool as_printed = true) {
    // One frustum for all: near 1, far 400; 60 degrees are the vertical field of view.   [hybrid.md,
    // convention 2]
    return {
        name, {.position = position, .direction = direction, .fov = 60, .near = 1, .far = 400}, as_printed};
}

} // namespace

const std::vector<ThesisView>& thesis_views() {
    static const std::vector<ThesisView> all{
        // Table 1
        view("Bench-Side", {-23.277f, 18.541f, 30.143f}, {0.397f, -0.644774f, -0.652f}),
        view("Bench-With", {-37.034573f, 35.208973f, -8.597797f}, {0.605439f, -0.732089f, 0.312232f}),
        view("Bench-Against", {27.214222f, 27.875109f, 27.032139f}, {-0.560848f, -0.777942f, -0.283293f}),
        // Table 2
        view("Flowers-With", {-17.561422f, 24.968716f, 4.010894f}, {0.386402f, -0.873032f, 0.297505f}),
        view("Flowers-Against", {-3.263903f, 24.423452f, 12.998949f}, {-0.239566f, -0.958412f, -0.155095f}),
        // Table 3
        view("Trees-With", {42.947086f, 24.103859f, -27.831772f}, {0.415959f, -0.784187f, 0.460467f}),
        view("Trees-Against", {90.8069972f, 35.846294f, 24.138012f}, {-0.400057f, -0.835954f, 0.37568f}),
        // Table 3 prints another camera, with which nothing agrees.
        view("Trees-Side", {76.844704f, 28.391548f, -31.870102f}, {-0.232891f, -0.79644f, 0.558073f}, false),
    };
    return all;
}

Light thesis_light() { return {.direction = {0.744f, -0.408f, 0.527f}}; }

} // namespace gnomon::cli
