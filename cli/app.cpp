#include "cli/app.h"

#include "cli/parse.h"
#include "runtime/error.h"
#include "runtime/glsl/compiler.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace gnomon::cli {

namespace {

struct Verb {
    std::string_view name;
    void (*add)(CLI::App& app, Common& common, int& exit_code);
};

template <void (*add)(CLI::App& app, Common& common)>
void without_exit_code(CLI::App& app, Common& common, int&) {
    add(app, common);
}

constexpr Verb verbs[] = {
    {"list", without_exit_code<add_list>},
    {"describe", without_exit_code<add_describe>},
    {"witnesses", without_exit_code<add_witnesses>},
    {"check", add_check},
    {"eval", add_eval},
    {"capture", add_capture},
    {"revectorize", without_exit_code<add_revectorize>},
    {"render", without_exit_code<add_render>},
    {"census", add_census},
    {"atlas", add_atlas},
    {"bench", add_bench},
    {"worst", add_worst},
    {"coverage", add_coverage},
    {"fuzz", add_fuzz},
    {"mutate", add_mutate},
    {"watch", add_watch},
    {"compare", add_compare},
    {"reproduce", without_exit_code<add_reproduce>},
    {"demo", add_demo},
    {"devices", without_exit_code<add_devices>},
};

} // namespace

std::unique_ptr<CLI::App> make_app(Common& common, int& exit_code, std::string_view first) {
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
        ->check(number_from(0.001, 1e6))
        ->capture_default_str();

    app.parse_complete_callback([&app, &common] {
        const bool lists_devices = std::ranges::any_of(
            app.get_subcommands(), [](const CLI::App* verb) { return verb->get_name() == "devices"; });
        gpu::prepare_process(common.device.name.empty() && !lists_devices);
    });

    const bool is_verb = std::ranges::find(verbs, first, &Verb::name) != std::end(verbs);
    for (const Verb& verb : verbs)
        if (!is_verb || verb.name == first) verb.add(app, common, exit_code);
    return made;
}

void require_verb(const std::string& word) {
    if (word.starts_with('-')) return;
    std::string names;
    for (const Verb& verb : verbs) {
        if (verb.name == word) return;
        names += fmt::format(" {}", verb.name);
    }
    throw Error("no verb \"{}\"; there are:{}", word, names);
}

} // namespace gnomon::cli
