#include "cli/app.h"

#include "runtime/error.h"
#include "runtime/glsl/compiler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace gnomon::cli {

std::unique_ptr<CLI::App> make_app(Common& common, int& exit_code) {
    const char* folder = std::getenv("GNOMON_KERNELS");
    common.kernels = folder ? folder : GNOMON_SOURCE_DIR "/kernels";
    auto made = std::make_unique<CLI::App>(
        "gnomon examines shadow kernels: it runs each one alone against a reference, and all of "
        "them together\n"
        "against ray-traced truth.\n\n"
        "  gnomon list                       what there is\n"
        "  gnomon check smsr/case_09         is this kernel right?\n"
        "  gnomon demo                       the whole tour, with pictures");
    CLI::App& app = *made;
    app.name("gnomon");
    app.require_subcommand(1);
    app.fallthrough();
    app.set_version_flag("--version", fmt::format("gnomon {}, {}", GNOMON_VERSION, glsl::version()));
    app.add_option("--device", common.device.name,
                   "Vulkan device, by index or part of its name (default: lavapipe)");
    app.add_option("--kernels", common.kernels, "folder with the kernels' GLSL files");
    app.add_flag("--validation", common.device.validation,
                 "turn Vulkan's validation layer on; any message is an error");
    app.add_option("--time-limit", common.device.time_limit, "seconds that one dispatch may take")
        ->check(CLI::Validator(
            [](std::string& text) {
                const double limit = std::strtod(text.c_str(), nullptr);
                return limit >= 0.001 && limit <= 1e6 ? "" : text + " is not between 0.001 and 1000000";
            },
            "SECONDS"))
        ->capture_default_str();

    app.parse_complete_callback([&app, &common] {
        gpu::prepare_process(common.device.name.empty() && !app.got_subcommand("devices"));
    });

    add_list(app, common);
    add_describe(app, common);
    add_witnesses(app, common);
    add_check(app, common, exit_code);
    add_eval(app, common, exit_code);
    add_capture(app, common, exit_code);
    add_revectorize(app, common);
    add_render(app, common);
    add_census(app, common, exit_code);
    add_atlas(app, common, exit_code);
    add_bench(app, common, exit_code);
    add_worst(app, common, exit_code);
    add_coverage(app, common, exit_code);
    add_fuzz(app, common, exit_code);
    add_mutate(app, common, exit_code);
    add_watch(app, common, exit_code);
    add_compare(app, common, exit_code);
    add_reproduce(app, common);
    add_demo(app, common, exit_code);
    add_devices(app, common);
    return made;
}

void require_verb(const CLI::App& app, const std::string& word) {
    if (word.starts_with('-')) return;
    const std::vector<const CLI::App*> verbs = app.get_subcommands([](const CLI::App*) { return true; });
    std::string names;
    for (const CLI::App* verb : verbs) {
        if (verb->get_name() == word) return;
        names += " " + verb->get_name();
    }
    throw Error("no verb \"{}\"; there are:{}", word, names);
}

} // namespace gnomon::cli
